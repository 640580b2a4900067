// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
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

/// What the forces at rest add to the stiffness: docs/theory.md, "Forces at rest".
struct SecondOrder {
  /// Per element: its forces turn with it, axes of its ends. 0 for an element whose tangent contains this.
  std::vector<elements::Matrix12> of_elements;
  /// Free coordinates: the points of bodies at which forces act move on circles as bodies rotate.
  Eigen::MatrixXd of_levers;
  std::vector<std::size_t> without_rest;  ///< bodies that their weight moves without end: not included
  bool hangs_aside = false;               ///< some forces are those of a hung body that swings aside
};

/// Of gravity, constant forces and preloads, by the forces of the machine of the first order, with the static stiffness
/// of its rubber. A hung part that K₀ does not hold has the forces of its position of rest, if that is near the
/// drawing. Parts of the machine all of whose elements have a preload keep `geometric_stiffness`.
/// @param first  the machine of the first order
[[nodiscard]] SecondOrder second_order(const model::System& system, const Assembled& first);

/// The same as a function of the coordinates at rest, added to K of the first order: constant + Σ q_k per_coordinate_k.
struct SecondOrderForms {
  Eigen::MatrixXd constant;
  std::vector<Eigen::MatrixXd> per_coordinate;  ///< free coordinates, each n × n [N/m per m …]

  /// @param rest  coordinates under the whole load to first order, with the static stiffness of rubber
  [[nodiscard]] Eigen::MatrixXd at(const Eigen::VectorXd& rest) const;
};
[[nodiscard]] SecondOrderForms second_order_forms(const model::System& system, const Assembled& first);

/// Does the model need it: is there a weight?
[[nodiscard]] bool has_second_order(const model::System& system);

}  // namespace trivet::assembly
