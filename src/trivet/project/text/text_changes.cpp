// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

using Keys = std::vector<std::string>;

/// Of two numbers in different units: fifteen digits are written.
constexpr double same_number = 1e-14;

/// The number that a node is, if its unit is one.
std::optional<WrittenNumber> number_in(const Node& node) {
  auto number = written_number(node);
  return number && is_known_unit(number->unit) ? number : std::nullopt;
}

constexpr int digits_after_conversion = 15;  // between units; it loses the others
std::string number_text(double value, bool converted) {
  return converted ? fmt::format("{:.{}g}", value, digits_after_conversion) : fmt::format("{}", value);
}

std::string dotted(const Keys& keys) {
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ".") + foundation::path_key(key);
  return text;
}

/// True if names of keys are those of the path from `at` on, as far as both go.
bool matches(const std::vector<WrittenKey>& keys, const Keys& path, std::size_t at) {
  const std::size_t common = std::min(keys.size(), path.size() - at);
  return std::equal(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(common),
                    path.begin() + static_cast<std::ptrdiff_t>(at),
                    [](const WrittenKey& key, const std::string& name) { return key.name == name; });
}

/// One change of the text.
struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

class ChangedText {
 public:
  explicit ChangedText(const std::string& text)
      : text_(text), sections_(toml_layout(text)), line_end_(text.find("\r\n") == std::string::npos ? "\n" : "\r\n") {}

  /// The change that sets the value at a path, if the text has a place for it.
  [[nodiscard]] std::optional<Edit> setting(const Keys& path, const Node& value) {
    value_ = &value;
    best_ = {};
    deepest_ = 0;
    if (row_holds(path)) return best_;
    for (const WrittenSection& section : sections_)
      if (!section.repeated && matches(section.header, path, 0)) look_into(section, path);
    for (const WrittenSection& section : sections_)
      if (!section.repeated) offer_header(section, path);
    return best_;
  }

 private:
  /// Looks for the path among the rows of [tables.…].
  bool row_holds(const Keys& path) {
    constexpr std::size_t name_of_part = 2, name_of_point = 4;
    if (path.size() <= name_of_part) return false;
    if (path[0] == "bodies" && path.size() > name_of_point && path[2] == "points") {
      Keys in_row = {"at"};
      in_row.insert(in_row.end(), path.begin() + name_of_point, path.end());
      if (rows_hold("points", path[3], path[1], in_row)) return true;
    }
    return rows_hold(path[0], path[1], "", {path.begin() + name_of_part, path.end()});
  }

  bool rows_hold(const std::string& kind, const std::string& name, const std::string& on, const Keys& in_row) {
    const Keys table = {"tables", kind, "rows"};
    const auto is_row = [&](const std::vector<WrittenPair>& pairs) {
      return names(pairs, "name", name) && (on.empty() || names(pairs, "on", on));
    };
    for (const WrittenSection& section : sections_) {
      if (section.repeated && section.header.size() == table.size() && matches(section.header, table, 0) &&
          is_row(section.pairs)) {
        look_among(section.pairs, in_row, 0);
        offer(0, [&] {
          return line_after(section.pairs.empty() ? section.end : section.pairs.back().value.end, indent(section.begin),
                            in_row);
        });
        return best_.has_value();
      }
      if (section.repeated || section.header.size() >= table.size() || !matches(section.header, table, 0)) continue;
      if (const WrittenValue* rows = value_at(section.pairs, table, section.header.size()))
        for (const WrittenValue& row : rows->items)
          if (is_row(row.pairs)) {
            look_into(row, in_row, 0);
            return best_.has_value();
          }
    }
    return false;
  }

  [[nodiscard]] bool names(const std::vector<WrittenPair>& pairs, const std::string& key,
                           const std::string& wanted) const {
    for (const WrittenPair& pair : pairs)
      if (pair.keys.size() == 1 && pair.keys.front().name == key) {
        const auto node = parsed(pair.value);
        return node &&
            (node->kind == Node::Kind::text ? node->text == wanted : fmt::format("{}", node->number) == wanted);
      }
    return false;
  }

  /// The value at a path among pairs and the tables in braces there.
  static const WrittenValue* value_at(const std::vector<WrittenPair>& pairs, const Keys& path, std::size_t at) {
    for (const WrittenPair& pair : pairs) {
      if (pair.keys.size() > path.size() - at || !matches(pair.keys, path, at)) continue;
      const std::size_t next = at + pair.keys.size();
      if (next == path.size()) return &pair.value;
      if (const WrittenValue* inside = value_at(pair.value.pairs, path, next)) return inside;
    }
    return nullptr;
  }

