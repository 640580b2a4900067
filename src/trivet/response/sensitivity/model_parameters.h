// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::response {

/// One number of a model that a design may change. The model is a smooth function of `amount`, which is 0 for the given
/// model.
struct Parameter {
  std::string name;    ///< its path in the project file, for --set, cases and maps: "elements.front.scale",
                       ///< "elements.front.stiffness_factor.z"
  std::string change;  ///< `size` as text: "+1 %", "+1 mm"
  double size = 0;     ///< a typical change in the unit of `amount`: 0.01 relative, or 1e-3 m
  double step = 0;     ///< of difference quotients, in the same unit
  std::function<void(model::Description&, double amount)> apply;
  std::optional<std::size_t> law;  ///< the element with the changed law
};

/// Parameters of a system. Elements: stiffness as a whole (`scale`; for a preloaded one the deformation stiffness, with
/// the preload kept) and by direction, damping, and place. Bodies: mass, centre of mass, and inertia about the centre
/// of mass, each with the others kept (adjustments.h). System: its damping.
[[nodiscard]] std::vector<Parameter> model_parameters(const model::System& system);

/// The model with one parameter changed. @throws NotComputable with the reason if the result is not a valid model
[[nodiscard]] model::System changed(const model::System& system, const Parameter& parameter, double amount);

}  // namespace trivet::response
