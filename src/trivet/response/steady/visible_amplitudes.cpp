// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/visible_amplitudes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/peaks/extremum.h"
#include "trivet/response/steady/exact_response.h"

namespace trivet::response {

namespace {

/// Amplitudes of channels in the coordinates of the loading.
Eigen::VectorXd visible_in(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                           const assembly::Loading& loading, double omega) {
  const Eigen::MatrixXcd stiffness = assembled.dynamic_stiffness(omega, omega);
  const Eigen::VectorXd unit = numerics::unit_scale(assembled.matrices).head(stiffness.rows());
  const Eigen::VectorXcd load = unit.asDiagonal() * assembly::exact_right_side(assembled, loading, omega, omega);
  const Eigen::VectorXcd scaled =
      numerics::pivoted_solution(unit.asDiagonal() * stiffness * unit.asDiagonal(), load, false).x;
  const Eigen::VectorXd together = scaled.cwiseAbs().maxCoeff() * unit;
  const ExactValues exact = exact_values(assembled, channels, loading, unit.asDiagonal() * scaled, omega);
  const Eigen::VectorXd ground = loading.motion.vanishes() ? Eigen::VectorXd() : loading.motion.possible(omega);
  Eigen::VectorXd amplitudes = exact.values.cwiseAbs();
  for (Eigen::Index c = 0; c < amplitudes.size(); ++c) {
    const auto curve = channels[c].curve();
    const double possible = std::max(
        exact.possible(c),
        numerics::possible_amplitudes(curve, together, ground, Eigen::RowVectorXd::Constant(1, omega)).value());
    if (amplitudes(c) <= numerics::vanishing_share * possible) amplitudes(c) = 0;
  }
  return amplitudes;
}

}  // namespace

Eigen::VectorXd visible_amplitudes(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                   const assembly::Loading& loading, double omega) {
  Eigen::VectorXd result(std::ssize(channels));
  for (const assembly::ChannelGroup& group : assembly::by_coordinates(assembled.ground, channels, loading)) {
    const Eigen::VectorXd part = visible_in(assembled, group.channels, group.loading, omega);
    for (Eigen::Index k = 0; k < part.size(); ++k) result(to_index(group.which[k])) = part(k);
  }
  return result;
}

namespace {

constexpr double near = 1e3, far = 1e5;  // times the outermost root: there the powers of ω are pure, and their smallest
                                         // share, 1e-10, is far above round-off
constexpr double falls = 0.1;   // ratio from near to far; the slowest vanishing power, the first, falls to 0.01
constexpr double aside = 1.13;  // times the middle between the roots, which may be a single undamped root

struct RootRange {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
};

RootRange range_of(const modal::Roots& roots) {
  RootRange range;
  for (const modal::Root& root : roots.list)
    range = {std::min(range.lowest, std::abs(root.eigenvalue)), std::max(range.highest, std::abs(root.eigenvalue))};
  return range.highest > 0 ? range : RootRange{1, 1};
}

}  // namespace

std::vector<bool> vanish_at_both_ends(const assembly::Assembled& assembled,
                                      const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                                      const modal::Roots& roots) {
  std::vector<bool> vanish(channels.size(), false);
  const bool free =
      std::ranges::any_of(roots.list, [](const modal::Root& root) { return root.kind == modal::RootKind::rigid; });
  if (assembled.frequency_dependent() || loading.longest_delay() > 0 || loading.vanishes() || free) return vanish;
  const RootRange range = range_of(roots);
  const auto at = [&](double omega) { return visible_amplitudes(assembled, channels, loading, omega); };
  const Eigen::VectorXd at_rest = at(range.lowest / far), low = at(range.lowest / near),
                        between = at(aside * std::sqrt(range.lowest * range.highest)), high = at(range.highest * near),
                        beyond = at(range.highest * far);
  for (Eigen::Index c = 0; c < between.size(); ++c) {
    const bool zero_throughout = low(c) == 0 && between(c) == 0 && high(c) == 0;
    vanish[c] = !zero_throughout && at_rest(c) <= falls * low(c) && beyond(c) <= falls * high(c);
  }
  return vanish;
}

}  // namespace trivet::response
