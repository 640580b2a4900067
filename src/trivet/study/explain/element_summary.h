// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/elements/checks.h"
#include "trivet/elements/stiffness_properties.h"
#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"
#include "trivet/nonlinear/laws/law_harmonics.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// An element's part in one undamped mode of its model.
struct ElementInMode {
  int number = 0;
  std::string name;
  std::optional<double> angular_frequency;  ///< [rad/s]; none if the motion is unstable
  double share = 0;                         ///< of the strain energy of the whole mode
  double of_stored = 0;                     ///< the same of what is stored (modal/modes.h), ≤ 1
  elements::EnergyShares inside;            ///< shares of the element's own energy; only meaningful if it deforms
};

/// Laws of an element over one of its deflections.
struct ElementLaws {
  std::string axis;     ///< "x" … "rz", axes of K; "distance" of the ends (strut); "across" e3 (ring)
  std::string words;    ///< "along x", "about x", "over the distance of its ends", "across its axis"
  bool turns = false;   ///< a rotation
  double at_rest = 0;   ///< deflection [m, rad]; of a strut beyond its free length
  bool damped = false;  ///< it has dampers too, which are not in the loops
  bool whole = false;   ///< the loops are of the whole force along the axis; else in addition to the stiffness
  std::vector<nonlinear::LawLoop> loops;
};
[[nodiscard]] std::vector<ElementLaws> element_laws(const project::Case& variant, std::size_t element);

/// Of an element with nonlinear inner parts; empty for others. From 1 Hz to beyond its inner resonances.
[[nodiscard]] std::vector<nonlinear::AmplitudeStiffness> stiffness_over_amplitude(const project::Case& variant,
                                                                                  std::size_t element);

/// Properties of an element and its part in its model; stiffness in its local frame, order N, K, scale included.
struct ElementSummary {
  elements::Matrix12 stiffness;
  elements::MatrixVerdict verdict;  ///< of the stiffness
  elements::StiffnessProperties stiffness_properties;
  std::vector<ElementInMode> modes;                           ///< modes with strain energy
  std::vector<ElementLaws> laws;                              ///< nonlinear ones
  std::vector<nonlinear::AmplitudeStiffness> over_amplitude;  ///< of nonlinear inner parts
  foundation::Problems warnings;                              ///< of this element only
};
[[nodiscard]] ElementSummary element_summary(const project::Case& variant, std::size_t element);

/// Checks of one matrix of an element; its stiffness may include the forces that rotate its preload.
[[nodiscard]] elements::MatrixVerdict matrix_verdict(const project::Case& variant, const model::Element& element,
                                                     const elements::Matrix12& matrix);

/// "u_x", "θ_z": name of the displacement component 0 … 11 of an element, without its end.
[[nodiscard]] std::string component_name(int component);

}  // namespace trivet::study
