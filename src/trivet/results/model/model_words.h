// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::results {

/// The nonlinear laws of an element with their numbers in SI, one per law: "law along z", "gap stop: …".
[[nodiscard]] std::vector<model::Fact> law_facts(const model::Element& element);

/// "loss factor 0.1", "viscous matrix", "none" …
[[nodiscard]] std::string damping_words(const elements::Damping& damping);
[[nodiscard]] std::string damping_words(const model::SystemDamping& damping);

/// An excitation in plain numbers: real amplitudes keep their signs, complex ones are split into magnitude and phase.
struct ExcitationNumbers {
  std::string type;                 ///< "harmonic", "unbalance", "base", "orders", "random", "time"
  Eigen::Vector3d linear, angular;  ///< force and moment, or translation and rotation
  std::string linear_unit, angular_unit;
  Eigen::VectorXd phase;  ///< [rad], of the six components
};
[[nodiscard]] ExcitationNumbers excitation_numbers(const model::Excitation& excitation);

/// What an excitation does over speed, frequency or time: each order at 1 rad/s or its fixed part, the range and rms of
/// a spectrum, the length and largest value of a history, the service speed of a rotor. Empty if nothing is left to
/// say.
[[nodiscard]] std::vector<model::Fact> course_facts(const model::Excitation& excitation);

}  // namespace trivet::results
