// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/key_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/units.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

/// The number that is the whole text, if it is one.
std::optional<double> plain_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::vector<std::string> between_commas(const std::string& text) {
  const std::vector<std::string_view> parts = exchange::cells(text, ',');
  if (parts.empty()) return {""};  // a blank text is a wrong item, not none
  return {parts.begin(), parts.end()};
}

/// The items, those without a unit with this one: "1 Hz,5 Hz", and "0,5 Hz" of a band.
std::string with_missing_units(const std::vector<std::string>& items, bool band, const std::string& unit) {
  std::string text;
  for (const std::string& item : items) {
    const auto number = plain_number(item);
    text += (text.empty() ? "" : ",") + item + (number && !(band && *number == 0) ? " " + unit : "");
  }
  return text;
}

/// Rejects texts whose frequencies have no unit: engineers mean Hz, or rpm of a speed, formulas rad/s. If only some
/// have none, "1,5 Hz" may also be one number with a decimal comma. The 0 of a band is 0 in every unit.
void refuse_without_units(const std::string& key, const Key& row, const std::string& text,
                          const std::vector<std::string>& items) {
  const bool band = row.name == std::string_view("band"), speed = std::string_view(row.value).starts_with("SPEED");
  const auto bare = std::ranges::count_if(items, [band](const std::string& item) {
    const auto number = plain_number(item);
    return number && !(band && *number == 0);
  });
  if (bare == 0) return;
  const auto with_unit = std::ranges::count_if(items, [](const std::string& item) { return !plain_number(item); });
  if (with_unit > 0)
    throw InvalidInput(fmt::format(
        "{} \"{}\": some values have a unit and some have none; give each its unit as in {} \"1 Hz,5 Hz\"; a decimal "
        "number has a point: \"1.5 Hz\"",
        key, text, key));
  throw InvalidInput(fmt::format("{0} \"{1}\": a {4} has a unit; write {0} \"{2}\" or {0} \"{3}\"", key, text,
                                 with_missing_units(items, band, speed ? "rpm" : "Hz"),
                                 with_missing_units(items, band, "rad/s"), speed ? "speed" : "frequency"));
}

std::optional<int> whole_number(const Value& value) {
  if (const auto* number = std::get_if<double>(&value))
    return *number == std::floor(*number) && std::abs(*number) < 1e9 ? std::optional(static_cast<int>(*number))
                                                                     : std::nullopt;
  const auto* text = std::get_if<std::string>(&value);
  int number = 0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  return error == std::errc() && end == text->data() + text->size() ? std::optional(number) : std::nullopt;
}

/// The rule that a value of this kind violates, and what to do; none if it is right.
std::optional<std::pair<std::string, std::string>> wrong_kind(const Key& key, const Value& value) {
  using Rule = std::pair<std::string, std::string>;
  if (key.kind == KeyKind::flag && !std::holds_alternative<bool>(value))
    return Rule("it is yes or no", "give true, or omit the key");
  if (key.kind == KeyKind::count && whole_number(value).value_or(0) < 1)
    return Rule("it is a whole number ≥ 1", "give one, such as 10");
  if (key.kind == KeyKind::choice && std::ranges::find(key.choices, text_of(value)) == key.choices.end())
    return Rule(fmt::format("it is one of {}", fmt::join(key.choices, ", ")), "choose one");
  const auto* text = std::get_if<std::string>(&value);
  if (text && text->empty()) return Rule("it must not be empty", "omit the key");
  return std::nullopt;
}

}  // namespace

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
  std::string list;
  for (const Value& one : std::get<std::vector<Value>>(value)) list += (list.empty() ? "" : ",") + text_of(one);
  return list;
}

KeyReader::KeyReader(const Command& command, const Request& request, foundation::Problems& problems)
    : command_(command), keys_(request.keys), before_(request.before_keys) {
  std::vector<std::string> known;
  for (const Key& key : command.keys) known.emplace_back(key.name);
  for (const auto& [name, value] : keys_) {
    const auto key = std::ranges::find(command.keys, name, &Key::name);
    if (key == command.keys.end()) {
      const std::string guess = foundation::nearest_name(name, known);
      problems.error(written(name), text_of(value), fmt::format("{} has no such key", command.name),
                     guess.empty() ? "omit it" : "did you mean " + written(guess) + "?");
      continue;
    }
    if (const auto wrong = wrong_kind(*key, value))
      problems.error(written(name), "\"" + text_of(value) + "\"", wrong->first, wrong->second);
    if (*key->excludes != '\0' && has(key->excludes))
      problems.error(written(name), text_of(value), written(key->excludes) + " excludes it", "give one of them");
  }
  for (const Key& key : command.keys)
    if (key.required && !has(key.name))
      problems.error(written(key.name), "not given", "this command needs it: " + key.about, "give it");
}

const Key& KeyReader::row(const std::string& key) const {
  const auto found = std::ranges::find(command_.keys, key, &Key::name);
  assert(found != command_.keys.end() && "a command reads only keys of its row");
  return *found;
}

