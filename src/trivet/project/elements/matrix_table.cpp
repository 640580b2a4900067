// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/matrix_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "trivet/elements/matrix_checks.h"
#include "trivet/elements/piecewise_stiffness.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/complex_stiffness.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/stiffness_column.h"

namespace trivet::project {
namespace {

constexpr std::string_view loss_ending = "_loss";
constexpr const char* column_rule =
    "columns are frequency_hz and, per entry of a matrix, k_I_J and k_I_J_loss with I, J from 1 to 6 (of the moved "
    "end) or 12 (N, then K)";

/// Entries over frequency, mirrored if the element is symmetric.
struct MatrixTable {
  struct Entry {
    int row, column;
    elements::StiffnessTable values;
    elements::PiecewiseStiffness law;
  };
  std::vector<Entry> entries;
  std::vector<double> knots;  ///< [rad/s]
  int size = 6;
  bool symmetric = true;

  template <typename Value>
  Eigen::MatrixXcd matrix(const Value& value) const {
    Eigen::MatrixXcd m = Eigen::MatrixXcd::Zero(size, size);
    for (const Entry& e : entries) {
      m(e.row, e.column) = value(e);
      if (symmetric) m(e.column, e.row) = m(e.row, e.column);
    }
    return m;
  }
  [[nodiscard]] Eigen::MatrixXcd at(std::complex<double> omega, double near) const {
    return matrix([&](const Entry& e) { return e.law.at(omega, near); });
  }
  [[nodiscard]] Eigen::MatrixXcd row(std::size_t i) const {
    const auto r = to_index(i);
    return matrix([&](const Entry& e) { return std::complex<double>(e.values.storage(r, 0), e.values.loss(r, 0)); });
  }
};

elements::Matrix12c in_full(const Eigen::MatrixXcd& given, const model::Span& span) {
  elements::Matrix12c full;
  full.real() = full_matrix(given.real(), span);
  full.imag() = full_matrix(given.imag(), span);
  return full;
}

std::optional<MatrixTable> table_of(TableReader& reader, const CsvTable& csv, model::Element& element) {
  const std::size_t before = reader.errors();
  MatrixTable table;
  table.symmetric = element.symmetric;
  for (const std::string& column : csv.columns) {
    if (column == "frequency_hz") continue;
    const auto entry = matrix_entry_of(column);
    const std::string name = entry ? fmt::format("k_{}_{}", entry->first, entry->second) : column,
                      loss = name + std::string(loss_ending);
    if (column == loss && std::ranges::find(csv.columns, name) != csv.columns.end()) continue;  // read with its storage
    const bool in_range =
        entry && std::min(entry->first, entry->second) >= 1 && std::max(entry->first, entry->second) <= 12;
    if (!in_range) {
      reader.error("file", "column " + foundation::quoted(column), column_rule, "rename or remove it");
      continue;
    }
    const auto [i, j] = *entry;
    if (i > j && element.symmetric) {
      reader.error("file", "column \"" + column + "\" below the diagonal",
                   "a symmetric element has only the upper triangle",
                   fmt::format("give k_{}_{}, or set symmetric = false if it is intended", j, i));
      continue;
    }
    table.size = std::max(i, j) > 6 ? 12 : table.size;
    const auto values = columns(csv, {"frequency_hz", name, loss});
    if (!values) {
      reader.add_of_file("file", values.error());
      continue;
    }
    const auto checked = checked_table(reader, name, *values, elements::Interpolation::linear, i != j);
    if (!checked) continue;
    if (i == j) judge_causality(reader, name, *checked, element);
    table.entries.push_back({i - 1, j - 1, *checked, elements::PiecewiseStiffness(*checked)});
    table.knots = checked->angular_frequencies;
  }
  if (reader.errors() > before) return std::nullopt;
  return table;
}

/// Reports a loss matrix with a negative eigenvalue: it feeds energy into some motion.
void check_passive(TableReader& reader, const MatrixTable& table, const model::Span& span) {
  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions(span.arm, span.n_from_k);
  double worst = 0, at = 0;
  for (std::size_t i = 0; i < table.knots.size(); ++i) {
    const elements::MatrixVerdict verdict = elements::examine(in_full(table.row(i), span).imag(), rigid);
    const double share = verdict.lowest_eigenvalue / std::max(1.0, verdict.highest_eigenvalue);
    if (share < worst) worst = share, at = table.knots[i] / (2 * std::numbers::pi);
  }
  if (worst >= -rounded_loss) return;
  const std::string finding = fmt::format("at {:.6g} Hz the scaled loss matrix has the eigenvalue {:.4g}", at, worst);
  const char* rule = "a passive element absorbs energy in every motion";
  foundation::Problems found;
  if (worst < -noisy_loss)
    found.error("file", finding, rule, "check signs and phases of the loss columns, especially of couplings");
  else
    found.warning("file", finding, rule,
                  "measurement noise may be the cause; such an element can feed energy into a motion");
  reader.add(found);
}

}  // namespace

bool is_matrix_table(const CsvTable& csv) {
  return std::ranges::any_of(csv.columns,
                             [](const std::string& column) { return matrix_entry_of(column).has_value(); });
}

void read_matrix_table(TableReader& reader, const CsvTable& csv, const model::Span& span, model::Element& element) {
  const auto table = table_of(reader, csv, element);
  if (!table) return;
  check_passive(reader, *table, span);
  element.law.nominal_stiffness = full_matrix(table->row(0).real(), span);
  elements::FrequencyDependence dependence;
  dependence.elastic = false;
  dependence.from = table->knots.front();
  dependence.to = table->knots.back();
  dependence.knots = table->knots;
  dependence.stiffness = [table = *table, span](std::complex<double> omega, double near) {
    return in_full(table.at(omega, near), span);
  };
  element.facts.push_back(defined_range(dependence.from, dependence.to));
  element.law.frequency_dependence = std::move(dependence);
}

}  // namespace trivet::project
