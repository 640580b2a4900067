// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/result_page.h"

#include <sstream>
#include <string>

#include "trivet/documents/html_table.h"

namespace trivet::report {

extern const char* const page_css;

std::string result_page(const std::string& title, const std::string& remarks, const std::string& tables) {
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      documents::escaped(title) + "</title>\n<style>" + page_css + "</style>\n</head>\n<body>\n<main>\n<h1>" +
      documents::escaped(title) + "</h1>\n";
  std::istringstream lines(remarks);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) page += documents::paragraph(line);
  return page + tables + "</main>\n</body>\n</html>\n";
}

}  // namespace trivet::report
