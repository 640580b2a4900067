// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/check_text.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"

namespace trivet::results {
namespace {

std::string checks_text(const std::vector<study::CheckLine>& lines) {
  TextTable table({"subject", "check", "value", "verdict"});
  for (const study::CheckLine& line : lines)
    table.add({line.subject, line.what, line.value, line.passed ? "ok" : "FAILED"});
  return table.text();
}

std::string mounts_text(const std::vector<study::MountAtRest>& mounts, const project::DisplayUnits& display) {
  if (mounts.empty()) return "";
  LargestOfKind largest;
  for (const study::MountAtRest& mount : mounts) {
    for (const double force : {mount.compression, mount.across}) largest.add("N", force);
    largest.add("m", mount.deflection);
  }
  const auto shown = [&](double value, const char* unit) {
    constexpr double no_sign = 0;  // -0 + 0 is 0
    return value_text(largest.shown(unit, value) + no_sign, display_unit(display, unit));
  };
  TextTable table({"mount at rest", "compression", "across its axis", "deflection"});
  for (const study::MountAtRest& mount : mounts)
    table.add({mount.name, shown(mount.compression, "N"), shown(mount.across, "N"), shown(mount.deflection, "m")});
  return table.text();
}

}  // namespace

std::string case_check_text(const study::CaseCheck& found) {
  std::string text = found.case_name.empty()
      ? "Base model\n"
      : "Case " + found.case_name + (found.lines.empty() ? ": same checks as the base model\n" : "\n");
  if (!found.lines.empty()) text += checks_text(found.lines);
  text += mounts_text(found.mounts, found.display);
  for (const auto* notes : {&found.free_motions, &found.notes})
    for (const std::string& note : *notes) text += "  note: " + note + "\n";
  if (found.deep)
    text += fmt::format(
        "  two solvers compared at {} frequencies: largest difference {:.2e} at {:.6g} {}, allowed {:.2e} "
        "(round-off × condition): {}\n",
        found.deep->frequencies, found.deep->worst_difference,
        documents::shown_frequency(found.display, found.deep->at_angular_frequency),
        documents::frequency_unit(found.display), found.deep->allowed, found.deep->verdict());
  return text;
}

}  // namespace trivet::results
