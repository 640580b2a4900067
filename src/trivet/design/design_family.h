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

/// A design that poles and residues in lanes can judge: real symmetric constant matrices, one real constant load,
/// answers that are real combinations of displacements and velocities.
struct PlainDesign {
  Eigen::MatrixXd A, B, K;                 ///< n × n
  Eigen::VectorXd load;                    ///< n
  Eigen::MatrixXd rows, rows_on_velocity;  ///< answers × n
  std::vector<int> derivative;             ///< of the answers
};

/// The design in that form, or what stands against it, in words: "loss factors", "a moving ground" …
struct PlainOrNot {
  std::optional<PlainDesign> plain;
  std::string reason;
};
[[nodiscard]] PlainOrNot plain_design(const assembly::Assembled& assembled,
                                      const std::vector<assembly::Channel>& channels, const assembly::Loading& loading);

/// One of the two variables of a family.
struct FamilyVariable {
  double from = 0, to = 1;
  std::string name;  ///< for the words of a refusal
};

struct FamilyPoint {
  double x = 0, y = 0;
};

struct FamilyOrNot;

/// Plain designs as smooth functions of two variables: polynomials through a few of them, of which further ones were
/// found to be reproduced.
class DesignFamily {
 public:
  /// Entries differ from those of a design of its own by at most this share of √(K_ii K_jj), and A, B, loads and rows
  /// likewise.
  static constexpr double reproduced_within = 1e-12;

  /// The design at a point; none ends the attempt with its reason.
  using Source = std::function<PlainOrNot(const FamilyPoint&)>;

  /// Along each variable, or its logarithm, nodes are doubled until one line through the middle is reproduced; then 25
  /// points of a lattice up to the ends of the ranges and 16 between them must be. None, with the reason, if that does
  /// not come about, or the answers' rows change.
  [[nodiscard]] static FamilyOrNot fitted(const Source& source, const FamilyVariable& x, const FamilyVariable& y);

  /// Matrices and loads at points.
  [[nodiscard]] numerics::Designs designs(std::span<const FamilyPoint> points) const;

  [[nodiscard]] const PlainDesign& first() const { return first_; }  ///< rows and derivatives hold for all
  [[nodiscard]] double worst_difference() const {
    return worst_;
  }  ///< of the points that were checked, see reproduced_within
  [[nodiscard]] std::size_t x_nodes() const { return x_.nodes.size(); }
  [[nodiscard]] std::size_t y_nodes() const { return y_.nodes.size(); }

 private:
  DesignFamily() = default;
  [[nodiscard]] Eigen::VectorXd entries(const FamilyPoint& point) const;

  /// Chebyshev points of one variable.
  struct Along {
    bool logarithmic = false;
    std::vector<double> nodes;
    [[nodiscard]] Eigen::VectorXd weights(double value) const;  ///< Lagrange's polynomials
  };
  [[nodiscard]] static std::optional<Along> fitted_along(
      const std::function<std::optional<PlainDesign>(double)>& source, const FamilyVariable& variable);

  Along x_, y_;
  Eigen::MatrixXd values_;  ///< entries × (x nodes × y nodes), x running
  PlainDesign first_;
  double worst_ = 0;
};

/// A family, or what stands against it, in words: those of the design that is not plain, or "… polynomials … do not
/// meet … along …".
struct FamilyOrNot {
  std::optional<DesignFamily> family;
  std::string reason;
};

}  // namespace trivet::design
