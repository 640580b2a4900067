// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/toml_text.h"

#include <algorithm>

#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

class LayoutReader {
 public:
  explicit LayoutReader(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  }

  std::vector<WrittenSection> read() {
    std::vector<WrittenSection> sections(1);
    sections.front().begin = sections.front().end = at_;
    for (skip_space(); at_ < text_.size(); skip_space()) {
      const std::size_t before = at_;
      if (text_[at_] == '[') sections.push_back(header());
      else sections.back().pairs.push_back(pair());
      if (at_ == before) ++at_;  // no valid TOML; the caller parses the text again
    }
    return sections;
  }

 private:
  [[nodiscard]] bool is(char c) const { return at_ < text_.size() && text_[at_] == c; }

  /// Skips blanks, line ends and comments.
  void skip_space() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#') at_ = after_comment_or_string(text_, at_);
      else if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
      else return;
    }
  }

  void skip_blanks() {
    while (is(' ') || is('\t')) ++at_;
  }

  WrittenSection header() {
    WrittenSection section;
    section.begin = at_++;
    section.repeated = is('[');
    if (section.repeated) ++at_;
    section.header = keys();
    while (is(']')) ++at_;
    section.end = at_;
    return section;
  }

  /// Keys with dots between them.
  std::vector<WrittenKey> keys() {
    std::vector<WrittenKey> result;
    do {
      if (!result.empty()) ++at_;
      skip_blanks();
      result.push_back(key());
      skip_blanks();
    } while (is('.'));
    return result;
  }

  WrittenKey key() {
    WrittenKey key;
    key.begin = at_;
    if (is('"') || is('\'')) at_ = after_comment_or_string(text_, at_);
    else at_ = std::min(text_.find_first_of(" \t\r\n.=]}", at_), text_.size());
    key.end = at_;
    const std::string raw(text_.substr(key.begin, key.end - key.begin));
    const std::vector<std::string> names = path_keys(raw);
    key.name = names.size() == 1 ? names.front() : raw;
    return key;
  }

  WrittenPair pair() {
    WrittenPair pair;
    pair.keys = keys();
    if (is('=')) ++at_;
    skip_blanks();
    pair.value = value();
    return pair;
  }

  WrittenValue value() {
    WrittenValue value;
    value.begin = at_;
    if (is('[') || is('{')) {
      const bool array = is('[');
      value.kind = array ? WrittenValue::Kind::array : WrittenValue::Kind::table;
      ++at_;
      for (skip_to_item(); at_ < text_.size() && !is(array ? ']' : '}'); skip_to_item()) {
        const std::size_t before = at_;
        if (array) value.items.push_back(this->value());
        else value.pairs.push_back(pair());
        if (at_ == before) ++at_;
      }
      at_ = std::min(at_ + 1, text_.size());
    } else if (is('"') || is('\'')) {
      at_ = after_comment_or_string(text_, at_);
    } else {
      at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
      while (at_ > value.begin && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t')) --at_;
    }
    value.end = at_;
    return value;
  }

  void skip_to_item() {
    for (skip_space(); is(','); skip_space()) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::size_t after_comment_or_string(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c == '#') return std::min(text.find('\n', at), text.size());
  if (c != '"' && c != '\'') return at;
  const std::string_view triple = c == '"' ? "\"\"\"" : "\'\'\'";
  const bool multi_line = text.substr(at).starts_with(triple);
  for (std::size_t i = at + (multi_line ? 3 : 1); i < text.size(); ++i) {
    if (c == '"' && text[i] == '\\') ++i;
    else if (multi_line ? text.substr(i).starts_with(triple) : text[i] == c) return i + (multi_line ? 3 : 1);
    else if (!multi_line && text[i] == '\n') return i;
  }
  return text.size();
}

std::vector<WrittenSection> toml_layout(std::string_view text) { return LayoutReader(text).read(); }

}  // namespace trivet::project
