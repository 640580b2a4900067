// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/coil_dynamics.h"

namespace trivet::elements {

/// A coil spring compressed along its axis (stretched where negative). Its seats stay parallel and do not turn, its
/// wire keeps its number of turns, takes a new lead and widens uniformly; the ends slide out and tilt as the helix
/// does.
struct CompressedCoil {
  double compression = 0;    ///< shortening of the active coils [m]
  double axial_force = 0;    ///< that the seats press with, positive in compression [N]
  double axial_moment = 0;   ///< about e3, that seat K applies so that it does not turn [N m]
  Helix line;                ///< of the wire's sections, compressed
  double wire_height = 0;    ///< [m]
  double seat_distance = 0;  ///< [m]
  SeatedCoil coil;           ///< for dynamic stiffness, natural frequencies and reduction about this state
  /// Tangent 12×12 about this state, with geometric stiffness; symmetric: it is the second derivative of the energy
  /// with respect to rotation vectors. Its product with a rigid rotation ψ is ψ × force, ½ ψ × moment at each end.
  Matrix12 stiffness = Matrix12::Zero();
  /// Force and moment that N and K's bodies apply to the spring at its seats, (N, K), local frame.
  spatial::Vector12 preload = spatial::Vector12::Zero();
};

/// @throws InvalidInput if the spring has errors or its coils would touch, NotComputable if it is stretched beyond all
/// springs
[[nodiscard]] CompressedCoil compressed_by(const CoilSpring& spring, double compression);
[[nodiscard]] CompressedCoil compressed_with(const CoilSpring& spring, double axial_force);

/// Compression and force at which the spring first buckles sideways, with its seats held so; none if its coils touch
/// before.
struct Buckling {
  double compression = 0;  ///< [m]
  double axial_force = 0;  ///< [N]
};
[[nodiscard]] std::optional<Buckling> buckling(const CoilSpring& spring, SeatsHeld held);

/// The same compression by the formula of EN 13906-1 for parallel seats (ν = 0.5), a column of smeared coils; none if
/// it never buckles by it. It holds for an index around 10 and many coils, and is early otherwise:
/// docs/elements/coil_spring.md.
[[nodiscard]] std::optional<double> standard_buckling(const CoilSpring& spring);

/// A compression at which coils touch or the spring has buckled is an error; close to buckling, or of fewer than 4
/// coils, a warning.
[[nodiscard]] foundation::Problems check_compression(const CoilSpring& spring, double compression);

}  // namespace trivet::elements
