// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

/// One undamped mode K φ = ω² A φ. Vectors over all bodies have 6 entries each (zeros for constrained coordinates),
/// body axes.
struct Mode {
  int number = 0;                           ///< from 1, ascending ω²
  double eigenvalue_squared = 0;            ///< ω² [rad²/s²]; negative: the motion grows
  std::optional<double> angular_frequency;  ///< [rad/s]; 0 for a rigid-body mode, empty if ω² < 0
  double modal_mass = 1;                    ///< φᵀAφ: +1, or −1 with an indefinite mass matrix
  bool repeated = false;                    ///< one of an A-orthonormal basis of equal roots
  Eigen::VectorXd coordinates;  ///< φ in all coordinates of the assembled system, including foundations and internal
                                ///< coordinates of elements
  Eigen::VectorXd shape;        ///< at the poles
  Eigen::VectorXd shape_at_centre;       ///< at the centres of mass
  Eigen::VectorXd kinetic_energy_share;  ///< φ_j (Aφ)_j / φᵀAφ at the poles; sums to 1 with the next two; single terms
                                         ///< may be negative or exceed 1
  Eigen::VectorXd element_kinetic_energy_share;    ///< per element: the same of its internal coordinates
  double foundation_kinetic_energy_share = 0;      ///< the same of all coordinates of foundations together
  Eigen::VectorXd principal_kinetic_energy_share;  ///< of the bodies alone, along and about the central principal axes;
                                                   ///< all ≥ 0, sums to 1
  std::optional<Eigen::VectorXd>
      strain_energy_share;  ///< per element, sums to 1; empty if ω² = 0 or no element is strained
  /// φᵀK_fφ of all foundations over the sum of it and of the magnitude of that of all elements: 0 … 1.
  double foundation_strain_energy_share = 0;
  std::vector<spatial::Screw> screws;  ///< per body
  std::string name;                    ///< for display
};

struct Modes {
  std::vector<Mode> list;
  bool lowest_only = false;  ///< the list has the lowest modes, and there are others
  numerics::ModeRoute route = numerics::ModeRoute::definite_mass;
  foundation::Problems warnings;
};

/// Undamped natural modes. A constrained system has fewer than six per body; an unsymmetric one may lack modes (with a
/// warning).
[[nodiscard]] Modes modes(const model::System& system, const assembly::Assembled& assembled);
[[nodiscard]] Modes modes(const model::System& system);

/// At least the `count` lowest modes, for few modes of many bodies: by iteration on sparse factors, proven complete, or
/// all modes where that is not possible.
[[nodiscard]] Modes lowest_modes(const model::System& system, const assembly::Assembled& assembled, Eigen::Index count);

/// Number of the mode with the natural frequency nearest to ω. If some of the n modes are missing (complex ω²), a mode
/// is returned only if it is within 1 % of ω, because the nearest one may be among the missing.
[[nodiscard]] std::optional<int> nearest_mode(const Modes& modes, double omega, Eigen::Index n);

/// φᵀf of every mode, for generalized forces on all coordinates.
[[nodiscard]] Eigen::VectorXcd modal_forces(const Modes& modes, const Eigen::VectorXcd& forces);

/// True if any mode has ω = 0.
[[nodiscard]] bool has_rigid_motion(const Modes& modes);

/// Highest natural frequency of a system [rad/s], growing motions included; 1 if all are 0.
[[nodiscard]] double highest_natural_frequency(const model::System& system, const assembly::Assembled& assembled);

// Where the strain energy of a mode is, in words. Energies of elements with a negative stiffness, of struts under
// compression or of weight above a mount are negative: then shares of the sum, Mode::strain_energy_share, exceed 1.

/// Energy of every element over the sum of the positive ones and that of the foundations: at most 1, negative where an
/// element gives back. Empty as the shares of the mode are, or if no element stores energy.
[[nodiscard]] Eigen::VectorXd stored_energy(const Mode& mode);

/// Energies of a mode or a vibration that are given back, over those that are stored, from which on words say so.
constexpr double noticeably_given_back = 0.005;

struct MostStrained {
  bool in_foundations = false;  ///< instead of an element
  std::size_t element = 0;
  double share = 0;       ///< of what is stored, 0 … 1
  int alike = 0;          ///< further elements with the same share but for rounding
  double given_back = 0;  ///< by elements with negative energy, over what is stored, ≥ 0
};
/// The element with the most strain energy, or the foundations; none if nothing stores energy.
[[nodiscard]] std::optional<MostStrained> most_strained(const Mode& mode);

/// ", 77 % of it given back" for a noticeable share; else empty.
[[nodiscard]] std::string given_back_words(double given_back);

}  // namespace trivet::modal
