// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/sample/band_curves.h"
#include "trivet/study/sample/drawn_designs.h"

namespace trivet::study {

/// Margins of some designs of one case.
struct SampledMargins {
  Eigen::ArrayXXd margins;            ///< designs × requirements; NaN, and then in a whole row, if it has a failure
  std::vector<std::string> failures;  ///< per design, why; empty: it was judged
  std::size_t in_kernels = 0, one_by_one = 0;  ///< designs, of those judged
  /// Of its band curves, values × designs; without rows: not requested. NaN in the column of a design that has none:
  /// bands do not decide whether a design is judged.
  Eigen::ArrayXXd amplitudes = {};
};

/// The numbers of a case that tolerances move.
class ToleratedNumbers {
 public:
  /// @throws foundation::InvalidInput if one cannot be read there
  ToleratedNumbers(const project::Case& variant, const std::vector<project::Tolerance>& tolerances,
                   const DrawnDesigns& drawn);
  /// The machine for which these numbers are drawn. @throws foundation::NotComputable if it has no model
  [[nodiscard]] model::System machine(const project::Case& variant, const Eigen::VectorXd& draws) const;

 private:
  struct Number {
    project::ModelNumber number;
    double given = 0;
    std::size_t tolerance = 0, place = 0;
    Eigen::Index draw = 0;
  };
  const std::vector<project::Tolerance>& tolerances_;
  std::vector<Number> list_;
};

/// True for prices: no number of the model moves them.
[[nodiscard]] bool is_constant(const RequirementResult& result);

/// One case of a sample: judges its requirements for drawn designs, by kernels over many designs where these prove all
/// of them, otherwise by assembled models.
class SampledCase {
 public:
  /// Designs that are judged at once: by kernels as many as have their matrices in the cache, by models few.
  static constexpr std::size_t kernel_piece = 120, model_piece = 8;

  /// @throws foundation::NotComputable if a requirement cannot be judged in the case as given, InvalidInput if a number
  /// of a tolerance cannot be read there
  SampledCase(const project::Case& variant, const std::vector<project::Tolerance>& tolerances,
              const DrawnDesigns& drawn, const project::SampleRequest& request = {});

  [[nodiscard]] const project::Case& variant() const { return case_; }
  /// The requirements of the case as given.
  [[nodiscard]] const std::vector<RequirementResult>& given() const { return given_; }
  /// Why all designs are assembled; empty if kernels judge them.
  [[nodiscard]] const std::string& no_kernels() const { return no_kernels_; }
  [[nodiscard]] const std::optional<DesignBatch>& batch() const { return batch_; }
  /// Ends of the ranges of the draws for which kernels judge; those of machines beyond are assembled.
  [[nodiscard]] const Eigen::ArrayXd& from() const { return from_; }
  [[nodiscard]] const Eigen::ArrayXd& to() const { return to_; }
  /// Those whose amplitudes are counted, if any are.
  [[nodiscard]] const std::optional<BandCurves>& bands() const { return bands_; }
  /// True if kernels compute all that is counted of nearly all designs.
  [[nodiscard]] bool is_quick() const { return no_kernels_.empty() && (!bands_ || bands_->no_kernels().empty()); }

  /// @param draws  designs × draws  @param interruption  called meanwhile, may throw foundation::Interrupted
  [[nodiscard]] SampledMargins judged(const Eigen::MatrixXd& draws,
                                      const foundation::Progress& interruption = {}) const {
    return judged(draws, 0, interruption);
  }
  /// The same with the amplitudes of the bands.
  [[nodiscard]] SampledMargins judged_with_bands(const Eigen::MatrixXd& draws,
                                                 const foundation::Progress& interruption = {}) const {
    return judged(draws, bands_ ? bands_->values() : 0, interruption);
  }
  /// The margins by assembled models alone.
  [[nodiscard]] SampledMargins assembled(const Eigen::MatrixXd& draws,
                                         const foundation::Progress& interruption = {}) const;

 private:
  /// @param amplitudes  of the bands, per design; 0: none are computed
  [[nodiscard]] SampledMargins judged(const Eigen::MatrixXd& draws, Eigen::Index amplitudes,
                                      const foundation::Progress& interruption) const;
  [[nodiscard]] SampledMargins unfilled(Eigen::Index designs, Eigen::Index amplitudes) const;
  /// @throws foundation::NotComputable, InvalidInput if a requirement cannot be judged, or its margin is not a number
  void set_margins(const model::System& machine, Eigen::Index design, SampledMargins& into,
                   const foundation::Progress& interruption) const;
  void set_amplitudes(const model::System& machine, Eigen::Index design, SampledMargins& into) const;
  /// Those by a model that kernels have not computed, of a design whose margins they have proven.
  void complete_amplitudes(const Eigen::MatrixXd& draws, Eigen::Index design, SampledMargins& into,
                           const foundation::Progress& interruption) const;
  [[nodiscard]] model::System system(const Eigen::VectorXd& draws) const { return numbers_.machine(case_, draws); }
  [[nodiscard]] std::vector<RequirementResult> results(const model::System& system,
                                                       const foundation::Progress& interruption = {}) const;
  void fit(const DrawnDesigns& drawn);
  /// Sets the ranges of all draws, without tails of these shares or of more, where their ends have no model with the
  /// other draws in their middle. @return why there are none; else empty
  std::string set_ranges(const DrawnDesigns& drawn, double tail);
  /// Why a design has no model; empty if it has one.
  [[nodiscard]] std::string without_model(const Eigen::VectorXd& draws) const;
  /// Why kernels cannot prove all requirements of a design; empty if they can.
  [[nodiscard]] std::string beyond_kernels() const;
  [[nodiscard]] std::string not_covered(const CaseVector& packed) const;
  /// Judges one design by its model; into row `design`.
  void assemble(const Eigen::MatrixXd& draws, Eigen::Index design, SampledMargins& into,
                const foundation::Progress& interruption) const;

  const project::Case& case_;
  ToleratedNumbers numbers_;
  std::vector<RequirementResult> given_;
  std::optional<DesignBatch> batch_;
  std::optional<BandCurves> bands_;
  Eigen::ArrayXd from_, to_;  ///< draws for which the batch was fitted
  std::string no_kernels_;
};

}  // namespace trivet::study
