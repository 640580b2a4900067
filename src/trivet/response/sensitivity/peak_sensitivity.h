// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/interruption.h"
#include "trivet/response/sensitivity/model_parameters.h"

namespace trivet::response {

/// The load of a model; asked again for a changed model.
using LoadOf = std::function<assembly::Loading(const model::System&, const assembly::Assembled&)>;

/// Which answers under which load are looked at.
struct Question {
  std::vector<std::string> channels;  ///< full channel names
  assembly::Quantity quantity = assembly::Quantity::displacement;
  LoadOf load;
};

/// A maximum of |y(ω)|.
struct PeakPlace {
  std::size_t channel = 0;            ///< of the question
  double angular_frequency = 0;       ///< [rad/s], > 0
  std::optional<int> unbounded_mode;  ///< the undamped mode that stands there without damping: |y| is infinite
};

/// What one parameter does to one peak, to first order, exact derivatives: per unit of the parameter's amount.
struct Sensitivity {
  std::size_t parameter = 0;        ///< of the list
  std::optional<double> height;     ///< d ln|y| at the peak; none where |y| is infinite
  std::optional<double> frequency;  ///< d ln ω of the peak; none where ω is no smooth maximum, or a repeated root
};

struct PeakSensitivities {
  std::vector<Sensitivity> list;   ///< as the parameters
  std::vector<std::string> notes;  ///< why something is missing
};

struct SensitivityTable {
  std::vector<Parameter> parameters;
  std::vector<PeakSensitivities> peaks;
};

/// Sensitivities of every peak to every parameter. At a maximum the height changes as |y| at fixed ω (the shift of the
/// maximum is of second order); y = cᵀq, Zq = h gives dy = λᵀ(dh − dZ q) + dcᵀq with Zᵀλ = c. The frequency moves by
/// −F_ωp/F_ωω of F = |y|². An unbounded peak moves with its mode: dω = −φᵀ dZ φ / φᵀ Z_ω φ. dZ, dc, dh are fourth-order
/// differences of the assembled model, to which all parameters but system damping and the mass of elements contribute
/// as polynomials: there they are exact to round-off. Only the first derivative of the model is taken numerically,
/// never that of the resonance, so light damping costs nothing.
[[nodiscard]] SensitivityTable peak_sensitivities(const model::System& system, const assembly::Assembled& assembled,
                                                  const Question& question, const std::vector<PeakPlace>& peaks,
                                                  const foundation::Progress& progress = {});

}  // namespace trivet::response
