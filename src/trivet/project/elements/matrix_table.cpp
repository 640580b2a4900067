// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/matrix_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "trivet/elements/checks.h"
#include "trivet/elements/stiffness_over_deflection.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/stiffness_column.h"

namespace trivet::project {

namespace {

using elements::Matrix12;

/// Largest deviation from one loss factor: files keep at least six digits.
constexpr double one_factor = 1e-6;

/// η if K'' = ηK', checked entry by entry over √(K'_ii K'_jj); else none.
std::optional<double> common_factor(const Matrix12& stiffness, const Matrix12& loss) {
  const double eta = loss.cwiseProduct(stiffness).sum() / stiffness.squaredNorm();
  const elements::Vector12 size = stiffness.diagonal().cwiseAbs().cwiseSqrt();
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      if (!(std::abs(loss(i, j) - eta * stiffness(i, j)) <= one_factor * std::abs(eta) * size(i) * size(j)))
        return std::nullopt;
  return eta;
}

void check_loss(TableReader& reader, const Matrix12& loss, const model::Span& span, const model::Element& element) {
  const elements::MatrixVerdict verdict = elements::examine(loss, elements::rigid_motions(span.arm, span.n_from_k));
  foundation::Problems found;
  if (element.symmetric && verdict.asymmetry > elements::rounding_of_data)
    found.error("file", fmt::format("its imaginary part is unsymmetric by {:.3g} (scaled)", verdict.asymmetry),
                "the loss of an element is symmetric", "correct the file, or set symmetric = false if it is intended");
  if (verdict.rigid_residual > elements::silent_residual) {
    const std::string finding = fmt::format("its imaginary part resists a rigid motion by {:.3g} % of the scaled loss",
                                            100 * verdict.rigid_residual);
    const char* rule = "an element loses no energy in a rigid motion";
    if (verdict.rigid_residual > elements::refused_residual && !element.allow_residual)
      found.error(
          "file", finding, rule,
          "correct the matrix, its order (N, then K) or its end points; remove a dashpot to the ground from the "
          "exported part");
    else found.warning("file", finding, rule, "it may be rounding of the data or a wrong end point");
  }
  const double lowest = verdict.lowest_eigenvalue / std::max(1.0, verdict.highest_eigenvalue);
  const std::string finding = fmt::format("its imaginary part has the scaled eigenvalue {:.4g}", lowest);
  const char* rule = "a passive element absorbs energy in every motion (e^{+iωt}: K'' ≥ 0)";
  if (lowest < -noisy_loss)
    found.error("file", finding, rule, "check the sign of the imaginary part: with e^{-iωt} it is the opposite");
  else if (lowest < -rounded_loss)
    found.warning("file", finding, rule, "it can feed energy into some motion; export more digits");
  reader.add(found);
}

}  // namespace

void set_loss(TableReader& reader, const Matrix12& loss, const model::Span& span, model::Element& element) {
  if (reader.has("damping")) {
    reader.error("damping", "damping and a complex matrix", "the imaginary part of the file holds the loss",
                 "remove damping, or export the real part alone");
    return;
  }
  const std::size_t before = reader.errors();
  check_loss(reader, loss, span, element);
  if (reader.errors() > before || loss.isZero(0)) return;
  if (const auto eta = common_factor(element.law.nominal_stiffness, loss)) {
    element.law.damping = elements::LossFactor{*eta};
    element.facts.push_back(
        {"loss factor", fmt::format("{:.6g}: the imaginary part is this multiple of the real part", *eta)});
    return;
  }
  elements::Matrix12c both = element.law.nominal_stiffness.cast<std::complex<double>>() +
      std::complex<double>(0, 1) * loss.cast<std::complex<double>>();
  elements::FrequencyDependence constant;
  constant.elastic = false;
  constant.stiffness = [both](std::complex<double>, double) { return both; };
  element.law.frequency_dependence = std::move(constant);
  element.facts.push_back({"loss", "a separate 12×12, the same at every frequency"});
}

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
