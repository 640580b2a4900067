// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/sum_family.h"
#include "trivet/study/family/case_vector.h"

namespace trivet::study {

/// The numbers that differ between the designs of one case.
struct DesignNumbers {
  std::vector<design::SumVariable> variables;
  /// The model with these values. @throws foundation::NotComputable if there is none
  std::function<model::System(const Eigen::VectorXd& values)> model;
  design::SumFamily::Compared compared = design::SumFamily::Compared::spread;
  bool any_size = false;  ///< see CaseVector: all designs are judged, whatever it takes
};

/// Many designs of one case, judged at once: a list of numbers for every design without its model (CaseVector), as sums
/// over its own numbers (SumFamily), from which kernels compute margins (packed_margins.h). Maps, sweeps and searches
/// are loops over it; each assembles the designs that the kernels do not prove.
class DesignBatch {
 public:
  /// @param request  requirements of the case  @param results  of the case as given
  DesignBatch(const DesignNumbers& numbers, const project::Case& variant, const project::Analyses& request,
              const std::vector<RequirementResult>& results);

  /// Why there is none; empty if there is one.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// True if some requirement is judged without a model.
  [[nodiscard]] bool judges() const { return family_ && judges_; }
  /// True if a requirement has slopes without a model.
  [[nodiscard]] bool gives_slopes(std::size_t result) const { return family_ && packed_.gives_slopes(result); }
  [[nodiscard]] const CaseVector& packed() const { return packed_; }
  [[nodiscard]] const design::SumFamily& family() const { return *family_; }

  /// @param points  designs × numbers  @pre there is no reason
  [[nodiscard]] CaseVector::Unpacked designs(const Eigen::MatrixXd& points) const {
    return packed_.unpacked(family_->designs(points));
  }

 private:
  void fit(const DesignNumbers& numbers);

  CaseVector packed_;
  std::optional<design::SumFamily> family_;
  std::string reason_;
  bool judges_ = false;
};

}  // namespace trivet::study
