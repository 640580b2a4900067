// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/resonant_mode.h"

#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/sparse_system.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::response {
namespace {

/// d²q/dω² of the coordinates, and the terms of a channel.
struct Bend {
  Eigen::VectorXcd coordinates, channel;
};

/// @throws NotComputable at a resonance that is undamped except for round-off
Bend exact_bend(const assembly::Assembled& assembled, const assembly::Channel& channel,
                const assembly::Loading& loading, double omega) {
  const Dynamics d = dynamics(assembled, channel, loading, omega, element_jets(assembled, omega));
  return {motion(d).coordinates[2], d.channel[0]};
}

/// The same for constant matrices.
Bend bend(const numerics::SparseSystem& system, const numerics::Load& load, const assembly::Channel& channel,
          double omega) {
  constexpr double largest_condition = 1 / (4 * std::numeric_limits<double>::epsilon());
  const numerics::SystemFactors factors = system.factors(omega);
  const numerics::Jet<Eigen::VectorXcd> h = numerics::load_jet(load, omega);
  const Eigen::VectorXcd q = factors.solve(h[0]);
  if (!(q.norm() * system.largest_entry(omega) < largest_condition * h[0].norm()))
    throw foundation::NotComputable("an undamped resonance");
  const Eigen::VectorXcd rate = factors.solve(h[1] - system.product(1, omega, q));
  const Eigen::VectorXcd right = h[2] - 2 * system.product(1, omega, rate) - system.product(2, omega, q);
  return {factors.solve(right), numerics::terms_jet(channel, system.size(), omega)[0]};
}

/// The mode whose part of the channel bends most, if that is more than half of the whole bend.
std::optional<int> most_bent(const assembly::Assembled& assembled, const modal::Modes& modes, const Bend& bend) {
  constexpr double enough = 0.5;
  const Eigen::Index n = bend.coordinates.size();
  const Eigen::MatrixXd A = assembled.matrices.A.topLeftCorner(n, n);
  const Eigen::VectorXd real = A * bend.coordinates.real(), imaginary = A * bend.coordinates.imag(),
                        channel_real = bend.channel.real(), channel_imaginary = bend.channel.imag();
  std::optional<int> best;
  double most = enough * std::abs(bend.channel.cwiseProduct(bend.coordinates).sum());
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
  const bool constant = !assembled.frequency_dependent();
  const numerics::SparseSystem system(constant ? assembled.matrices : assembled.constant);
  const numerics::Load load = assembly::right_side(assembled, loading);
  for (Peak& peak : peaks.list) {
    const double omega = peak.angular_frequency;
    peak.nearest_mode = modal::nearest_mode(modes, omega, massive);
    if (std::isinf(peak.amplitude)) continue;
    try {
      const assembly::Channel& channel = channels[peak.curve];
      peak.nearest_mode =
          most_bent(assembled, modes,
                    constant ? bend(system, load, channel, omega) : exact_bend(assembled, channel, loading, omega));
    } catch (const foundation::NotComputable&) {  // so narrow that the nearest frequency is certain
    }
  }
}

}  // namespace trivet::response
