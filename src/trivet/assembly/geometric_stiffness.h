// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/assembly/layout.h"

namespace trivet::assembly {

/// Contribution of forces at rest to K when bodies turn about their poles: a force F that a body exerts at the lever a
/// adds ½(aFᵀ + Faᵀ) − (a·F) I to its rotations; its weight at the centre of mass adds the negative of the same formula
/// (pendulum).
class Levers {
 public:
  Levers(const model::System& system, const Layout& layout);

  /// @param force  exerted by the body at `at`, both in its frame
  void add(std::size_t body, const Eigen::Vector3d& at, const Eigen::Vector3d& force);
  void add_weight(std::size_t body);
  /// The preloads on bodies that `is_selected` accepts, and the weights of those that have any.
  template <typename Predicate>
  void add_preloads(const Predicate& is_selected) {
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      if (is_selected(b)) add_preloads_of(b);
  }
  [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }

 private:
  void add_preloads_of(std::size_t body);

  const model::System& system_;
  const Layout& layout_;
  Eigen::MatrixXd stiffness_;
};

/// That of the preloads, and of the weights of bodies with a preloaded element, which they balance. Zero for other
/// bodies; the tangent matrices of preloaded elements contain only the effect between their ends.
[[nodiscard]] Eigen::MatrixXd geometric_stiffness(const model::System& system, const Layout& layout);

}  // namespace trivet::assembly
