// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/check_document.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "trivet/documents/shown_numbers.h"

namespace trivet::results {
namespace {

Sentence check_sentence(std::string words) { return {.parts = {std::move(words)}}; }
Sentence check_note(std::string words) { return {.parts = {std::move(words)}, .place = Sentence::Place::note}; }

Table checks_table(std::vector<study::CheckLine> lines) {
  using study::CheckLine;
  const Rows row(std::move(lines));
  return {.rows = row.size(),
          .columns = {row("subject", Kind::words, "subject", &CheckLine::subject),
                      row("check", Kind::words, "check", &CheckLine::what),
                      row("value", Kind::words, "value", &CheckLine::value),
                      row("verdict", Kind::words, "verdict",
                          [](const CheckLine& line) { return line.passed ? "ok" : "FAILED"; })},
          .forms = for_people};
}

void add_checks(const std::vector<study::CheckLine>& lines, bool with_passed, Document& document) {
  std::vector<study::CheckLine> shown = lines;
  if (!with_passed) std::erase_if(shown, [](const study::CheckLine& line) { return line.passed; });
  const std::size_t hidden = lines.size() - shown.size();
  if (!shown.empty()) document.add(checks_table(std::move(shown)));
  if (hidden > 0) document.add(check_note(fmt::format("… {} checks of bodies and elements passed: --full", hidden)));
}

Table mounts_table(const std::vector<study::MountAtRest>& mounts) {
  using study::MountAtRest;
  const Rows row(mounts);
  constexpr int digits = 4;
  return {.rows = row.size(),
          .columns = {row("mount", Kind::words, "mount at rest", &MountAtRest::name),
                      row("compression", Kind::quantity, "compression", &MountAtRest::compression,
                          {.unit = "N", .digits = digits}),
                      row("across", Kind::quantity, "across its axis", &MountAtRest::across,
                          {.unit = "N", .digits = digits}),
                      row("deflection", Kind::quantity, "deflection", &MountAtRest::deflection,
                          {.unit = "m", .digits = digits})},
          .forms = for_people};
}

std::string comparison_words(const response::DeepCheck& deep, const project::DisplayUnits& display) {
  return fmt::format(
      "two solvers compared at {} frequencies: largest difference {:.2e} at {:.6g} {}, allowed {:.2e} (round-off × "
      "condition): {}",
      deep.frequencies, deep.worst_difference, documents::shown_frequency(display, deep.at_angular_frequency),
      documents::frequency_unit(display), deep.allowed, deep.verdict());
}

}  // namespace

Document check_document(const std::vector<study::CaseCheck>& cases, bool with_passed) {
  Document document;
  for (const study::CaseCheck& found : cases) {
    document.add(check_sentence(found.case_name.empty() ? "Base model"
                                                        : "Case " + found.case_name +
                                        (found.lines.empty() ? ": same checks as the base model" : "")));
    add_checks(found.lines, with_passed, document);
    if (!found.mounts.empty()) document.add(mounts_table(found.mounts));
    for (const auto* notes : {&found.free_motions, &found.notes})
      for (const std::string& one : *notes) document.add(check_note("note: " + one));
    if (found.deep) document.add(check_note(comparison_words(*found.deep, found.display)));
  }
  return document;
}

}  // namespace trivet::results
