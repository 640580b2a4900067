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

/// Returns the load of a model; called again for a changed model.
using LoadOf = std::function<assembly::Loading(const model::System&, const assembly::Assembled&)>;

/// Returns a model with one parameter changed.
using ChangedModel = std::function<model::System(const model::System&, const Parameter&, double amount)>;

/// The results and the load to examine.
struct SensitivityRequest {
  std::vector<std::string> channels;  ///< full channel names
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  LoadOf load;
  ChangedModel changed = response::changed;
};

/// A maximum of |y(ω)|.
struct PeakPlace {
  std::size_t channel = 0;            ///< index in SensitivityRequest::channels
  double angular_frequency = 0;       ///< [rad/s], > 0
  std::optional<int> unbounded_mode;  ///< the undamped mode at this frequency, if |y| is infinite there
};

/// First-order effect of one parameter on one peak: exact derivatives per unit of the parameter's amount.
struct Sensitivity {
  std::size_t parameter = 0;        ///< index in the list of parameters
  std::optional<double> height;     ///< d ln|y| at the peak; empty if |y| is infinite
  std::optional<double> frequency;  ///< d ln ω of the peak; empty if ω is not a smooth maximum, or is a repeated root
};

struct PeakSensitivities {
  std::vector<Sensitivity> list;   ///< in the order of the parameters
  std::vector<std::string> notes;  ///< why a value is missing
};

struct SensitivityTable {
  std::vector<Parameter> parameters;
  std::vector<PeakSensitivities> peaks;
};

/// Sensitivities of every peak to every parameter. At a maximum the height changes like |y| at fixed ω (the shift of
/// the maximum is of second order); y = cᵀq, Zq = h gives dy = λᵀ(dh − dZ q) + dcᵀq with Zᵀλ = c. The frequency moves
/// by −F_ωp/F_ωω with F = |y|². An unbounded peak moves with its mode: dω = −φᵀ dZ φ / φᵀ Z_ω φ. dZ, dc, dh are
/// fourth-order differences of the assembled model. They are exact to round-off, because the model is polynomial in all
/// parameters except system damping, the mass of elements, and tangents that follow the position of rest. Only the
/// first derivative of the model is numerical, never that of the resonance, so light damping costs no accuracy.
[[nodiscard]] SensitivityTable peak_sensitivities(const model::System& system, const assembly::Assembled& assembled,
                                                  const SensitivityRequest& request,
                                                  const std::vector<PeakPlace>& peaks,
                                                  const foundation::Progress& progress = {});

}  // namespace trivet::response
