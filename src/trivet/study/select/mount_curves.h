// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/family/case_vector.h"
#include "trivet/study/select/mount_combinations.h"

namespace trivet::study {

/// Margins of amplitudes and peaks of many combinations of mounts at once, in a few microseconds each.
///
/// The packed list of a combination (case_vector.h) is a sum over the choices like its stiffness: l = l₀ + Σ (l_i −
/// l₀), with l_i of the model in which only one choice differs from the given design. The sum is compared with
/// assembled models of some combinations; where it is not exact, there are no margins.
class MountCurves {
 public:
  /// @param all  used by the result
  explicit MountCurves(const MountCombinations& all);

  /// Why there are no margins; empty if there are, or if no requirement has a curve.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] bool empty() const { return cases_.empty(); }

  /// Least margin of amplitudes and peaks of each combination in all cases; infinite where nothing is proven.
  [[nodiscard]] std::vector<double> margins(const std::vector<std::size_t>& combinations,
                                            const foundation::Progress& progress) const;
  /// The same of isolations alone.
  [[nodiscard]] std::vector<double> isolation_margins(const std::vector<std::size_t>& combinations,
                                                      const foundation::Progress& progress) const;

 private:
  struct Case {
    CaseVector packed;
    Eigen::VectorXd given, scales;
    std::vector<std::vector<Eigen::VectorXd>> changes;  ///< per choice and mount
  };
  [[nodiscard]] std::vector<double> least_margins(const std::vector<std::size_t>& combinations, bool of_isolations,
                                                  const foundation::Progress& progress) const;
  void add_case(const project::Case& variant);
  [[nodiscard]] std::string difference_from_assembled() const;
  [[nodiscard]] Eigen::VectorXd sum(const Case& one, std::size_t combination) const;

  const MountCombinations& all_;
  std::vector<Case> cases_;
  std::string reason_;
};

}  // namespace trivet::study
