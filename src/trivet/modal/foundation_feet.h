// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/layout.h"
#include "trivet/foundation/index.h"
#include "trivet/model/system.h"

namespace trivet::modal {

/// Elements whose end N is on a flexible foundation.
[[nodiscard]] inline std::vector<std::size_t> elements_on_foundations(const model::System& system) {
  std::vector<std::size_t> list;
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (!system.elements()[e].is_foundation && system.elements()[e].n.foundation) list.push_back(e);
  return list;
}

/// Motion of the ends N of these elements in a free motion of all coordinates: 6 × elements, ground axes.
template <typename Vector>
[[nodiscard]] Eigen::Matrix<typename Vector::Scalar, 6, Eigen::Dynamic> foundation_feet(const model::System& system,
                                                                                        const assembly::Layout& layout,
                                                                                        const Vector& coordinates) {
  const std::vector<std::size_t> elements = elements_on_foundations(system);
  Eigen::Matrix<typename Vector::Scalar, 6, Eigen::Dynamic> feet(6, to_index(elements.size()));
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const model::OnFoundation& on = *system.elements()[elements[i]].n.foundation;
    feet.col(to_index(i)) = on.shape.template cast<typename Vector::Scalar>() *
        coordinates.segment(layout.foundation_row(on.foundation), on.shape.cols());
  }
  return feet;
}

}  // namespace trivet::modal
