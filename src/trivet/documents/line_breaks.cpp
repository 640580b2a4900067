// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "trivet/documents/screen.h"
#include "trivet/documents/text_table.h"

namespace trivet::documents {
namespace {

std::string broken_line(std::string_view text, std::size_t width) {
  if (width_on_screen(std::string(text)) <= width) return std::string(text);
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return "";
  const std::string further(std::min(begin + 4, width / 2), ' ');
  std::string lines, line(text.substr(0, begin));
  bool is_empty = true;  // no word is on the line yet
  for (std::size_t from = begin; from < text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string_view word = text.substr(from, space - from);
    if (!is_empty && width_on_screen(line) + 1 + width_on_screen(std::string(word)) > width) {
      lines += line + "\n";
      line = further;
      is_empty = true;
    }
    line.append(is_empty ? "" : " ").append(word);
    is_empty = false;
    from = space + 1;
  }
  return lines + line;
}

}  // namespace

std::string with_line_breaks(const std::string& text, std::size_t width) {
  std::string broken;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    broken += broken_line(std::string_view(text).substr(from, end - from), width);
    if (end < text.size()) broken += '\n';
    from = end + 1;
  }
  return broken;
}

}  // namespace trivet::documents
