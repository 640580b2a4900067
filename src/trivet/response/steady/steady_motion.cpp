// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/steady_motion.h"

#include <fmt/format.h>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::response {

numerics::SweepResult steady_solution(const assembly::Assembled& assembled, const assembly::Loading& loading,
                                      const std::vector<double>& angular_frequency,
                                      const numerics::SweepOptions& options) {
  const numerics::Load load = assembly::right_side(assembled, loading);
  if (!assembled.frequency_dependent()) return numerics::sweep(assembled.matrices, load, angular_frequency, options);
  numerics::FrequencyPart part{[&](double omega, Eigen::MatrixXcd& z, Eigen::VectorXcd& h) {
    assembled.add_frequency_dependent(omega, omega, z);
    assembly::add_frequency_dependent(assembled, loading, omega, omega, h);
  }};
  for (const assembly::ElementMap& map : assembled.elements)
    if (map.frequency_dependent()) part.coupled_rows.emplace_back(map.rows.begin(), map.rows.begin() + map.end_columns);
  return numerics::sweep(assembled.constant, load.head(assembled.constant.size()), part, angular_frequency, options);
}

std::vector<SteadyMotion> steady_motions(const assembly::Assembled& assembled, const assembly::Loading& loading,
                                         const std::vector<double>& angular_frequency) {
  for (const double omega : angular_frequency)
    if (!(omega > 0))
      throw foundation::InvalidInput(
          fmt::format("steady motion: {}; the frequency must be > 0", foundation::hertz_words(omega, 6)));
  const Eigen::MatrixXcd q = steady_solution(assembled, loading, angular_frequency).response;
  std::vector<SteadyMotion> result;
  for (std::size_t i = 0; i < angular_frequency.size(); ++i) {
    SteadyMotion motion{angular_frequency[i], q.col(to_index(i)), Eigen::VectorXcd::Zero(assembled.ground.size())};
    if (!motion.free.allFinite())
      throw foundation::NotComputable(
          fmt::format("steady motion: {} is an undamped natural frequency: the motion is unbounded",
                      foundation::hertz_words(motion.angular_frequency, 6)));
    if (!loading.motion.vanishes()) motion.ground = loading.motion.at(motion.angular_frequency);
    result.push_back(std::move(motion));
  }
  return result;
}

Eigen::VectorXcd element_motion(const assembly::ElementMap& map, const SteadyMotion& motion) {
  const Eigen::Index size = map.frequency_dependent() ? 12 : map.ends.rows();
  const Eigen::Index columns = map.frequency_dependent() ? map.end_columns : map.ends.cols();
  Eigen::VectorXcd d = map.moved_by_ground(motion.ground).head(size);
  for (Eigen::Index j = 0; j < columns; ++j)
    d += map.ends.col(j).head(size).cast<std::complex<double>>() * motion.free(map.rows[j]);
  return d;
}

Eigen::VectorXcd element_wrenches(const assembly::ElementMap& map, const Eigen::VectorXcd& element_motion,
                                  double angular_frequency) {
  if (map.frequency_dependent()) return map.dynamic_stiffness(angular_frequency, angular_frequency) * element_motion;
  const elements::Matrices& m = map.matrices;
  const Eigen::MatrixXcd d = m.stiffness + std::complex<double>(0, 1) * (m.loss + angular_frequency * m.damping) -
      angular_frequency * angular_frequency * m.mass;
  return d * element_motion;
}

}  // namespace trivet::response
