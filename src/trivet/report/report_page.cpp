// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/report_page.h"

#include <fmt/format.h>

#include "trivet/foundation/version.h"
#include "trivet/report/answer_sections.h"
#include "trivet/report/figures.h"
#include "trivet/report/svg_canvas.h"

namespace trivet::report {

extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;

namespace {

void replace(std::string& text, const std::string& place, const std::string& content) {
  const std::size_t at = text.find(place);
  if (at != std::string::npos) text.replace(at, place.size(), content);
}

/// Escapes JSON so that it cannot end the script element around it.
std::string inside_script(const std::string& json) {
  std::string result;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '<') result += "\\u003c";
    else result += json[i];
  }
  return result;
}

/// One block per case; the script shows that of the selected case, without scripts the first one is visible.
std::string case_blocks(const std::vector<study::Answers>& answers) {
  std::string blocks;
  for (std::size_t i = 0; i < answers.size(); ++i)
    blocks +=
        fmt::format("<div data-case=\"{}\"{}>{}</div>\n", i, i == 0 ? "" : " hidden", answer_sections(answers[i]));
  return blocks;
}

}  // namespace

std::string report_page(const project::Project& project, const std::vector<study::Answers>& answers,
                        const std::string& results) {
  const std::string title = project.title.empty() ? project.source : project.title;
  std::string page = page_html;
  // From the end to the start, so that inserted text that looks like a placeholder is not replaced.
  replace(page, "{{script}}", page_js);
  replace(page, "{{results}}", inside_script(results));
  replace(page, "{{answers}}", case_blocks(answers));
  replace(page, "{{overview}}", overview(title, answers).svg);
  replace(page, "{{program}}", fmt::format("trivet {}", foundation::version()));
  replace(page, "{{heading}}", escaped(title));
  replace(page, "{{style}}", page_css);
  replace(page, "{{title}}", escaped(title));
  return page;
}

}  // namespace trivet::report
