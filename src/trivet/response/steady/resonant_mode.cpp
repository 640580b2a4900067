// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/resonant_mode.h"

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::response {
namespace {

/// @throws NotComputable at a resonance that is undamped except for round-off
std::optional<int> most_bent(const assembly::Assembled& assembled, const modal::Modes& modes,
                             const Dynamics& dynamics) {
  constexpr double enough = 0.5;
  const Eigen::VectorXcd bend = motion(dynamics).coordinates[2];  // d²q/dω²
  const Eigen::VectorXcd& channel = dynamics.channel[0];
  const Eigen::Index n = bend.size();
  const Eigen::VectorXcd momentum = assembled.matrices.A.topLeftCorner(n, n) * bend;
  std::optional<int> best;
  double most = enough * std::abs(channel.cwiseProduct(bend).sum());
  for (const modal::Mode& mode : modes.list) {
    const Eigen::VectorXcd shape = mode.coordinates.head(n).cast<std::complex<double>>();
    const double part = std::abs(channel.cwiseProduct(shape).sum() * shape.cwiseProduct(momentum).sum());
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
  for (Peak& peak : peaks.list) {
    const double omega = peak.angular_frequency;
    peak.nearest_mode = modal::nearest_mode(modes, omega, massive);
    if (std::isinf(peak.amplitude)) continue;
    try {
      peak.nearest_mode = most_bent(
          assembled, modes, dynamics(assembled, channels[peak.curve], loading, omega, element_jets(assembled, omega)));
    } catch (const foundation::NotComputable&) {  // so narrow that the nearest frequency is certain
    }
  }
}

}  // namespace trivet::response
