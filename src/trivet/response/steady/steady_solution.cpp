// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/steady_solution.h"

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

}  // namespace trivet::response
