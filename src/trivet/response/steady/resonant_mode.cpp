// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/resonant_mode.h"

#include <cmath>
#include <limits>
#include <optional>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/numerics/linalg/sparse_system.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::response {
namespace {

/// d²q/dω² of the coordinates, and the terms of a channel.
struct Curvature {
  Eigen::VectorXcd coordinates, channel;
};

/// @throws NotComputable at a resonance that is undamped except for round-off
Curvature exact_curvature(const assembly::Assembled& assembled, const assembly::Channel& channel,
                          const assembly::Loading& loading, double omega) {
  const Dynamics d = dynamics(assembled, channel, loading, omega, element_jets(assembled, omega));
  return {motion(d).coordinates[2], d.channel[0]};
}

/// The same for constant matrices, in coordinates of unit mass diagonal.
class ConstantSystem {
 public:
  ConstantSystem(const numerics::DynamicMatrices& matrices, const numerics::Load& load)
      : scale_(numerics::unit_scale(matrices)),
        system_(numerics::scaled(matrices, scale_)),
        load_(load.scaled(scale_)) {}

  /// @throws NotComputable at a resonance that is undamped except for round-off
  [[nodiscard]] Curvature curvature(const assembly::Channel& channel, double omega) const {
    constexpr double largest_condition = 1 / (4 * std::numeric_limits<double>::epsilon());
    const numerics::SystemFactors factors = system_.factors(omega);
    const numerics::Jet<Eigen::VectorXcd> h = numerics::load_jet(load_, omega);
    const Eigen::VectorXcd q = factors.solve(h[0]);
    if (!(q.norm() * system_.largest_entry(omega) < largest_condition * h[0].norm()))
      throw foundation::NotComputable("an undamped resonance");
    const Eigen::VectorXcd rate = factors.solve(h[1] - system_.product(1, omega, q));
    const Eigen::VectorXcd right = h[2] - 2 * system_.product(1, omega, rate) - system_.product(2, omega, q);
    return {scale_.asDiagonal() * factors.solve(right), numerics::terms_jet(channel, system_.size(), omega)[0]};
  }

 private:
  Eigen::VectorXd scale_;
  numerics::SparseSystem system_;
  numerics::Load load_;
};

/// The mode whose part of the result has the largest curvature, if that is more than half of the whole.
std::optional<int> mode_of_largest_curvature(const assembly::Assembled& assembled, const modal::Modes& modes,
                                             const Curvature& of_result) {
  constexpr double enough = 0.5;
  const Eigen::Index n = of_result.coordinates.size();
  const Eigen::MatrixXd A = assembled.matrices.A.topLeftCorner(n, n);
  const Eigen::VectorXd real = A * of_result.coordinates.real(), imaginary = A * of_result.coordinates.imag(),
                        channel_real = of_result.channel.real(), channel_imaginary = of_result.channel.imag();
  std::optional<int> best;
  double most = enough * std::abs(of_result.channel.cwiseProduct(of_result.coordinates).sum());
  for (const modal::Mode& mode : modes.list) {
    const auto shape = mode.coordinates.head(n);
    const double part = std::hypot(shape.dot(channel_real), shape.dot(channel_imaginary)) *
        std::hypot(shape.dot(real), shape.dot(imaginary));
    if (!(part > most)) continue;
    most = part;
    best = mode.number;
  }
  return best;
}

}  // namespace

void set_nearest_modes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                       const assembly::Loading& loading, const modal::Modes& modes, Peaks& peaks) {
  const auto massive = to_index(numerics::massive_rows(assembled.matrices.A).size());
  std::optional<ConstantSystem> system;
  if (!assembled.frequency_dependent()) system.emplace(assembled.matrices, assembly::right_side(assembled, loading));
  for (Peak& peak : peaks.list) {
    const double omega = peak.angular_frequency;
    foundation::report_progress(
        foundation::thread_progress(), "modes of peaks",
        static_cast<double>(&peak - peaks.list.data()) / static_cast<double>(peaks.list.size()));
    peak.nearest_mode = modal::nearest_mode(modes, omega, massive);
    if (std::isinf(peak.amplitude)) continue;
    try {
      const assembly::Channel& channel = channels[peak.curve];
      peak.nearest_mode = mode_of_largest_curvature(
          assembled, modes,
          system ? system->curvature(channel, omega) : exact_curvature(assembled, channel, loading, omega));
    } catch (const foundation::NotComputable&) {  // so narrow that the nearest frequency is certain
    }
  }
}

}  // namespace trivet::response
