// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/case_context.h"

namespace trivet::study {

response::EarthquakeResponse earthquake_answer(const CaseContext& c, const project::EarthquakeRequest& request, foundation::Problems& warnings) {
  require_rigid_ground(c, "earthquake");
  spatial::Vector6 direction = spatial::Vector6::Zero();
  direction.head<3>() = request.direction;
  response::EarthquakeResponse result = response::earthquake_response(c.assembled, channels_of(c, request.wanted), request.spectrum, direction);
  warnings.add(result.warnings);
  if (!(result.effective_mass_share > 0)) throw foundation::NotComputable("earthquake: the spectrum reaches none of the modes that this motion of the ground drives");
  return result;
}

}  // namespace trivet::study
