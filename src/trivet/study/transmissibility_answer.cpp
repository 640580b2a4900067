// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/transmissibility_answer.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/motion_words.h"
#include "trivet/project/analyses/transmissibility_question.h"
#include "trivet/response/steady/resonant_mode.h"
#include "trivet/study/question_answer.h"

namespace trivet::study {
namespace {

std::string direction_words(const response::Direction& direction) {
  return (direction.rotation ? "about " : "along ") + modal::direction_words(direction.axis.normalized());
}

TransmissibilityResult answer_transmissibility(const CaseContext& c, const project::TransmissibilityQuestion& asked,
                                               foundation::Problems&) {
  const bool force = !asked.force.empty();
  if (!force) require_rigid_ground(c, "transmissibility");
  const response::Transmission transmission = force
      ? response::force_transmission(c.system, c.assembled, response::applied_force(c.system, asked.force))
      : response::displacement_transmission(c.system, c.assembled, asked.selection.of, asked.direction);
  TransmissibilityResult result;
  result.of_force = force;
  result.words = force ? "force on the ground over \"" + asked.force + "\""
                       : "motion over a motion of the ground " + direction_words(asked.direction);
  result.band = asked.band ? *asked.band : default_band(c);
  if (!(result.band.from < result.band.to))
    throw foundation::NotComputable(
        "transmissibility: the tables of the elements and the natural frequencies have no band in common; give a band");
  result.peaks = response::peaks(c.assembled, transmission.channels, transmission.loading, c.modes, c.roots(),
                                 {.search_to = result.band.to}, c.progress);
  response::set_nearest_modes(c.assembled, transmission.channels, transmission.loading, c.modes, result.peaks);
  result.curves = response::frequency_response(
      c.assembled, transmission.channels, transmission.loading,
      grid_over(c, transmission.channels, transmission.loading, result.peaks, result.band));
  result.crossovers = response::crossovers(c.assembled, transmission, result.peaks);
  return result;
}

}  // namespace

const QuestionAnswer transmissibility_answer =
    answered_by<answer_transmissibility>("force or motion that the mounts transmit",
                                         "transmissibility: no force or base motion given; add transmissibility = "
                                         "{force = \"EXCITATION\"} or {base = \"z\"} to [analyses]");

}  // namespace trivet::study
