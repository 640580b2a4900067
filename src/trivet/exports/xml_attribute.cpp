// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/xml_attribute.h"

#include <fmt/format.h>

namespace trivet::exports {
namespace {

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    switch (character) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

}  // namespace

std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, xml_escaped(value));
}

std::string attribute(const char* name, std::size_t value) { return fmt::format(" {}=\"{}\"", name, value); }

std::string attribute(const char* name, const std::optional<double>& value) {
  return value ? fmt::format(" {}=\"{}\"", name, *value) : "";
}

}  // namespace trivet::exports
