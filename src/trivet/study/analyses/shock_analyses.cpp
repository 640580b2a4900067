// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {

namespace {

response::EarthquakeResponse earthquake_result(const CaseContext& c, const project::EarthquakeAnalysis& request,
                                               foundation::Problems& warnings) {
  require_rigid_ground(c, "earthquake");
  spatial::Vector6 direction = spatial::Vector6::Zero();
  direction.head<3>() = request.direction;
  response::EarthquakeResponse result =
      response::earthquake_response(c.assembled, channels_of(c, request.selection), request.spectrum, direction);
  warnings.add(result.warnings);
  if (!(result.effective_mass_share > 0))
    throw foundation::NotComputable(
        "earthquake: the spectrum covers none of the modes that this ground motion excites");
  return result;
}

}  // namespace

const AnalysisRun earthquake_run =
    computed_by<&project::Analyses::earthquake, &CaseResults::earthquake, earthquake_result>(
        "largest response to an earthquake, from its response spectrum",
        "earthquake: no spectrum given; add earthquake = {direction = \"x\", rows = "
        "[[0.02, 3], [0.1, 9], …]} to [analyses]");

namespace {

std::vector<ShockSpectrumResult> shock_spectrum_result(const CaseContext& c,
                                                       const project::ShockSpectrumAnalysis& request,
                                                       foundation::Problems& warnings) {
  constexpr int per_octave = 48;
  std::vector<double> natural;
  const int count =
      std::max(2, static_cast<int>(std::ceil(per_octave * std::log2(request.band.to / request.band.from))) + 1);
  for (int i = 0; i < count; ++i)
    natural.push_back(request.band.from *
                      std::pow(request.band.to / request.band.from, static_cast<double>(i) / (count - 1)));
  std::vector<ShockSpectrumResult> results;
  for (const model::Excitation& excitation : c.system.description().excitations) {
    const auto* history = std::get_if<model::History>(&excitation.course);
    if (!history || !model::is_selected(excitation, request.selection.excitations)) continue;
    const model::Action& action = excitation.action;
    if (action.body || action.derivative != 2 || !action.amplitude.tail<3>().isZero(0)) {
      const std::string reason =
          "shock_spectrum: \"" + excitation.name + "\" is not a translation of the ground given by its acceleration";
      if (!request.selection.excitations.empty()) throw foundation::NotComputable(reason);
      warnings.warning(reason, "ignored", "", "");
      continue;
    }
    const excitation::Signal along = excitation::scaled(history->signal, action.amplitude.head<3>().norm());
    results.push_back({excitation.name, "m/s²", request.damping_ratio,
                       excitation::shock_spectrum(along, natural, request.damping_ratio, c.progress)});
  }
  if (results.empty())
    throw foundation::NotComputable(
        "shock_spectrum: the model has no motion of the ground given by its acceleration over time");
  return results;
}

}  // namespace

const AnalysisRun shock_spectrum_run =
    computed_by<&project::Analyses::shock_spectrum, &CaseResults::shock_spectrum, shock_spectrum_result>(
        "shock response spectra of ground accelerations over time",
        "shock_spectrum: no range of natural frequencies given; add shock_spectrum = {band "
        "= [\"5 Hz\", \"2000 Hz\"]} to [analyses]");

}  // namespace trivet::study
