// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/complex_stiffness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/elements/matrix_checks.h"

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

}  // namespace trivet::project
