// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/earthquake_question.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {
namespace {

response::EarthquakeResponse answer_earthquake(const CaseContext& c, const project::EarthquakeQuestion& asked,
                                               foundation::Problems& warnings) {
  require_rigid_ground(c, "earthquake");
  spatial::Vector6 direction = spatial::Vector6::Zero();
  direction.head<3>() = asked.direction;
  response::EarthquakeResponse result =
      response::earthquake_response(c.assembled, channels_of(c, asked.selection), asked.spectrum, direction);
  warnings.add(result.warnings);
  if (!(result.effective_mass_share > 0))
    throw foundation::NotComputable(
        "earthquake: the spectrum covers none of the modes that this ground motion excites");
  return result;
}

}  // namespace

const QuestionAnswer earthquake_answer =
    answered_by<answer_earthquake>("largest response to an earthquake, from its response spectrum",
                                   "earthquake: no spectrum given; add earthquake = {direction = \"x\", rows = "
                                   "[[0.02, 3], [0.1, 9], …]} to [analyses]");

}  // namespace trivet::study
