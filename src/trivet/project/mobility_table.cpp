// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/mobility_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/identification/mobility_causality.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/stiffness_column.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/file_name.h"

namespace trivet::project {
namespace {

constexpr const char* mobility_columns =
    "columns are frequency_hz and, per entry, y_I_J and y_I_J_im with I, J out of x, y, z, rx, ry, rz (the upper "
    "triangle)";
/// Largest negative eigenvalue of Re Y over the largest mobility of its row that noise, or rounding, explains.
constexpr double noisy = 0.02, rounded = 1e-9;

struct MobilityTable {
  std::vector<int> directions;
  std::vector<double> knots;           ///< [rad/s]
  std::vector<Eigen::MatrixXcd> rows;  ///< Y at each

  /// Y by linear interpolation, which keeps Re Y positive semidefinite; for complex ω the piece at `near` is continued.
  [[nodiscard]] Eigen::MatrixXcd at(std::complex<double> omega, double near) const {
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, near);
    const auto i = to_size(above - knots.begin());
    const std::complex<double> share = (omega - knots[i - 1]) / (knots[i] - knots[i - 1]);
    return (1.0 - share) * rows[i - 1] + share * rows[i];
  }

  [[nodiscard]] elements::Matrix12c stiffness(std::complex<double> omega, double near) const {
    const Eigen::MatrixXcd inverse = numerics::inverse(at(omega, near));
    elements::Matrix12c full = elements::Matrix12c::Zero();
    for (std::size_t a = 0; a < directions.size(); ++a)
      for (std::size_t b = 0; b < directions.size(); ++b) {
        const std::complex<double> entry = std::complex<double>(0, 1) * omega * inverse(to_index(a), to_index(b));
        const int i = directions[a], j = directions[b];
        full(i, j) = full(6 + i, 6 + j) = entry;
        full(i, 6 + j) = full(6 + i, j) = -entry;
      }
    return full;
  }
};

std::optional<std::pair<int, int>> entry_of(std::string name) {
  if (name.ends_with("_im")) name.resize(name.size() - 3);
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      if (name == fmt::format("y_{}_{}", model::coordinate_names[to_size(i)], model::coordinate_names[to_size(j)]))
        return std::pair(i, j);
  return std::nullopt;
}

void check_frequencies(const CsvTable& csv, const Eigen::VectorXd& frequency, foundation::Problems& found) {
  for (Eigen::Index i = 0; i < frequency.size(); ++i) {
    const bool rises = i == 0 || frequency(i) > frequency(i - 1);
    if (frequency(i) > 0 && rises) continue;
    found
        .error("", fmt::format("frequency_hz = {:.6g}", frequency(i)),
               rises ? "a mobility is measured above 0 Hz" : "frequencies increase from row to row",
               "sort or correct the rows")
        .origin = {csv.source, csv.lines[to_size(i)]};
  }
  if (frequency.size() < 2)
    found.error("", fmt::format("{} rows", frequency.size()), "a table has at least two rows", "add some");
}

void check_passive(const CsvTable& csv, const MobilityTable& table, foundation::Problems& found) {
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Eigen::MatrixXd real = 0.5 * (table.rows[i] + table.rows[i].adjoint()).real();
    const double share =
        numerics::symmetric_eigenvalues(real)(0) / std::max(table.rows[i].cwiseAbs().maxCoeff(), 1e-300);
    if (share < worst) worst = share, at = i;
  }
  if (worst >= -rounded) return;
  const std::string finding = fmt::format("at {:.6g} Hz Re Y has the eigenvalue {:.3g}, relative to its largest entry",
                                          table.knots[at] / (2 * std::numbers::pi), worst);
  const char* rule = "a passive ground absorbs energy in every motion: Re Y is positive semidefinite";
  foundation::Problem& problem = worst < -noisy
      ? found.error("", finding, rule, "check sign and phase of velocity against force")
      : found.warning("", finding, rule,
                      "measurement noise may be the cause; such a ground can feed energy into a motion");
  problem.origin = {csv.source, csv.lines[at]};
}

void judge(const MobilityTable& table, model::Element& element, foundation::Problems& found) {
  for (std::size_t a = 0; a < table.directions.size(); ++a) {
    Eigen::VectorXcd values(to_index(table.rows.size()));
    const auto d = to_index(a);
    for (std::size_t i = 0; i < table.rows.size(); ++i) values(to_index(i)) = table.rows[i](d, d);
    const identification::MobilityVerdict verdict = identification::mobility_causality(table.knots, values);
    const std::string name = fmt::format("y_{0}_{0}", model::coordinate_names[to_size(table.directions[a])]);
    element.facts.push_back(
        {"causality of " + name,
         fmt::format("{:.3g} % rms from the nearest passive, causal mobility", 100 * verdict.relative_rms)});
    if (verdict.passes) continue;
    const std::string finding =
        fmt::format("{}: {:.3g} % rms from the nearest passive, causal mobility", name, 100 * verdict.relative_rms);
    const char* rule = "real and imaginary part of a physical mobility satisfy the Kramers–Kronig relations";
    if (verdict.too_coarse)
      found.warning("", finding, "its rows must resolve the width of every resonance",
                    "measure at closer frequencies; if they are close enough, check the phase");
    else if (verdict.refused)
      found.error("", finding, rule,
                  "check the phase: with e^{+iωt} a mass has a negative, a spring a positive imaginary mobility");
    else found.warning("", finding, rule, "check noise, leakage and the phase of the measurement");
  }
}