const Value* KeyReader::find(const std::string& key) const {
  const auto found = std::ranges::find(keys_, key, [](const auto& one) { return one.first; });
  return found == keys_.end() ? nullptr : &found->second;
}

bool KeyReader::flag(const std::string& key) const {
  assert(row(key).kind == KeyKind::flag);
  const Value* value = find(key);
  return value && std::get<bool>(*value);
}

int KeyReader::count(const std::string& key) const {
  const Value* value = find(key);
  return whole_number(value ? *value : Value(std::string(row(key).by_default))).value_or(0);
}

std::string KeyReader::text(const std::string& key) const {
  const Value* value = find(key);
  return value ? text_of(*value) : row(key).by_default;
}

std::vector<std::string> KeyReader::names(const std::string& key) const {
  assert(std::ranges::find(command_.keys, key, &Key::name) != command_.keys.end());
  std::vector<std::string> all;
  for (const auto& [name, value] : keys_) {
    if (name != key) continue;
    if (const auto* list = std::get_if<std::vector<Value>>(&value))
      for (const Value& one : *list) all.push_back(text_of(one));
    else all.push_back(text_of(value));
  }
  return all;
}

std::vector<std::string> KeyReader::texts(const std::string& key) const {
  std::vector<std::string> all;
  for (const std::string& text : names(key))
    for (std::string& item : between_commas(text)) all.push_back(std::move(item));
  return all;
}

double KeyReader::frequency(const std::string& key, const Value& value) const {
  const std::string text = text_of(value);
  if (std::holds_alternative<std::string>(value)) refuse_without_units(written(key), row(key), text, {text});
  std::optional<double> omega = plain_number(text);
  if (!omega) {
    const auto converted = project::to_si(text, project::Quantity::angular_frequency);
    if (!converted)
      throw InvalidInput(fmt::format("{}: \"{}\": {}; give a number and its unit, as in \"5 Hz\" or \"31.4 rad/s\"",
                                     written(key), text, converted.error()));
    omega = *converted;
  }
  if (const auto broken = project::outside_range(*omega, project::Quantity::angular_frequency))
    throw InvalidInput(fmt::format("{}: {}; {}", written(key), foundation::hertz_words(*omega, 6), *broken));
  if (!(*omega >= 0))
    throw InvalidInput(fmt::format("{}: \"{}\"; a frequency is ≥ 0; {}", written(key), text,
                                   std::isnan(*omega) ? "give a number" : "remove the sign"));
  return *omega;
}

std::vector<double> KeyReader::frequencies(const std::string& key) const {
  const Value* value = find(key);
  std::vector<double> all;
  if (!value) return all;
  if (const auto* text = std::get_if<std::string>(value)) {
    const std::vector<std::string> items = between_commas(*text);
    refuse_without_units(written(key), row(key), *text, items);
    for (const std::string& item : items) all.push_back(frequency(key, item));
  } else if (const auto* list = std::get_if<std::vector<Value>>(value)) {
    for (const Value& one : *list) all.push_back(frequency(key, one));
  } else {
    all.push_back(frequency(key, *value));
  }
  return all;
}

std::optional<double> KeyReader::seconds(const std::string& key) const {
  const Value* value = find(key);
  if (!value) return std::nullopt;
  const std::string text = text_of(*value);
  std::optional<double> seconds = plain_number(text);
  if (!seconds) {
    const auto converted = project::to_si(text, project::Quantity::time);
    if (!converted)
      throw InvalidInput(fmt::format("{}: \"{}\": {}; give seconds, or a unit as in \"10 min\"", written(key), text,
                                     converted.error()));
    seconds = *converted;
  }
  if (!(*seconds > 0 && std::isfinite(*seconds)))
    throw InvalidInput(fmt::format("{}: \"{}\"; a time is above 0", written(key), text));
  return seconds;
}

std::vector<Eigen::Vector3d> KeyReader::directions(const std::string& key) const {
  const auto direction = [&](const std::vector<std::string>& numbers, const std::string& text) {
    if (numbers.size() == 1)
      for (int i = 0; i < 3; ++i)
        if (numbers[0] == std::string(1, "xyz"[i])) return Eigen::Vector3d(Eigen::Vector3d::Unit(i));
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    constexpr double most = 1e30;  // its square is still a number
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = i < numbers.size() ? plain_number(numbers[i]) : std::nullopt;
      if (numbers.size() != 3 || !number || !(std::abs(*number) < most))
        throw InvalidInput(fmt::format("{} \"{}\": give x, y, z or three numbers like 0.9,0,0.1", written(key), text));
      axis(static_cast<Eigen::Index>(i)) = *number;
    }
    if (axis.isZero(0)) throw InvalidInput(fmt::format("{} \"{}\": a moment needs a direction", written(key), text));
    return axis;
  };
  std::vector<Eigen::Vector3d> all;
  const Value* value = find(key);
  if (!value) return all;
  if (const auto* list = std::get_if<std::vector<Value>>(value))
    for (const Value& one : *list) all.push_back(direction(between_commas(text_of(one)), text_of(one)));
  else all.push_back(direction(between_commas(text_of(*value)), text_of(*value)));
  return all;
}

}  // namespace trivet::engine
