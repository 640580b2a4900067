// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_results.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/motion_words.h"
#include "trivet/response/steady/resonant_mode.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {
namespace {

std::string direction_words(const model::Direction& direction) {
  return (direction.rotation ? "about " : "along ") + modal::direction_words(direction.axis.normalized());
}

response::Transmission transmission_of(const CaseContext& c, const project::TransmissibilityAnalysis& request) {
  if (!request.force.empty())
    return response::force_transmission(c.system, c.assembled, model::applied_force(c.system, request.force));
  require_rigid_ground(c, "transmissibility");
  return response::displacement_transmission(c.system, c.assembled, request.selection.of, request.direction);
}

/// @throws foundation::NotComputable if it is empty
assembly::Band band_of(const CaseContext& c, const project::TransmissibilityAnalysis& request) {
  const assembly::Band band = request.band ? *request.band : default_band(c);
  if (band.from < band.to) return band;
  throw foundation::NotComputable(
      "transmissibility: the tables of the elements and the natural frequencies have no band in common; give a band");
}

response::Peaks peaks_of(const CaseContext& c, const response::Transmission& transmission, const assembly::Band& band) {
  return response::peaks(c.assembled, transmission.channels, transmission.loading, c.modes, c.roots(),
                         {.search_to = band.to}, c.progress);
}

TransmissibilityResult transmissibility_result(const CaseContext& c, const project::TransmissibilityAnalysis& request,
                                               foundation::Problems&) {
  const bool force = !request.force.empty();
  const response::Transmission transmission = transmission_of(c, request);
  TransmissibilityResult result;
  result.of_force = force;
  result.words = force ? "force on the ground over \"" + request.force + "\""
                       : "motion over a motion of the ground " + direction_words(request.direction);
  result.band = band_of(c, request);
  result.peaks = peaks_of(c, transmission, result.band);
  for (std::size_t i = 0; i < transmission.channels.size(); ++i)
    result.in_band.push_back(design::largest_in_band(c.assembled, transmission.channels, transmission.loading,
                                                     result.peaks, i, result.band));
  response::set_nearest_modes(c.assembled, transmission.channels, transmission.loading, c.modes, result.peaks);
  result.curves = response::frequency_response(
      c.assembled, transmission.channels, transmission.loading,
      grid_over(c, transmission.channels, transmission.loading, result.peaks, result.band));
  if (!request.at.empty())
    result.at = response::frequency_response(c.assembled, transmission.channels, transmission.loading, request.at);
  result.crossovers = response::crossovers(c.assembled, transmission, result.peaks);
  return result;
}

}  // namespace

double largest_transmissibility(const CaseContext& context, const project::TransmissibilityAnalysis& request) {
  const response::Transmission transmission = transmission_of(context, request);
  const assembly::Band band = band_of(context, request);
  return design::largest_in_band(context.assembled, transmission.channels, transmission.loading,
                                 peaks_of(context, transmission, band), 0, band)
      .amplitude;
}

const AnalysisRun transmissibility_run =
    computed_by<&project::Analyses::transmissibility, &CaseResults::transmissibility, transmissibility_result>(
        "force or motion that the mounts transmit",
        "transmissibility: no force or base motion given; add transmissibility = "
        "{force = \"EXCITATION\"} or {base = \"z\"} to [analyses]");

}  // namespace trivet::study
