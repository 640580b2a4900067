// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/elements/character.h"
#include "trivet/elements/matrix_checks.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// What an element does in one undamped mode of its model.
struct ElementInMode {
  int number = 0;
  std::string name;
  std::optional<double> angular_frequency;  ///< [rad/s]; none if the motion grows
  double share = 0;                         ///< of the strain energy of the whole mode
  elements::EnergyShares inside;            ///< of the element's own; only meaningful where it deforms
};

/// What an element is and does in its model; stiffness in its local frame, order N, K, scale included.
struct ElementSummary {
  elements::Matrix12 stiffness;
  elements::MatrixVerdict verdict;  ///< of the stiffness
  elements::Character character;
  std::vector<ElementInMode> modes;  ///< of those with strain energy
  foundation::Problems warnings;     ///< of this element alone
};
[[nodiscard]] ElementSummary element_summary(const project::Case& variant, std::size_t element);

/// The checks of one of an element's matrices; its stiffness may ask for what turning its preload takes.
[[nodiscard]] elements::MatrixVerdict matrix_verdict(const project::Case& variant, const model::Element& element,
                                                     const elements::Matrix12& matrix);

/// "u_x", "θ_z": the displacement component 0 … 11 of an element, end left out.
[[nodiscard]] std::string component_name(int component);

}  // namespace trivet::study
