// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/roots/designs.h"

namespace trivet::design {

/// A design that the fast method (poles and residues, several designs at once) can evaluate: real symmetric constant
/// matrices, one real constant load, results that are real combinations of displacements and velocities.
struct PlainDesign {
  Eigen::MatrixXd A, B, K;                 ///< n × n
  Eigen::VectorXd load;                    ///< n
  Eigen::MatrixXd rows, rows_on_velocity;  ///< results × n
  std::vector<int> derivative;             ///< order of the time derivative of each result
};

/// The design in that form, or the reason why it has no such form: "loss factors", "a moving ground" …
struct PlainDesignOrReason {
  std::optional<PlainDesign> plain;
  std::string reason;
};
[[nodiscard]] PlainDesignOrReason plain_design(const assembly::Assembled& assembled,
                                               const std::vector<assembly::Channel>& channels,
                                               const assembly::Loading& loading);

/// One of the two variables of a family.
struct FamilyVariable {
  double from = 0, to = 1;
  std::string name;  ///< for the text of the reason
};

struct FamilyPoint {
  double x = 0, y = 0;
};

struct FamilyOrReason;

/// Plain designs as smooth functions of two variables: polynomials through a few of them, checked against further
/// designs.
class DesignFamily {
 public:
  /// Entries of K differ from those of a separately assembled design by at most this share of √(K_ii K_jj); the same
  /// holds for A, B and the loads, each with its own scale.
  static constexpr double reproduced_within = 1e-12;

  /// The design at a point; if it is not plain, the attempt ends with its reason.
  using Source = std::function<PlainDesignOrReason(const FamilyPoint&)>;

  /// Along each variable, or its logarithm, nodes are doubled until one line through the middle is reproduced; then 25
  /// points of a lattice up to the ends of the ranges and 16 points between them must be reproduced. Returns a reason
  /// instead of a family if this fails or the rows of the results change.
  [[nodiscard]] static FamilyOrReason fitted(const Source& source, const FamilyVariable& x, const FamilyVariable& y);

  /// Matrices and loads at the points.
  [[nodiscard]] numerics::Designs designs(std::span<const FamilyPoint> points) const;

  [[nodiscard]] const PlainDesign& first() const { return first_; }  ///< rows and derivatives hold for all
  [[nodiscard]] double worst_difference() const {
    return worst_;
  }  ///< over the points that were checked, see reproduced_within
  [[nodiscard]] std::size_t x_nodes() const { return x_.nodes.size(); }
  [[nodiscard]] std::size_t y_nodes() const { return y_.nodes.size(); }

 private:
  DesignFamily() = default;
  [[nodiscard]] Eigen::VectorXd entries(const FamilyPoint& point) const;

  /// Chebyshev nodes of one variable.
  struct Along {
    bool logarithmic = false;
    std::vector<double> nodes;
    [[nodiscard]] Eigen::VectorXd weights(double value) const;  ///< Lagrange's polynomials
  };
  [[nodiscard]] static std::optional<Along> fitted_along(
      const std::function<std::optional<PlainDesign>(double)>& source, const FamilyVariable& variable);

  Along x_, y_;
  Eigen::MatrixXd values_;  ///< entries × (x nodes × y nodes), x fastest
  PlainDesign first_;
  double worst_ = 0;
};

/// A family, or the reason why there is none: that of the design that is not plain, or "… polynomials … do not
/// reproduce …".
struct FamilyOrReason {
  std::optional<DesignFamily> family;
  std::string reason;
};

}  // namespace trivet::design
