// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/shapes_question.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {
namespace {

std::vector<response::DeflectionShape> answer_shapes(const CaseContext& c, const project::ShapesQuestion& asked,
                                                     foundation::Problems&) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, asked.selection.excitations);
  if (loading.vanishes()) throw without_excitation("shapes");
  std::vector<response::DeflectionShape> shapes;
  for (const double omega : asked.at)
    shapes.push_back(response::deflection_shape(c.system, c.assembled, loading, omega));
  return shapes;
}

}  // namespace

const QuestionAnswer shapes_answer = answered_by<answer_shapes>(
    "operating deflection shapes", "shapes: no frequencies given; add shapes = {at = [\"25 Hz\"]} to [analyses]");

}  // namespace trivet::study