  [[nodiscard]] std::optional<Node> parsed(const WrittenValue& value) const {
    auto node = parse_toml("value = " + text_.substr(value.begin, value.end - value.begin), "");
    return node ? std::optional(node->items.front()) : std::nullopt;
  }

  /// Keeps an edit if it goes deeper along the path than those before.
  template <typename MakeEdit>
  void offer(std::size_t depth, const MakeEdit& edit) {
    if (best_ && depth <= deepest_) return;
    deepest_ = depth;
    best_ = edit();
  }

  void look_into(const WrittenSection& section, const Keys& path) {
    const std::size_t depth = section.header.size();
    if (depth >= path.size()) return;
    look_among(section.pairs, path, depth);
    offer(depth, [&] {
      const bool bare = section.pairs.empty();
      return line_after(bare ? section.end : section.pairs.back().value.end,
                        indent(bare ? section.begin : section.pairs.back().keys.front().begin), rest(path, depth));
    });
  }

  /// [a.b] above [a.b.c] for the path a.b.x: a table need not have a header of its own.
  void offer_header(const WrittenSection& section, const Keys& path) {
    std::size_t common = 0;
    while (common + 1 < path.size() && common < section.header.size() && section.header[common].name == path[common])
      ++common;
    if (common == 0) return;
    offer(common, [&] {
      const std::string added = value_of(rest(path, common));
      const Keys table(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(common));
      return Edit{section.begin, section.begin, "[" + dotted(table) + "]" + line_end_ + added + line_end_ + line_end_};
    });
  }