/// Warns if the phase turns far from one row to the next: linear interpolation then cuts a resonance short.
void check_spacing(const CsvTable& csv, const MobilityTable& table, foundation::Problems& found) {
  constexpr double widest = 30 * std::numbers::pi / 180;
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    for (Eigen::Index d = 0; d < table.rows[i].rows(); ++d)
      if (const double turn = std::abs(std::arg(table.rows[i](d, d) * std::conj(table.rows[i - 1](d, d))));
          turn > worst)
        worst = turn, at = i;
  if (worst <= widest) return;
  found
      .warning("",
               fmt::format("the phase turns by {:.3g}° from {:.6g} to {:.6g} Hz", worst * 180 / std::numbers::pi,
                           table.knots[at - 1] / (2 * std::numbers::pi), table.knots[at] / (2 * std::numbers::pi)),
               "the mobility is interpolated linearly: the peak of a resonance narrower than a few rows is cut off",
               "measure it at closer frequencies")
      .origin = {csv.source, csv.lines[at]};
}

}  // namespace

std::optional<std::vector<int>> read_mobility_table(TableReader& reader, model::Element& to_ground) {
  const std::size_t before = reader.errors();
  const auto file = read_file_name(reader, "file");
  if (!file) return std::nullopt;
  const auto csv = read_csv_table(*file, most_rows_over_frequency);
  if (!csv) return reader.add_of_file("file", csv.error()), std::nullopt;
  std::vector<std::pair<int, int>> entries;
  for (const std::string& column : csv->columns) {
    const auto entry = entry_of(column);
    if (!entry && column != "frequency_hz")
      reader.error("file", "column " + foundation::quoted(column), mobility_columns, "rename or remove it");
    if (entry && !column.ends_with("_im")) entries.push_back(*entry);
  }
  MobilityTable table;
  for (const auto& [i, j] : entries)
    if (i == j) table.directions.push_back(i);
  const auto place = [&](int direction) {
    return std::find(table.directions.begin(), table.directions.end(), direction) - table.directions.begin();
  };
  for (const auto& [i, j] : entries)
    if (place(i) == std::ssize(table.directions) || place(j) == std::ssize(table.directions))
      reader.error("file",
                   fmt::format("y_{}_{} without the diagonal", model::coordinate_names[to_size(i)],
                               model::coordinate_names[to_size(j)]),
                   "a coupling needs the diagonal mobilities of both directions", "add them");
  if (entries.empty()) reader.error("file", "no mobility column", mobility_columns, "add at least one pair");
  if (reader.errors() > before) return std::nullopt;
  const auto count = to_index(table.directions.size());
  table.rows.assign(to_size(csv->values.rows()), Eigen::MatrixXcd::Zero(count, count));
  foundation::Problems found;
  for (const auto& [i, j] : entries) {
    const std::string name =
        fmt::format("y_{}_{}", model::coordinate_names[to_size(i)], model::coordinate_names[to_size(j)]);
    const auto values = columns(*csv, {"frequency_hz", name, name + "_im"});
    if (!values) return reader.add_of_file("file", values.error()), std::nullopt;
    if (table.knots.empty()) check_frequencies(*csv, values->col(0), found);
    table.knots.assign(values->col(0).begin(), values->col(0).end());
    for (Eigen::Index r = 0; r < values->rows(); ++r) {
      if (!values->row(r).allFinite())
        found.error("", name + " is missing", "every cell must hold a finite number", "complete or remove the row")
            .origin = {csv->source, csv->lines[to_size(r)]};
      table.rows[to_size(r)](place(i), place(j)) = table.rows[to_size(r)](place(j), place(i)) =
          std::complex<double>((*values)(r, 1), (*values)(r, 2));
    }
  }
  for (double& frequency : table.knots) frequency *= 2 * std::numbers::pi;
  if (!found.has_errors()) check_passive(*csv, table, found);
  if (!found.has_errors()) judge(table, to_ground, found);
  if (!found.has_errors()) check_spacing(*csv, table, found);
  reader.add_of_file("file", found);
  if (found.has_errors()) return std::nullopt;

  // For starting values only: magnitude of the dynamic stiffness in the first row, per direction.
  elements::Vector6 first = elements::Vector6::Zero();
  for (const int j : table.directions)
    first(j) = std::abs(table.stiffness(table.knots.front(), table.knots.front())(j, j));
  to_ground.law.nominal_stiffness = elements::constants_at_point(first, Eigen::Vector3d::Zero(), 1);
  to_ground.facts.push_back(defined_range(table.knots.front(), table.knots.back()));
  elements::FrequencyDependence dependence;
  dependence.elastic = false;
  dependence.from = table.knots.front();
  dependence.to = table.knots.back();
  dependence.knots = table.knots;
  dependence.stiffness = [shared = std::make_shared<MobilityTable>(table)](std::complex<double> omega, double near) {
    return shared->stiffness(omega, near);
  };
  to_ground.law.frequency_dependence = std::move(dependence);
  return table.directions;
}

}  // namespace trivet::project
