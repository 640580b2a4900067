// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/report_settings.h"

namespace trivet::project {

ReportSettings read_report(TableReader& root) {
  ReportSettings settings;
  const Node* table = root.table("report");
  if (!table) return settings;
  TableReader reader(*table, "report", root.problems());
  const auto text = [&](const char* key) { return reader.text(key).value_or(""); };
  settings.project = text("project");
  settings.client = text("client");
  settings.machine = text("machine");
  settings.revision = text("revision");
  settings.author = text("author");
  settings.date = text("date");
  if (reader.choice("form", {"full", "short"}) == "short") settings.form = ReportForm::brief;
  reader.finish();
  return settings;
}

ReportSettings report_settings(const Project& project) {
  foundation::Problems found_before;  // every problem of this table was reported when the file was read
  TableReader root(project.base().written, "", found_before);
  return read_report(root);
}

}  // namespace trivet::project
