// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/response/steady/model_rates.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/family/slopes.h"

namespace trivet::study {

/// The equations of one design of a batch and their exact changes per unit of each parameter, without a model.
class PackedRates {
 public:
  /// @param batch  with a family, longer than this  @param values  of the design
  PackedRates(const DesignBatch& batch, const Eigen::VectorXd& values);

  [[nodiscard]] bool gives(std::size_t result) const { return of_.gives_slopes(result); }
  /// Per parameter.
  [[nodiscard]] const std::vector<response::MatrixRates>& matrices() const { return matrices_; }
  [[nodiscard]] CurveEquations curve(std::size_t result, double omega) const {
    return curve_in(here_, result, 0, omega);
  }
  [[nodiscard]] CurveEquations curve_change(std::size_t result, std::size_t parameter, double omega) const {
    return curve_in(changes_, result, parameter, omega);
  }
  [[nodiscard]] RestEquations rest(std::size_t result) const { return rest_in(here_, result, 0); }
  [[nodiscard]] RestEquations rest_change(std::size_t result, std::size_t parameter) const {
    return rest_in(changes_, result, parameter);
  }
  /// Of the body that a result decouples.
  [[nodiscard]] spatial::MassProperties mass_change(std::size_t result, std::size_t parameter) const;

 private:
  /// One design, or one change per parameter.
  struct Part {
    CaseVector::Unpacked designs;
    std::vector<std::optional<numerics::DrivenDesigns>> searched;  ///< when they are first needed
  };
  [[nodiscard]] CurveEquations curve_in(Part& part, std::size_t result, std::size_t row, double omega) const;
  [[nodiscard]] RestEquations rest_in(const Part& part, std::size_t result, std::size_t row) const;

  const CaseVector& of_;
  mutable Part here_, changes_;
  std::vector<response::MatrixRates> matrices_;
};

}  // namespace trivet::study
