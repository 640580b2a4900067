// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/case_context.h"

namespace trivet::study {

std::vector<response::DeflectionShape> shapes_answer(const CaseContext& c, const project::ShapesRequest& request) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, request.excitations);
  if (loading.vanishes()) throw foundation::NotComputable("shapes: the model has no harmonic excitation");
  std::vector<response::DeflectionShape> shapes;
  for (const double omega : request.at) shapes.push_back(response::deflection_shape(c.system, c.assembled, loading, omega));
  return shapes;
}

}  // namespace trivet::study
