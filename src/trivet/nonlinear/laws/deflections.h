// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/nonlinear/laws/contact_friction.h"
#include "trivet/nonlinear/laws/deviation_law.h"
#include "trivet/nonlinear/laws/distance_laws.h"

namespace trivet::nonlinear {

/// One deflection with nonlinear forces, as a deviation from rest.
struct Deflection {
  std::string name;  ///< "mount.deflection.z"
  bool is_rotation = false;
  Eigen::VectorXd on_coordinates;      ///< free coordinates: the deflection, and by virtual work the force on them
  Eigen::VectorXd on_ground;           ///< ground coordinates
  DeviationLaw law;                    ///< beyond the tangents that the assembled machine contains
  Eigen::VectorXd accelerations = {};  ///< of the coordinates per force on it; of friction without a spring only
  std::optional<DistanceAbout> distance = {};  ///< over this deflection and the next two
  struct Rubbing {
    std::size_t along = 0;  ///< the deflection that presses it across an axis
    ContactFriction law;
  };
  std::optional<Rubbing> rubbing = {};  ///< over this deflection and the next one, or the next two of a ring
  bool is_followed = false;             ///< without a law, for its phase: always an unknown
};

/// Stiffness and damping in place of nonlinear parts, both in the order of the elements.
struct References {
  std::vector<elements::SmallMotion> parts;
  std::vector<Eigen::Matrix3d> distances;  ///< stiffness; their damping is that at rest
};

/// Tangents of the nonlinear parts at rest, for motions of vanishing amplitude.
[[nodiscard]] References tangents_at_rest(const model::System& system);
/// The same, but the stiffness positive also where a part has none at rest, by its secant to a small deflection, and
/// the damping of dampers that have none at small rates by their secant to a small rate. Struts without tension are
/// stiff across their line, too.
[[nodiscard]] References positive_references(const model::System& system);

/// The machine with these in place of its nonlinear parts. In the position of rest it has the forces of the
/// parts, so that static results are those of the nonlinear machine.
[[nodiscard]] model::System with_references(const model::System& system, const References& references);

/// "mount.deflection.z", or "mount.track" of an inner part.
[[nodiscard]] std::string name_of(const model::Element& element, const model::NonlinearPart& part);

/// All nonlinear parts of a system, first those over one deflection, then three deflections for each distance, made by
/// `with_references`.
[[nodiscard]] std::vector<Deflection> nonlinear_deflections(const model::System& system,
                                                            const assembly::Assembled& assembled,
                                                            const References& references);

/// Unit deflections in the two directions across a part along an axis, on the ends of its element.
[[nodiscard]] std::array<elements::Vector12, 2> rows_across(const model::NonlinearPart& along, const model::Span& span);
/// Adds the friction of contacts: to rings, and after the others the two deflections across each stop that rubs.
void add_rubbings(const model::System& system, const assembly::Assembled& assembled, std::vector<Deflection>& found);

/// Accelerations of the coordinates per force on each deflection: s² (K + s B + s² A)⁻¹ W for large s. Infinite where
/// they grow with s: of nodes without mass.
/// @param across  coordinates × deflections
[[nodiscard]] Eigen::MatrixXd accelerations_per_force(const numerics::DynamicMatrices& matrices,
                                                      const Eigen::MatrixXd& across);

/// Has any part dampers without damping at small rates?
[[nodiscard]] bool has_slack_dampers(const model::System& system);

/// What changes and errors of deflections are compared with: translations with the largest translation, rotations with
/// the largest rotation. Metres and radians have no common measure, so that a large angle must not hide a travel that
/// it has nothing to do with; only round-off is small in both: the largest of a kind counts as at least a hundredth of
/// the one that needs the same energy as the largest of the other kind.
class DeflectionScales {
 public:
  /// @param receptance  at ω = 0, deflections × deflections
  DeflectionScales(const std::vector<Deflection>& deflections, const Eigen::MatrixXd& receptance);

  /// @param of  of each deflection, ≥ 0
  [[nodiscard]] Eigen::VectorXd largest_of_kind(const Eigen::VectorXd& of) const;

 private:
  std::vector<bool> is_rotation_;
  Eigen::VectorXd per_root_energy_;
};

}  // namespace trivet::nonlinear
