// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/design/sum_family.h"
#include "trivet/study/family/case_vector.h"
#include "trivet/study/family/design_space.h"

namespace trivet::study {

/// One case as a family over the parameters of a search: a list of numbers for every design without its model.
class CaseSurrogate {
 public:
  /// @param results  of the case as given
  CaseSurrogate(const DesignSpace& space, const project::Case& variant, const project::Analyses& request,
                const std::vector<RequirementResult>& results);

  /// Why there is none; empty if there is one.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// True if some requirement is judged without a model.
  [[nodiscard]] bool judges() const { return family_ && judges_; }
  /// True if a requirement has slopes without a model.
  [[nodiscard]] bool gives_slopes(std::size_t result) const { return family_ && packed_.gives_slopes(result); }
  [[nodiscard]] const CaseVector& packed() const { return packed_; }
  [[nodiscard]] const design::SumFamily& family() const { return *family_; }
  /// "a sum of 40 terms from 61 assembled designs, compared with 24 others: largest deviation 3e-15"
  [[nodiscard]] std::string words() const;

 private:
  CaseVector packed_;
  std::optional<design::SumFamily> family_;
  std::string reason_;
  bool judges_ = false;
};

}  // namespace trivet::study
