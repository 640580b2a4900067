// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/format_table.h"
#include "trivet/exports/part_tables.h"
#include "trivet/results/written_answers.h"

/// The tables of the result folder, and the parts of the model as tables that a project file reads.
namespace trivet::exports {
namespace {

std::vector<std::string> write_csv(const Content& content, const Target& target, const foundation::Progress&) {
  std::vector<std::string> lost;
  for (const PartTable& table : part_tables(content.variant.document, lost))
    write_bytes(target.path() / (table.kind + ".csv"), table.csv);
  for (const Group& group : content.groups) {
    if (!group.answers) {
      lost.push_back(group.name + " is not written: take matrix_market for matrices");
      continue;
    }
    for (const results::AnswerTable& table : results::answer_tables(group.name))
      write_bytes(target.path() / table.file, table.csv(content.variant, *group.answers));
  }
  return lost;
}

}  // namespace

const Format csv_format = {
    "csv",
    "folder with the CSV tables of the answers, and bodies, elements and points as tables that a file reads",
    Target::Kind::folder,
    {},
    false,
    write_csv};

}  // namespace trivet::exports
