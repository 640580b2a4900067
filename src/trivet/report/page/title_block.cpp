// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/title_block.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "trivet/documents/html_table.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/version.h"
#include "trivet/project/input_files.h"
#include "trivet/project/report_settings.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/results/design/judgements.h"

namespace trivet::report {
namespace {

/// Today in UTC, "2026-11-29", or the day of SOURCE_DATE_EPOCH, so that a report can be made again with the same bytes.
std::string date() {
  std::time_t seconds = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long given = std::strtoll(fixed, &end, 10);
    if (end != fixed && *end == '\0') seconds = static_cast<std::time_t>(given);
  }
  std::tm day{};
  gmtime_r(&seconds, &day);
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

std::string file_name(const project::Project& project) {
  return std::filesystem::path(project.source).filename().string();
}

/// The text between the tags of <pre>: an HTML reader would drop a line break at its start and change "\r".
std::string preformatted(const std::string& text) {
  std::string html = "\n";
  for (const char c : escaped(text)) html += c == '\r' ? "&#13;" : std::string(1, c);
  return html;
}

}  // namespace

std::string title_block(const project::Project& project) {
  const project::ReportSettings settings = project::report_settings(project);
  std::string html;
  const auto add = [&](const char* what, const std::string& value, const char* style = "") {
    if (!value.empty()) html += fmt::format("<div{}><dt>{}</dt><dd>{}</dd></div>\n", style, what, escaped(value));
  };
  add("Project", settings.project);
  add("Client", settings.client);
  add("Machine", settings.machine);
  add("Revision", settings.revision);
  add("Author", settings.author);
  add("Date", settings.date.empty() ? date() : settings.date);
  add("Program", fmt::format("trivet {}", foundation::version()));
  const std::vector<project::InputFile> files = project::input_files(project);
  add("Input",
      file_name(project) +
          (files.empty() ? "" : " with " + results::count_words(files.size(), "file") + " that it names"));
  add("SHA-256", project::input_hash(project, files), " class=\"hash\"");
  return "<dl class=\"title-block\">\n" + html + "</dl>";
}

namespace {

/// Files that the project names, which are not in the appendix, with their hashes.
std::string named_files(const project::Project& project, const std::vector<project::InputFile>& files) {
  if (files.empty()) return "";
  std::vector<std::vector<Cell>> rows = {{{file_name(project)}, {project.sha256}}};
  for (const project::InputFile& file : files) rows.push_back({{file.name}, {file.sha256}});
  return "<div class=\"hashes\">" + html_table({{"file"}, {"SHA-256"}}, rows) + "</div>\n" +
      hint("The hash of the input is that of these hashes, one per line. That of the project file includes its --set.");
}

}  // namespace

std::string input_file(const project::Project& project) {
  if (!project.parsed) return "";
  std::vector<std::string> cases;
  for (const project::Case& variant : project.cases)
    if (!variant.name.empty()) cases.push_back(variant.name);
  const std::vector<project::InputFile> files = project::input_files(project);
  std::string html = hint(file_name(project) + ", SHA-256 " + project::input_hash(project, files) + "." +
                          (cases.empty() ? "" : " Cases: " + foundation::comma_separated(cases) + ".")) +
      named_files(project, files);
  if (!project.settings.empty()) {
    html += "<p>Read with</p><ul>";
    for (const std::string& setting : project.settings) html += "<li><code>--set " + escaped(setting) + "</code></li>";
    html += "</ul>\n";
  }
  return html + "<pre class=\"input-text\" tabindex=\"0\" aria-label=\"Input file\">" +
      preformatted(project.parsed->text) + "</pre>\n";
}

}  // namespace trivet::report
