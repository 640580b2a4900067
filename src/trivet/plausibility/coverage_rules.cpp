// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/assembly/band_ends.h"
#include "trivet/plausibility/rules.h"

/// What limits and lines leave out without saying so.
namespace trivet::plausibility {

using assembly::same_end;

void judge_service_speeds(const std::vector<Rotor>& rotors, const std::vector<LimitedRange>& ranges,
                          Suspicions& found) {
  if (ranges.empty()) return;
  for (const Rotor& rotor : rotors) {
    if (!rotor.service_speed) continue;
    const double speed = *rotor.service_speed;
    if (std::ranges::any_of(ranges, [&](const LimitedRange& range) {
          return range.from <= speed * (1 + same_end) && speed <= range.to * (1 + same_end);
        }))
      continue;
    const LimitedRange& first = ranges.front();
    found.push_back(
        {"service speed", first.subject, fmt::format("{:.5g} … {:.5g} Hz", hertz(first.from), hertz(first.to)),
         fmt::format("no amplitude is limited at the service speed of \"{}\", {:.5g} rpm = {:.5g} Hz", rotor.excitation,
                     60 * hertz(speed), hertz(speed)),
         first.subject.starts_with("operation.")
             ? "let the speeds contain it; of a shaft that turns at another speed write type = \"orders\", or "
               "leave it out of operation.excitations"
             : "let the band contain it, or check the units of both"});
  }
}

void judge_measured_ranges(const model::System& system, const std::vector<BandLine>& lines, Suspicions& found) {
  for (const BandLine& line : lines)
    for (const model::Excitation& excitation : system.description().excitations) {
      const auto* random = std::get_if<model::Random>(&excitation.course);
      if (!random || !model::is_selected(excitation, line.excitations)) continue;
      const double from = random->spectrum.from(), to = random->spectrum.to();
      if (from <= line.from * (1 + same_end) && to >= line.to * (1 - same_end)) continue;
      found.push_back(
          {"measured range", line.subject,
           fmt::format("it runs from {:.4g} to {:.4g} Hz", hertz(line.from), hertz(line.to)),
           fmt::format("excitation \"{}\" is known from {:.4g} to {:.4g} Hz only: elsewhere the line is met "
                       "because nothing excites",
                       excitation.name, hertz(from), hertz(to)),
           "add the missing bands of the excitation, or give the line by `rows` where it was measured"});
      break;
    }
}

}  // namespace trivet::plausibility
