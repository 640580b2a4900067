// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::response {

/// One number of a model that a design may change, and how. All smooth functions of `amount`, which is 0 for the model
/// as it is.
struct Parameter {
  std::string name;    ///< its path in the project file, for --set, cases and maps: "elements.front.scale",
                       ///< "elements.front.stiffness_factor.z"
  std::string change;  ///< what `size` means, for reading: "+1 %", "+1 mm"
  double size = 0;     ///< a change that is worth telling, in the unit of `amount`: 0.01 relative, or 1e-3 m
  double step = 0;     ///< of difference quotients, in the same unit
  std::function<void(model::Description&, double amount)> apply;
  std::optional<std::size_t> law;  ///< the element whose law it changes
};

/// Of every element: its stiffness as a whole (`scale`; of a preloaded one its deformation stiffness, the preload kept)
/// and by direction, its damping, and its place. Of every body: mass, centre of mass, and inertia about the centre of
/// mass, each with the others kept (adjustments.h). Of the system: its damping.
[[nodiscard]] std::vector<Parameter> model_parameters(const model::System& system);

/// The model with one parameter changed. @throws NotComputable if that is no model, with the reason
[[nodiscard]] model::System changed(const model::System& system, const Parameter& parameter, double amount);

}  // namespace trivet::response
