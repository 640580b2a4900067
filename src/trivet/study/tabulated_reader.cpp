// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <set>

#include "trivet/elements/table_law.h"
#include "trivet/identification/causality.h"
#include "trivet/study/csv_table.h"
#include "trivet/study/element_parts.h"

namespace trivet::study {
namespace {

constexpr std::array<const char*, 6> directions = {"x", "y", "z", "rx", "ry", "rz"};

/// A piecewise cubic in ω, continued from each of its pieces to complex ω.
class PiecewiseStiffness {
 public:
  explicit PiecewiseStiffness(const elements::StiffnessTable& table) : knots_(table.angular_frequencies) {
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      const double from = knots_[i], width = knots_[i + 1] - from;
      std::array<std::complex<double>, 4> samples;
      for (int k = 0; k < 4; ++k) samples[static_cast<std::size_t>(k)] = elements::dynamic_stiffness(table, k == 3 ? knots_[i + 1] : from + width * k / 3.0, 0);
      pieces_.push_back(samples);
    }
  }

  /// Lagrange's form through four equidistant values of the piece that holds at `near`.
  std::complex<double> at(std::complex<double> omega, double near) const {
    const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, near);
    const std::size_t i = static_cast<std::size_t>(above - knots_.begin()) - 1;
    const std::complex<double> t = 3.0 * (omega - knots_[i]) / (knots_[i + 1] - knots_[i]);
    std::complex<double> sum = 0;
    for (int j = 0; j < 4; ++j) {
      std::complex<double> term = pieces_[i][static_cast<std::size_t>(j)];
      for (int k = 0; k < 4; ++k)
        if (k != j) term *= (t - double(k)) / double(j - k);
      sum += term;
    }
    return sum;
  }

 private:
  std::vector<double> knots_;
  std::vector<std::array<std::complex<double>, 4>> pieces_;
};

/// One direction: column `name` and column `name_loss` over frequency.
elements::StiffnessTable direction_table(const Eigen::MatrixXd& values, elements::Interpolation interpolation) {
  elements::StiffnessTable table;
  for (Eigen::Index i = 0; i < values.rows(); ++i) table.angular_frequencies.push_back(2 * std::numbers::pi * values(i, 0));
  table.storage = values.col(1);
  table.loss = values.col(2);
  table.interpolation = interpolation;
  return table;
}

void judge(TableReader& reader, const std::string& direction, const elements::StiffnessTable& table, model::Element& element) {
  identification::DynamicStiffnessTable data;
  std::vector<double> positive;
  std::vector<std::complex<double>> stiffness;
  for (std::size_t i = 0; i < table.angular_frequencies.size(); ++i)
    if (table.angular_frequencies[i] > 0) {
      positive.push_back(table.angular_frequencies[i]);
      stiffness.emplace_back(table.storage(static_cast<Eigen::Index>(i), 0), table.loss(static_cast<Eigen::Index>(i), 0));
    }
  data.angular_frequency = Eigen::Map<const Eigen::VectorXd>(positive.data(), static_cast<Eigen::Index>(positive.size()));
  data.stiffness = Eigen::Map<const Eigen::VectorXcd>(stiffness.data(), static_cast<Eigen::Index>(stiffness.size()));
  const auto check = identification::causality(data);
  if (!check) {
    for (foundation::Problem problem : check.error().list()) {
      problem.subject = "file";
      problem.finding = "k_" + direction + ": " + problem.finding;
      foundation::Problems one;
      one.add(std::move(problem));
      reader.add(one);
    }
    return;
  }
  element.facts.push_back({"causality of k_" + direction, check->verdict});
  if (!check->passes)
    reader.problems().warning(reader.path() + ".file", fmt::format("k_{}: {:.3g} % from the nearest passive, causal stiffness", direction, 100 * check->relative_rms),
                              "storage and loss of a real element belong together (Kramers and Kronig)", "look at the rig and its phase: " + check->verdict).origin = reader.node("file")->origin;
}

}  // namespace

