// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/json_text.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/integer_list.h"
#include "trivet/foundation/index.h"

/// JSON as text. Lists of numbers are text already: binary values, which no other part of the results uses.
namespace trivet::documents::json {
namespace {

/// Appends the shortest digits; with a point or an exponent, so that every reader sees a real number.
template <typename Text>
void append_number(Text& text, double value) {
  const ShortestDigits digits(value);
  const std::string_view shortest = std::isfinite(value) ? digits.view() : "null";
  text.insert(text.end(), shortest.begin(), shortest.end());
  if (shortest.find_first_of(".eu") == std::string_view::npos) {
    text.push_back('.');
    text.push_back('0');
  }
}

/// Characters of all lists of numbers.
std::size_t size_of_lists(const Json& json) {
  if (json.is_binary()) return json.get_binary().size();
  if (!json.is_structured()) return 0;
  std::size_t size = 0;
  for (const Json& value : json) size += size_of_lists(value);
  return size;
}

bool needs_no_escape(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

class Writer {
 public:
  Writer(int indent, std::size_t expected_size) : indent_(indent) { text_.reserve(expected_size); }

  void write(const Json& json) {
    switch (json.type()) {
      case Json::value_t::object:
        return write_object(json);
      case Json::value_t::array:
        return write_array(json);
      case Json::value_t::string:
        return write_string(json.get_ref<const std::string&>());
      case Json::value_t::binary:
        text_.append(json.get_binary().begin(), json.get_binary().end());
        return;
      case Json::value_t::number_float:
        append_number(text_, json.get<double>());
        return;
      default:
        text_ += json.dump();
        return;
    }
  }

  [[nodiscard]] std::string&& text() && { return std::move(text_); }

 private:
  void write_object(const Json& json) {
    if (json.empty()) {
      text_ += "{}";
      return;
    }
    const char* before = "{";
    level_ += 1;
    for (const auto& [key, value] : json.items()) {
      text_ += before;
      new_line();
      write_string(key);
      text_ += indent_ < 0 ? ":" : ": ";
      write(value);
      before = ",";
    }
    level_ -= 1;
    new_line();
    text_ += '}';
  }

  void write_array(const Json& json) {
    if (json.empty()) {
      text_ += "[]";
      return;
    }
    const char* before = "[";
    level_ += 1;
    for (const Json& value : json) {
      text_ += before;
      new_line();
      write(value);
      before = ",";
    }
    level_ -= 1;
    new_line();
    text_ += ']';
  }

  void write_string(const std::string& string) {
    if (needs_no_escape(string)) ((text_ += '"') += string) += '"';
    else text_ += Json(string).dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  void new_line() {
    if (indent_ < 0) return;
    text_ += '\n';
    text_.append(to_size(indent_) * to_size(level_), ' ');
  }

  std::string text_;
  int indent_;
  int level_ = 0;
};

}  // namespace

Json integer_list(const std::vector<int>& values) {
  std::string text = "[";
  for (const int value : values) text += (text.size() > 1 ? "," : "") + std::to_string(value);
  text += ']';
  return Json::binary({text.begin(), text.end()});
}

std::string text(const Json& json, int indent) {
  const std::size_t lists = size_of_lists(json);
  Writer writer(indent, lists + lists / 2);
  writer.write(json);
  return std::move(writer).text();
}

void NumberList::separate() {
  if (text_.back() != '[') text_.push_back(',');
}

void NumberList::add(double value) {
  separate();
  append_number(text_, value);
}

void NumberList::add(const std::complex<double>& value) {
  separate();
  if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) {
    append_number(text_, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  text_.push_back('[');
  add(value.real());
  add(value.imag());
  text_.push_back(']');
}

Json NumberList::json() && {
  text_.push_back(']');
  return Json::binary(std::move(text_));
}

}  // namespace trivet::documents::json
