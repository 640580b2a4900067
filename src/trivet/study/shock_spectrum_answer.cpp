// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/case_context.h"

namespace trivet::study {

std::vector<ShockSpectrumResult> shock_spectrum_answer(const CaseContext& c, const project::ShockSpectrumRequest& request, foundation::Problems& warnings) {
  constexpr int per_octave = 48;
  std::vector<double> natural;
  const int count = std::max(2, static_cast<int>(std::ceil(per_octave * std::log2(request.band.to / request.band.from))) + 1);
  for (int i = 0; i < count; ++i) natural.push_back(request.band.from * std::pow(request.band.to / request.band.from, static_cast<double>(i) / (count - 1)));
  std::vector<ShockSpectrumResult> results;
  for (const model::Excitation& excitation : c.system.description().excitations) {
    const auto* history = std::get_if<model::History>(&excitation.course);
    if (!history || !selected(request.excitations, excitation.name)) continue;
    const model::Action& action = excitation.action;
    if (action.body || action.derivative != 2 || !action.amplitude.tail<3>().isZero(0)) {
      const std::string reason = "shock_spectrum: \"" + excitation.name + "\" is not a translation of the ground given by its acceleration";
      if (!request.excitations.empty()) throw foundation::NotComputable(reason);
      warnings.warning(reason, "left out", "", "");
      continue;
    }
    const excitation::Signal along = excitation::scaled(history->signal, action.amplitude.head<3>().norm());
    results.push_back({excitation.name, "m/s²", request.damping_ratio, excitation::shock_spectrum(along, natural, request.damping_ratio, c.progress)});
  }
  if (results.empty()) throw foundation::NotComputable("shock_spectrum: the model has no motion of the ground given by its acceleration over time");
  return results;
}

}  // namespace trivet::study
