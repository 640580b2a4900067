// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/vanishing_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/response/steady/visible_amplitudes.h"

namespace trivet::response {
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
