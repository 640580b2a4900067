// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/rig_regression.h"

#include <algorithm>
#include <cmath>

#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"

namespace trivet::identification {
namespace {

Basis basis(Unknowns unknowns, const Eigen::Vector3d& arm, const std::array<double, 2>& motion) {
  const int size = unknowns == Unknowns::self_balanced ? 6 : 12;
  Basis result;
  std::vector<double> units;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) {
      Eigen::MatrixXd one = Eigen::MatrixXd::Zero(size, size);
      one(i, j) = one(j, i) = 1;
      result.matrices.push_back(size == 6 ? elements::from_moved_end(one, arm) : Matrix12(one));
      result.entry.push_back({12 - size + i, 12 - size + j});
      units.push_back(1 / (motion[i % 6 < 3 ? 0 : 1] * motion[j % 6 < 3 ? 0 : 1]));
    }
  result.unit = Eigen::Map<const Eigen::VectorXd>(units.data(), to_index(units.size()));
  return result;
}

/// Readings that a channel needs for a noise estimate from its own residuals; with fewer, forces share one noise and
/// moments another.
int readings_for_own_noise(Unknowns unknowns) { return unknowns == Unknowns::self_balanced ? 15 : 27; }

void group_by_noise(const StiffnessFitOptions& options, Rig& rig) {
  std::array<int, 12> count{};
  for (const auto& [load_case, channel] : rig.reading) ++count[channel];
  bool given = true, own = true;
  for (int c = 0; c < 12; ++c) {
    const int n = count[c];
    if (n == 0) continue;
    given = given && !std::isnan(options.standard_deviation(c));
    own = own && n >= readings_for_own_noise(options.unknowns);
  }
  Regression& regression = rig.regression;
  regression.groups = given ? 1 : own ? 12 : 2;
  for (Eigen::Index r = 0; r < regression.measured.size(); ++r) {
    const int channel = rig.reading[r][1];
    regression.relative_deviation(r) = given ? options.standard_deviation(channel) : 1;
    regression.group.push_back(given ? 0 : own ? channel : channel % 6 < 3 ? 0 : 1);
  }
}

}  // namespace

std::array<double, 2> typical_motion(const std::vector<LoadCase>& cases) {
  std::array<double, 2> squares{};
  for (const LoadCase& one : cases)
    for (int i = 0; i < 12; ++i)
      squares[i % 6 < 3 ? 0 : 1] += one.displacement(i) * one.displacement(i) / static_cast<double>(cases.size());
  for (double& square : squares) square = square > 0 ? std::sqrt(square) : 1;
  return squares;
}

Rig rig_regression(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm, const StiffnessFitOptions& options) {
  Rig rig;
  const auto motion = typical_motion(cases);
  rig.basis = basis(options.unknowns, arm, motion);
  for (std::size_t k = 0; k < cases.size(); ++k)
    for (int c = 0; c < 12; ++c)
      if (!std::isnan(cases[k].wrench(c))) rig.reading.push_back({static_cast<int>(k), c});
  if (options.zero_offsets)
    for (int c = 0; c < 12; ++c)
      if (std::ranges::any_of(rig.reading, [&](const auto& r) { return r[1] == c; })) rig.offset_channel.push_back(c);

  const auto rows = to_index(rig.reading.size()), constants = rig.basis.unit.size();
  Regression& regression = rig.regression;
  regression.design = Eigen::MatrixXd::Zero(rows, constants + to_index(rig.offset_channel.size()));
  regression.measured.resize(rows);
  regression.relative_deviation.resize(rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const auto [k, c] = rig.reading[r];
    const LoadCase& one = cases[k];
    regression.measured(r) = one.wrench(c);
    for (Eigen::Index p = 0; p < constants; ++p)
      regression.design(r, p) = rig.basis.unit(p) * rig.basis.matrices[p].row(c).dot(one.displacement);
    for (std::size_t o = 0; o < rig.offset_channel.size(); ++o)
      if (rig.offset_channel[o] == c) regression.design(r, constants + to_index(o)) = 1 / motion[c % 6 < 3 ? 0 : 1];
  }
  group_by_noise(options, rig);
  return rig;
}

}  // namespace trivet::identification