  void look_among(const std::vector<WrittenPair>& pairs, const Keys& path, std::size_t at) {
    for (const WrittenPair& pair : pairs) {
      if (!matches(pair.keys, path, at)) continue;
      const std::size_t next = at + pair.keys.size();
      if (next <= path.size()) look_into(pair.value, path, next);
    }
    // a.b.x after the last of a.b.y, a.b.z
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair) {
      std::size_t common = 0;
      while (at + common + 1 < path.size() && common + 1 < pair->keys.size() &&
             pair->keys[common].name == path[at + common])
        ++common;
      if (common == 0) continue;
      offer(at + common, [&] { return beside(*pair, rest(path, at)); });
    }
  }

  void look_into(const WrittenValue& value, const Keys& path, std::size_t at) {
    if (at == path.size()) return offer(at + 1, [&] { return replaced(value); });
    if (value.kind == WrittenValue::Kind::table) {
      in_braces_.push_back(&value);
      look_among(value.pairs, path, at);
      in_braces_.pop_back();
      offer(at, [&] { return put_in_braces(value, rest(path, at)); });
    } else if (value.kind == WrittenValue::Kind::array && at + 1 == path.size()) {
      const auto node = parsed(value);
      const auto component = node ? component_of(*node, path[at]) : std::nullopt;
      if (component && *component < value.items.size())
        offer(path.size() + 1, [&] { return replaced(value.items[*component]); });
    }
  }

  static Keys rest(const Keys& path, std::size_t from) {
    return {path.begin() + static_cast<std::ptrdiff_t>(from), path.end()};
  }

  /// "key = value"; a component of a place that is not written needs the whole place.
  [[nodiscard]] std::string value_of(const Keys& keys) const {
    if (keys.size() >= 2 && is_zero_by_default(keys[keys.size() - 2])) {
      std::string items;
      for (const char* component : {"x", "y", "z"})
        items += (items.empty() ? "" : ", ") + (keys.back() == component ? toml_value(*value_) : std::string("0"));
      return dotted({keys.begin(), keys.end() - 1}) + " = [" + items + "]";
    }
    return dotted(keys) + " = " + toml_value(*value_);
  }

  /// Blanks before the statement at a position.
  [[nodiscard]] std::string indent(std::size_t at) const {
    std::size_t first = at;
    while (first > 0 && (text_[first - 1] == ' ' || text_[first - 1] == '\t')) --first;
    return text_.substr(first, at - first);
  }

  [[nodiscard]] Edit line_after(std::size_t at, const std::string& indentation, const Keys& keys) const {
    const std::size_t end = text_.find('\n', at);
    const std::string line = indentation + value_of(keys) + line_end_;
    if (end != std::string::npos) return {end + 1, end + 1, line};
    return {text_.size(), text_.size(), at == 0 ? line : line_end_ + line};
  }

  [[nodiscard]] Edit beside(const WrittenPair& pair, const Keys& keys) const {
    if (in_braces_.empty()) return line_after(pair.value.end, indent(pair.keys.front().begin), keys);
    return put_in_braces(*in_braces_.back(), keys);
  }

  [[nodiscard]] Edit put_in_braces(const WrittenValue& table, const Keys& keys) const {
    const std::size_t end = table.pairs.empty() ? table.begin + 1 : table.pairs.back().value.end;
    return {end, end, (table.pairs.empty() ? "" : ", ") + value_of(keys)};
  }

  /// The new value in the unit of the old one, with its quotes and blanks.
  [[nodiscard]] Edit replaced(const WrittenValue& value) const {
    Edit edit{value.begin, value.end, toml_value(*value_)};
    const auto old = parsed(value);
    if (!old) return edit;
    const std::string raw = text_.substr(value.begin, value.end - value.begin);
    const auto before = number_in(*old), now = number_in(*value_);
    if (same_numbers(*old, *value_)) {
      edit.text = raw;
    } else if (before && now && (before->value != 0 || !before->unit.empty() || now->unit.empty())) {
      const auto number = in_unit(*now, before->unit);
      const std::string text = number ? number_text(*number, now->unit != before->unit) : "";
      if (number && before->unit.empty()) edit.text = text;
      else if (number) edit.text = with_number(raw, *old, text);
    } else if (old->kind == Node::Kind::text && raw == "'" + old->text + "'" && value_->kind == Node::Kind::text &&
               value_->text.find('\'') == std::string::npos) {
      edit.text = "'" + value_->text + "'";
    }
    return edit;
  }

  /// "150 mm" with another number; the whole text if it has escapes or several lines.
  [[nodiscard]] static std::string with_number(const std::string& raw, const Node& old, const std::string& number) {
    const std::string unit = written_number(old)->unit;
    if (raw.size() != old.text.size() + 2 || raw.substr(1, old.text.size()) != old.text)
      return toml_string(number + " " + unit);
    const std::size_t begin = old.text.find_first_not_of(" \t"), sign = old.text[begin] == '+' ? 1 : 0;
    double ignored = 0;
    const char* const first = old.text.data() + begin + sign;
    const auto [end, error] = std::from_chars(first, old.text.data() + old.text.size(), ignored);
    static_cast<void>(error);
    return raw.front() + old.text.substr(0, begin) + number + end + raw.back();
  }

  const std::string& text_;
  std::vector<WrittenSection> sections_;
  std::string line_end_;
  const Node* value_ = nullptr;
  std::optional<Edit> best_;
  std::size_t deepest_ = 0;
  std::vector<const WrittenValue*> in_braces_;
};

/// Single values of a change with their paths. A table in braces that replaces another one is one value.
void list_values(const Node& change, Keys& path, std::vector<std::pair<Keys, const Node*>>& values) {
  const bool replaces = change.written_inline && !path.empty() && is_exclusive_table(path.back());
  if (change.kind != Node::Kind::table || replaces) {
    values.emplace_back(path, &change);
    return;
  }
  for (std::size_t i = 0; i < change.keys.size(); ++i) {
    path.push_back(change.keys[i]);
    list_values(change.items[i], path, values);
    path.pop_back();
  }
}

}  // namespace

std::string text_with_changes(std::string text, const std::vector<Node>& changes) {
  std::vector<std::pair<Keys, const Node*>> values;
  Keys path;
  for (const Node& change : changes) list_values(change, path, values);
  for (const auto& [keys, value] : values)
    if (const auto edit = ChangedText(text).setting(keys, *value))
      text.replace(edit->begin, edit->end - edit->begin, edit->text);
  return text;
}

bool same_numbers(const Node& a, const Node& b) {
  const auto number = number_in(a), other = number_in(b);
  if (number && other) {
    const auto converted = in_unit(*other, number->unit);
    return converted && std::abs(number->value - *converted) <= same_number * std::abs(number->value);
  }
  if (a.kind != b.kind || a.boolean != b.boolean || a.text != b.text || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    const Node* other_item = a.kind == Node::Kind::table ? b.find(a.keys[i]) : &b.items[i];
    if (!other_item || !same_numbers(a.items[i], *other_item)) return false;
  }
  return true;
}

}  // namespace trivet::project
