// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/question.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::engine {
namespace {

using nlohmann::ordered_json;

constexpr int deepest_nesting = 16;
constexpr std::size_t most_values = 100'000;  // each takes 16 bytes and more, whatever the length of the body
constexpr std::size_t most_wants = 64;

[[noreturn]] void refuse_question(const std::string& key, const std::string& rule) {
  throw foundation::InvalidInput(foundation::quoted(key) + " " + rule);
}

/// Rejects a body that would take much memory as a tree: counts brackets and commas outside texts.
void check_size_as_tree(std::string_view body) {
  int depth = 0;
  std::size_t values = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const char c = body[i];
    if (in_text && c == '\\') ++i;
    else if (c == '"') in_text = !in_text;
    else if (in_text) continue;
    else if (c == '[' || c == '{') ++depth;
    else if (c == ']' || c == '}') --depth;
    else if (c == ',') ++values;
    if (depth > deepest_nesting || values > most_values)
      throw foundation::InvalidInput("the body is nested too deeply, or has too many values");
  }
}

ordered_json parsed_body(const std::string& body) {
  check_size_as_tree(body);
  try {
    return ordered_json::parse(body);
  } catch (const ordered_json::parse_error&) {
    throw foundation::InvalidInput("the body is not JSON in UTF-8");
  }
}

std::string text_at(const std::string& key, const ordered_json& value) {
  if (!value.is_string()) refuse_question(key, "must be a text");
  return value.get<std::string>();
}

std::vector<std::string> texts_at(const std::string& key, const ordered_json& value) {
  if (!value.is_array()) refuse_question(key, "must be a list of texts");
  std::vector<std::string> texts;
  for (const ordered_json& one : value) texts.push_back(text_at(key, one));
  return texts;
}

Value value_at(const std::string& key, const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number()) return value.get<double>();
  if (!value.is_array()) refuse_question(key, "must be a text, a number, true, false, or a list of them");
  std::vector<Value> list;
  for (const ordered_json& one : value) list.push_back(value_at(key, one));
  return list;
}

Want want_from(const ordered_json& value) {
  if (!value.is_object() || !value.contains("command")) refuse_question("wants", "must be a list of {command, keys}");
  Want want;
  for (const auto& [key, item] : value.items()) {
    if (key == "command") {
      want.request.command = text_at(key, item);
    } else if (key == "known") {
      want.known = text_at(key, item);
    } else if (key == "keys" && item.is_object()) {
      for (const auto& [name, given] : item.items()) want.request.keys.emplace_back(name, value_at(name, given));
    } else {
      refuse_question(key, "is no key of a want, or has a wrong value");
    }
  }
  return want;
}

}  // namespace

Question read_question(const std::string& body) {
  const ordered_json parsed = parsed_body(body);
  if (!parsed.is_object()) throw foundation::InvalidInput("the body must be a JSON object");
  Question question;
  for (const auto& [key, value] : parsed.items()) {
    if (key == "revision" && value.is_number()) {
      question.revision = value.get<double>();
    } else if (key == "text") {
      if (!value.is_null()) question.text = text_at(key, value);
    } else if (key == "settings") {
      question.settings = texts_at(key, value);
    } else if (key == "case") {
      question.case_name = text_at(key, value);
    } else if (key == "new_case") {
      question.new_case = text_at(key, value);
    } else if (key == "version") {
      question.version = text_at(key, value);
    } else if (key == "wants" && value.is_array() && value.size() <= most_wants) {
      for (const ordered_json& one : value) question.wants.push_back(want_from(one));
    } else {
      refuse_question(key, "is no key of a question, or has a wrong value");
    }
  }
  return question;
}

}  // namespace trivet::engine
