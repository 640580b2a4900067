// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/earthquake.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/response/transient/transient_refusals.h"

namespace trivet::response {
namespace {

using foundation::two_pi;

/// Modes with ω > 0 and their shapes over all free coordinates.
struct ShakenModes {
  std::vector<ModalShare> shares;
  Eigen::MatrixXd shapes;
};

ShakenModes shaken_modes(const assembly::Assembled& assembled, const spatial::Vector6& direction) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  const numerics::MassiveSystem massive = numerics::massive_system(m);
  const numerics::GeneralizedModes modes = numerics::generalized_modes(massive.K, massive.A, m.symmetric);
  if (!m.symmetric || modes.route != numerics::ModeRoute::definite_mass)
    throw foundation::NotComputable(
        "earthquake: modal maxima need symmetric matrices and a positive definite mass; use a time history instead");
  Eigen::VectorXd g = Eigen::VectorXd::Zero(assembled.ground.size());
  g.head<6>() = direction;
  const Eigen::VectorXd stiffness_load = assembled.ground.K * g, mass_load = assembled.ground.A * g;
  ShakenModes result;
  result.shapes.resize(m.size(), modes.lambda.size());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < modes.lambda.size(); ++i) {
    if (!(modes.lambda(i) > 0)) continue;
    const Eigen::VectorXd shape = massive.recovery * modes.shapes.col(i);
    const double omega = std::sqrt(modes.lambda(i));
    double lost = shape.dot(m.B * shape) / omega;
    if (m.lossy()) lost += shape.dot(m.K_loss * shape) / modes.lambda(i);
    // φᵀA r = φᵀK r/ω² and K r = −K_fg e: the motion r is not needed.
    const double participation = shape.dot(mass_load) - shape.dot(stiffness_load) / modes.lambda(i);
    result.shares.push_back(
        {omega, lost / 2, participation, participation * participation, std::numeric_limits<double>::quiet_NaN()});
    result.shapes.col(count++) = shape;
  }
  result.shapes.conservativeResize(Eigen::NoChange, count);
  return result;
}

/// Sets S_a of each mode and returns the indices of the modes that have one.
std::vector<Eigen::Index> read_spectrum(const excitation::ResponseSpectrum& spectrum, EarthquakeResponse& result) {
  std::vector<Eigen::Index> reached;
  constexpr double negligible =
      1e-3;  // of the moving mass: an overdamped mode with less is excluded like one outside the spectrum
  double total = 0, effective = 0;
  for (const ModalShare& mode : result.modes) total += mode.effective_mass;
  for (std::size_t i = 0; i < result.modes.size(); ++i) {
    ModalShare& mode = result.modes[i];
    if (!(mode.damping_ratio < 1) && mode.effective_mass < negligible * total) continue;
    if (mode.angular_frequency < spectrum.angular_frequencies.front() ||
        mode.angular_frequency > spectrum.angular_frequencies.back())
      continue;
    if (!(mode.damping_ratio < 1))
      throw foundation::NotComputable(
          fmt::format("earthquake: the mode at {:.4g} Hz does not oscillate (damping ratio {:.3g}), so a response "
                      "spectrum does not apply to it",
                      mode.angular_frequency / two_pi, mode.damping_ratio));
    mode.spectral_acceleration = excitation::spectral_acceleration(spectrum, mode.angular_frequency);
    effective += mode.effective_mass;
    reached.push_back(to_index(i));
  }
  result.effective_mass_share = total > 0 ? effective / total : 0;
  assert(result.effective_mass_share >= 0 && result.effective_mass_share <= 1 + 1e-12);
  return reached;
}

void add_warnings(const excitation::ResponseSpectrum& spectrum, const std::vector<Eigen::Index>& reached,
                  EarthquakeResponse& result) {
  constexpr double enough_mass = 0.9;        // the usual requirement of building codes
  constexpr double damping_tolerance = 0.2;  // S_a varies about with the square root of the damping ratio, or less
  if (result.effective_mass_share < enough_mass)
    result.warnings.warning(
        "earthquake",
        fmt::format("the spectrum covers modes with {:.0f} % of the effective mass", 100 * result.effective_mass_share),
        "modes outside its table are excluded; codes usually require 90 %",
        "extend the table, especially to short periods");
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const Eigen::Index i : reached) {
    const ModalShare& mode = result.modes[i];
    if (mode.effective_mass == 0) continue;
    lowest = std::min(lowest, mode.damping_ratio);
    highest = std::max(highest, mode.damping_ratio);
  }
  if (reached.empty() ||
      (lowest >= (1 - damping_tolerance) * spectrum.damping_ratio &&
       highest <= (1 + damping_tolerance) * spectrum.damping_ratio))
    return;
  result.warnings.warning(
      "earthquake",
      fmt::format("modal damping ratios {:.3g} … {:.3g}, spectrum for {:.3g}", lowest, highest, spectrum.damping_ratio),
      "the spectrum is used as given, not converted to other damping", "give a spectrum for the damping of the model");
}

}  // namespace

EarthquakeResponse earthquake_response(const assembly::Assembled& given, const std::vector<assembly::Channel>& channels,
                                       const excitation::ResponseSpectrum& spectrum,
                                       const spatial::Vector6& direction) {
  foundation::refuse_errors(excitation::check(spectrum, "response spectrum"));
  if (!direction.allFinite() || direction.isZero(0))
    throw foundation::InvalidInput("earthquake: the direction must be finite and not zero");
  const assembly::Assembled assembled = nearest_linear(given);
  const ShakenModes modes = shaken_modes(assembled, direction);
  EarthquakeResponse result;
  result.modes = modes.shares;
  assert(to_index(result.modes.size()) == modes.shapes.cols() && "one shape for each mode that oscillates");
  const std::vector<Eigen::Index> reached = read_spectrum(spectrum, result);
  add_warnings(spectrum, reached, result);
  if (given.frequency_dependent())
    result.warnings.warning("earthquake", "frequency-dependent elements are replaced by their nearest linear system",
                            "modes need constant matrices", "compare with a time history");
  const auto count = to_index(reached.size());
  Eigen::VectorXd omega(count), zeta(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const ModalShare& mode = result.modes[reached[k]];
    omega(k) = mode.angular_frequency;
    zeta(k) = mode.damping_ratio;
  }
  for (const assembly::Channel& each : channels) {
    const assembly::Channel channel = nearest_linear(given, each);
    if (channel.on_displacement.isZero(0) && !channel.ground.empty())
      throw foundation::NotComputable(fmt::format(
          "earthquake: \"{}\" is a motion of the ground alone, which a response spectrum does not give", channel.name));
    CombinedChannel channel_result{channel.name, channel.unit, Eigen::VectorXd(count), 0, 0};
    for (Eigen::Index k = 0; k < count; ++k) {
      const ModalShare& mode = result.modes[reached[k]];
      const Eigen::VectorXd shape = modes.shapes.col(reached[k]);
      const double squared = omega(k) * omega(k), motion = mode.participation * mode.spectral_acceleration / squared;
      channel_result.modal_maxima(k) = std::pow(omega(k), channel.derivative) * motion *
          (channel.on_displacement.real().dot(shape) - squared * channel.on_acceleration.dot(shape));
    }
    channel_result.square_root_of_sum_of_squares =
        excitation::square_root_of_sum_of_squares(channel_result.modal_maxima);
    channel_result.complete_quadratic =
        excitation::complete_quadratic_combination(channel_result.modal_maxima, omega, zeta);
    result.channels.push_back(std::move(channel_result));
  }
  return result;
}

}  // namespace trivet::response
