// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trivet/design/driven_design.h"
#include "trivet/design/plain_design.h"

namespace trivet::design {

/// One of the two variables of a family.
struct FamilyVariable {
  double from = 0, to = 1;
  std::string name;  ///< for the text of the reason
};

struct FamilyPoint {
  double x = 0, y = 0;
};

/// Entries of K differ from those of a separately assembled design by at most this share of √(K_ii K_jj); the same
/// holds for the other matrices, the loads and the rows of results, each with its own scale.
inline constexpr double reproduced_within = 1e-12;

template <typename Design>
class DesignFamily;

/// A family, or the reason why there is none: that of the design that has no suitable form, or "… polynomials … do not
/// reproduce …".
template <typename Design>
struct FamilyOrReason {
  std::optional<DesignFamily<Design>> family;
  std::string reason;
};

/// Designs as smooth functions of two variables: polynomials through a few of them, checked against further designs.
/// @tparam Design  PlainDesign or DrivenDesign
template <typename Design>
class DesignFamily {
 public:
  /// The design at a point, or why it has no such form; the attempt then ends with that reason.
  using Source = std::function<DesignOrReason<Design>(const FamilyPoint&)>;

  /// Along each variable, or its logarithm, nodes are doubled until one line through the middle is reproduced; then 25
  /// points of a lattice up to the ends of the ranges and 16 points between them must be reproduced. Returns a reason
  /// instead of a family if this fails or two designs cannot be in one family.
  [[nodiscard]] static FamilyOrReason<Design> fitted(const Source& source, const FamilyVariable& x,
                                                     const FamilyVariable& y);

  /// Matrices, loads and rows at the points, for the kernels of many designs.
  [[nodiscard]] auto designs(std::span<const FamilyPoint> points) const {
    return unpacked_like(first_, packed_designs(points));
  }

  [[nodiscard]] const Design& first() const { return first_; }  ///< what is not packed holds for all
  [[nodiscard]] double worst_difference() const {
    return worst_;
  }  ///< over the points that were checked, see reproduced_within
  [[nodiscard]] std::size_t x_nodes() const { return x_.nodes.size(); }
  [[nodiscard]] std::size_t y_nodes() const { return y_.nodes.size(); }

 private:
  DesignFamily() = default;
  [[nodiscard]] Eigen::VectorXd entries(const FamilyPoint& point) const;
  [[nodiscard]] Eigen::MatrixXd packed_designs(std::span<const FamilyPoint> points) const;  ///< points × entries

  /// Chebyshev nodes of one variable.
  struct Along {
    bool logarithmic = false;
    std::vector<double> nodes;
    [[nodiscard]] Eigen::VectorXd weights(double value) const;  ///< Lagrange's polynomials
  };
  [[nodiscard]] static std::optional<Along> fitted_along(const std::function<std::optional<Design>(double)>& source,
                                                         const FamilyVariable& variable);

  Along x_, y_;
  Eigen::MatrixXd values_;  ///< entries × (x nodes × y nodes), x fastest
  Design first_;
  double worst_ = 0;
};

extern template class DesignFamily<PlainDesign>;
extern template class DesignFamily<DrivenDesign>;

}  // namespace trivet::design
