// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <limits>
#include <variant>

#include "trivet/elements/law.h"
#include "trivet/foundation/problems.h"

namespace trivet::elements {

struct RoundWire {
  double diameter = std::numeric_limits<double>::quiet_NaN();  ///< [m]
};
struct RectangularWire {
  double radial_width = std::numeric_limits<double>::quiet_NaN();  ///< normal to the spring's axis [m]
  double axial_height = std::numeric_limits<double>::quiet_NaN();  ///< along it [m]
};
using Wire = std::variant<RoundWire, RectangularWire>;

enum class Hand { right, left };
/// Constraint of the end of the wire by its seat: clamped in all six motions, or pivoted: no moment about e1 and e2,
/// but torsion is held.
enum class Seat { clamped, pivoted };

/// A cylindrical coil spring between two seats. End N is at the origin, K at (0, 0, seat_distance); the wire starts at
/// end N, at the angle `start_angle` from e1 about e3. NaN means not given.
struct CoilSpring {
  Wire wire;
  double mean_diameter = std::numeric_limits<double>::quiet_NaN();  ///< D, of the wire's centre line [m]
  double active_coils = std::numeric_limits<double>::quiet_NaN();   ///< n, need not be an integer
  double active_length =
      std::numeric_limits<double>::quiet_NaN();  ///< free length of the active coils along the axis, n · pitch [m]
  Hand hand = Hand::right;
  double start_angle = 0;                                            ///< [rad]
  double youngs_modulus = std::numeric_limits<double>::quiet_NaN();  ///< [Pa]
  double shear_modulus = std::numeric_limits<double>::quiet_NaN();   ///< [Pa]
  double density = std::numeric_limits<double>::quiet_NaN();         ///< [kg/m³]; needed if the wire's mass is used
  double loss_factor = 0;                                            ///< η of both moduli, E(1 + iη)
  /// Timoshenko's shear factor; if NaN, Cowper's: 6(1+ν)/(7+6ν) round, 10(1+ν)/(12+11ν) rectangular.
  double shear_factor = std::numeric_limits<double>::quiet_NaN();
  /// Closed coils at each end, rigidly attached to the seat: each adds mass, and the height of the wire.
  double dead_coils_n = 0;
  double dead_coils_k = 0;
  Seat seat_n = Seat::clamped;
  Seat seat_k = Seat::clamped;
};

/// All problems of the spring, with the field names as subjects. `massive`: the density is needed.
[[nodiscard]] foundation::Problems check(const CoilSpring& spring, bool massive = false);

/// @throws InvalidInput with the first error of check().
void require_sound(const CoilSpring& spring, bool massive);

/// Height of the wire along the axis [m].
[[nodiscard]] double wire_height(const CoilSpring& spring);
/// Spring index D/d, with the radial width of a rectangular wire.
[[nodiscard]] double spring_index(const CoilSpring& spring);
/// Distance between the two reference points, seat to seat: active length and dead coils [m].
[[nodiscard]] double seat_distance(const CoilSpring& spring);

/// Section constants of the wire. Axes: 1 towards the spring's axis, 2 binormal, 3 along the wire.
struct WireSection {
  double area = 0;                                           ///< [m²]
  double shear_factor = 0;                                   ///< on GA, both directions
  double torsion_constant = 0;                               ///< St Venant [m⁴]
  Eigen::Vector3d second_moments = Eigen::Vector3d::Zero();  ///< about 1 and 2, and their sum, the polar one [m⁴]
};
[[nodiscard]] WireSection wire_section(const CoilSpring& spring);

/// 12×12 stiffness of the massless spring at its seats, stress-free: flexibility of the helical Timoshenko rod in
/// closed form.
/// @throws InvalidInput if the spring has errors
[[nodiscard]] Matrix12 stiffness(const CoilSpring& spring);

/// Stress correction factors of round wire for the index C = D/d > 1, at the inside of the coil.
[[nodiscard]] double wahl_factor(double index);           ///< (4C − 1)/(4C − 4) + 0.615/C
[[nodiscard]] double bergstraesser_factor(double index);  ///< (C + ½)/(C − ¾), that of EN 13906-1

/// Torsional shear stress [Pa] of the wire under an axial force [N] of either sign, as for a straight wire: 8 F D/(π
/// d³) for round wire, at the middle of the longer side for rectangular wire. Not negative.
[[nodiscard]] double nominal_shear_stress(const CoilSpring& spring, double axial_force);

/// The same times Wahl's factor, for fatigue.
/// @throws InvalidInput for rectangular wire, to which the factor does not apply
[[nodiscard]] double wahl_shear_stress(const CoilSpring& spring, double axial_force);

}  // namespace trivet::elements