void read_tabulated(TableReader& reader, const model::Span& span, model::Element& element) {
  const std::size_t before = reader.errors();
  const double centre = reader.number("center", Quantity::pure).value_or(0.5);
  const auto interpolation = reader.choice("interpolation", {"monotone_cubic", "linear"}) == "linear" ? elements::Interpolation::linear : elements::Interpolation::monotone_cubic;
  const auto file = read_file_name(reader, "file");
  if (reader.has("damping")) reader.error("damping", "damping beside a table", "its table holds the loss", "remove it");
  static_cast<void>(reader.node("damping"));
  if (!(centre >= 0 && centre <= 1)) reader.error("center", fmt::format("{:.6g}", centre), "the elastic point lies between the ends: 0 (N) … 1 (K)", "give a fraction of the length");
  if (!file) return;
  const auto csv = read_csv_table(*file);
  if (!csv) {
    reader.add_of_file("file", csv.error());
    return;
  }
  auto law = std::make_shared<std::array<std::optional<PiecewiseStiffness>, 6>>();
  elements::Vector6 static_constants = elements::Vector6::Zero();
  std::set<std::string> wanted = {"frequency_hz"};
  double from = 0, to = 0;
  std::vector<double> knots;
  for (int j = 0; j < 6; ++j) {
    const std::string name = std::string("k_") + directions[static_cast<std::size_t>(j)];
    if (std::find(csv->columns.begin(), csv->columns.end(), name) == csv->columns.end()) continue;
    wanted.insert({name, name + "_loss"});
    const auto values = columns(*csv, {"frequency_hz", name, name + "_loss"});
    if (!values) {
      reader.add_of_file("file", values.error());
      continue;
    }
    const elements::StiffnessTable table = direction_table(*values, interpolation);
    elements::StiffnessTable as_written = table;
    for (Eigen::Index i = 0; i < values->rows(); ++i) as_written.angular_frequencies[static_cast<std::size_t>(i)] = (*values)(i, 0);  // [Hz], for the words
    foundation::Problems findings = elements::check(as_written, "");
    for (foundation::Problem& problem : findings.list()) problem.finding = name + ": " + problem.finding;
    reader.add_of_file("file", findings);
    if (findings.has_errors()) continue;
    judge(reader, directions[static_cast<std::size_t>(j)], table, element);
    (*law)[static_cast<std::size_t>(j)].emplace(table);
    static_constants(j) = table.storage(0, 0);
    knots = table.angular_frequencies;
    from = knots.front();
    to = knots.back();
  }
  for (const std::string& column : csv->columns)
    if (!wanted.contains(column))
      reader.error("file", "column \"" + column.substr(0, 60) + "\"", "columns are frequency_hz and, per direction, k_x and k_x_loss (y, z, rx, ry, rz)", "rename or remove it");
  if (wanted.size() == 1) {
    reader.error("file", "no stiffness column", "columns are frequency_hz and, per direction, k_x and k_x_loss (y, z, rx, ry, rz)", "add at least one pair");
    return;
  }
  if (reader.errors() > before) return;
  element.law.nominal_stiffness = elements::in_end_axes(elements::constants_at_point(static_constants, span.arm, centre), span.n_from_k);
  std::array<elements::Matrix12, 6> unit;
  for (int j = 0; j < 6; ++j) unit[static_cast<std::size_t>(j)] = elements::in_end_axes(elements::constants_at_point(elements::Vector6::Unit(j), span.arm, centre), span.n_from_k);
  elements::FrequencyDependence dependence;
  dependence.elastic = false;
  dependence.from = from;
  dependence.to = to;
  dependence.knots = knots;
  dependence.stiffness = [law, unit](std::complex<double> omega, double near) {
    elements::Matrix12c sum = elements::Matrix12c::Zero();
    for (std::size_t j = 0; j < 6; ++j)
      if ((*law)[j]) sum += (*law)[j]->at(omega, near) * unit[j].cast<std::complex<double>>();
    return sum;
  };
  element.law.frequency_dependence = std::move(dependence);
  element.facts.push_back({"defined", fmt::format("{:.6g} … {:.6g} Hz", from / (2 * std::numbers::pi), to / (2 * std::numbers::pi))});
}

}  // namespace trivet::study
