// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/result_page.h"

#include <sstream>
#include <string>

#include "trivet/documents/html_table.h"
#include "trivet/report/figures/design_lines_figure.h"

namespace trivet::report {

extern const char* const page_css;
extern const char* const lines_script;

std::string result_page(const std::string& title, const std::string& remarks, const std::string& tables) {
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      documents::escaped(title) + "</title>\n<style>" + page_css + "</style>\n</head>\n<body>\n<main>\n<h1>" +
      documents::escaped(title) + "</h1>\n";
  std::istringstream lines(remarks);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) page += documents::paragraph(line);
  page += tables + "</main>\n";
  if (has_design_lines(tables)) page += std::string("<script>\n") + lines_script + "</script>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace trivet::report
