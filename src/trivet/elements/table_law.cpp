// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/table_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::elements {
namespace {

using foundation::two_pi;

bool is_empty(const StiffnessTable& table) { return table.storage.size() == 0 && table.loss.size() == 0; }

void require_inside(const std::vector<double>& grid, double x, const char* quantity, double unit_size,
                    const char* unit) {
  if (!grid.empty() && !(x >= grid.front() && x <= grid.back()))
    throw foundation::InvalidInput(
        fmt::format("{} {:.6g} {}: the stiffness table covers {:.6g} … {:.6g} {} and is not extrapolated", quantity,
                    x / unit_size, unit, grid.front() / unit_size, grid.back() / unit_size, unit));
}

double over_frequency(const StiffnessTable& t, const Eigen::Ref<const Eigen::VectorXd>& column, double x) {
  if (t.angular_frequencies.empty()) return column(0);
  const std::vector<double>& grid = t.angular_frequencies;
  const std::size_t i = interval(grid, x);
  const double h = grid[i + 1] - grid[i], s = (x - grid[i]) / h, y0 = column(to_index(i)), y1 = column(to_index(i) + 1);
  if (t.interpolation == Interpolation::linear) return y0 + s * (y1 - y0);
  const double d0 = knot_slope(grid, column, i), d1 = knot_slope(grid, column, i + 1);
  return y0 + s * s * (3 - 2 * s) * (y1 - y0) + h * s * (1 - s) * ((1 - s) * d0 - s * d1);
}

double over_both(const StiffnessTable& t, const Eigen::MatrixXd& values, double angular_frequency, double amplitude) {
  if (t.amplitudes.empty()) return over_frequency(t, values.col(0), angular_frequency);
  const std::size_t i = interval(t.amplitudes, amplitude);
  const double share = (amplitude - t.amplitudes[i]) / (t.amplitudes[i + 1] - t.amplitudes[i]);
  const auto column = to_index(i);
  return (1 - share) * over_frequency(t, values.col(column), angular_frequency) +
      share * over_frequency(t, values.col(column + 1), angular_frequency);
}

void check_grid(foundation::Problems& problems, const std::string& subject, const std::vector<double>& grid,
                const char* quantity) {
  if (grid.size() == 1)
    problems.error(subject, fmt::format("a single {}", quantity),
                   "a table needs two or more of them, or none if the stiffness does not depend on it",
                   "add a row or remove them");
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (!(grid[i] >= 0) || !std::isfinite(grid[i]) || (i > 0 && grid[i] <= grid[i - 1])) {
      problems.error(subject, fmt::format("{} number {} is {:.6g}", quantity, i + 1, grid[i]),
                     "they must be ≥ 0 and increase", "sort the table and remove repeats");
      return;
    }
}

}  // namespace

std::complex<double> dynamic_stiffness(const StiffnessTable& t, double angular_frequency, double amplitude) {
  require_inside(t.angular_frequencies, angular_frequency, "frequency", two_pi, "Hz");
  require_inside(t.amplitudes, amplitude, "amplitude", 1e-3, "mm or mrad");
  return {over_both(t, t.storage, angular_frequency, amplitude), over_both(t, t.loss, angular_frequency, amplitude)};
}

foundation::Problems check(const StiffnessTable& t, const std::string& subject) {
  foundation::Problems problems;
  check_grid(problems, subject, t.angular_frequencies, "frequency");
  check_grid(problems, subject, t.amplitudes, "amplitude");
  const auto rows = to_index(std::max<std::size_t>(1, t.angular_frequencies.size()));
  const auto columns = to_index(std::max<std::size_t>(1, t.amplitudes.size()));
  for (const auto& [values, quantity] : {std::pair{&t.storage, "storage"}, std::pair{&t.loss, "loss"}}) {
    if (values->rows() != rows || values->cols() != columns)
      problems.error(subject, fmt::format("{} × {} {} stiffnesses", values->rows(), values->cols(), quantity),
                     fmt::format("{} frequencies and {} amplitudes need {} × {}", t.angular_frequencies.size(),
                                 t.amplitudes.size(), rows, columns),
                     "fill the table");
    else if (!values->allFinite())
      problems.error(subject, fmt::format("a {} stiffness is not a number", quantity), "every entry must be finite",
                     "look for empty cells");
  }
  Eigen::Index row = 0, column = 0;
  if (!problems.has_errors() && t.loss.minCoeff(&row, &column) < 0)
    problems.error(subject,
                   fmt::format("loss stiffness {:.6g} in row {}, column {}", t.loss(row, column), row + 1, column + 1),
                   "it must be ≥ 0: a passive element dissipates energy", "check the sign of the phase");
  return problems;
}

ComplexMatrix12 dynamic_stiffness(const TableLaw& law, const Eigen::Vector3d& arm, double angular_frequency,
                                  const Vector6& amplitudes) {
  Vector6 storage = Vector6::Zero(), loss = Vector6::Zero();
  for (int i = 0; i < 6; ++i) {
    const StiffnessTable& table = law.directions[i];
    if (is_empty(table)) continue;
    const std::complex<double> value = dynamic_stiffness(table, angular_frequency, amplitudes(i));
    storage(i) = value.real();
    loss(i) = value.imag();
  }
  ComplexMatrix12 matrix;
  matrix.real() = constants_at_point(storage, arm, law.centre);
  matrix.imag() = constants_at_point(loss, arm, law.centre);
  return matrix;
}

FrequencyRange frequency_range(const TableLaw& law) {
  FrequencyRange range{0, std::numeric_limits<double>::infinity()};
  for (const StiffnessTable& table : law.directions)
    if (!table.angular_frequencies.empty()) {
      range.from = std::max(range.from, table.angular_frequencies.front());
      range.to = std::min(range.to, table.angular_frequencies.back());
    }
  return range;
}

foundation::Problems check(const TableLaw& law) {
  const char* names[] = {"x", "y", "z", "theta_x", "theta_y", "theta_z"};
  foundation::Problems problems;
  bool any = false;
  for (std::size_t i = 0; i < 6; ++i)
    if (!is_empty(law.directions[i])) any = true, problems.add(check(law.directions[i], names[i]));
  if (!any)
    problems.error("", "no table", "a table law has at least one direction",
                   "give a table for x, y, z, theta_x, theta_y or theta_z");
  if (!(law.centre >= 0 && law.centre <= 1))
    problems.error("centre", fmt::format("centre = {:.6g}", law.centre), "it must be between 0 (end N) and 1 (end K)",
                   "0.5 is the middle");
  if (const FrequencyRange range = frequency_range(law); range.from > range.to)
    problems.error("",
                   fmt::format("the tables have no common frequency: one starts at {:.6g} Hz, one ends at {:.6g} Hz",
                               range.from / two_pi, range.to / two_pi),
                   "there must be a band that all directions cover", "extend the tables");
  return problems;
}

}  // namespace trivet::elements
