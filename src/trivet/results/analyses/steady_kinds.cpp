// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/steady_kinds.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace trivet::results {
namespace {

std::string kind_of(const std::string& unit) {
  constexpr std::array<std::pair<const char*, const char*>, 4> of_rotations = {
      {{"rad", "m"}, {"rad/s", "m/s"}, {"rad/s²", "m/s²"}, {"N m", "N"}}};
  for (const auto& [rotation, translation] : of_rotations)
    if (unit == rotation) return translation;
  return unit;
}

}  // namespace

std::vector<double> largest_of_kinds(const nonlinear::SteadyBranch& branch) {
  const std::size_t count = branch.results.size();
  std::vector<double> own(count), found(count);
  for (const nonlinear::SteadyPoint& point : branch.points)
    for (std::size_t c = 0; c < count; ++c)
      own[c] = std::max({own[c], point.results[c].largest, -point.results[c].smallest});
  for (std::size_t c = 0; c < count; ++c)
    for (std::size_t other = 0; other < count; ++other)
      if (kind_of(branch.units[other]) == kind_of(branch.units[c])) found[c] = std::max(found[c], own[other]);
  return found;
}

const char* harmonics_that_leave_out(Eigen::Index harmonics) {
  return harmonics == 1 ? "harmonic, which leaves out" : "harmonics, which leave out";
}

}  // namespace trivet::results
