// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/static_stiffness.h"

#include <algorithm>
#include <utility>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::model {
namespace {

/// Projector on the deformations of an element: its part against rigid motions is that of forces at rest, which do not
/// stiffen.
elements::Matrix12 deformation_projector(const Span& between) {
  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions(between.arm, between.n_from_k);
  const elements::Matrix6 metric = rigid.transpose() * rigid;
  return elements::Matrix12::Identity() - rigid * numerics::inverse(metric) * rigid.transpose();
}

}  // namespace

bool has_static_stiffness(const System& system) {
  const std::vector<Element>& elements = system.elements();
  return std::ranges::any_of(elements, [](const Element& one) { return one.stiffening != 1; }) &&
      std::ranges::none_of(elements, has_laws);
}

System with_static_stiffness(const System& system) {
  Description description = system.description();
  for (Element& element : description.elements) {
    if (element.stiffening == 1) continue;
    const elements::Matrix12 deformation = deformation_projector(span(description.bodies, element.n, element.k));
    element.law.nominal_stiffness -=
        (1 - 1 / element.stiffening) * deformation.transpose() * element.law.nominal_stiffness * deformation;
    element.stiffening = 1;
  }
  return system.in_other_state(std::move(description));
}

}  // namespace trivet::model
