// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/elements/coil_dynamics.h"

namespace trivet::elements {

/// A coil spring compressed along its axis (stretched if negative). Its seats stay parallel and do not rotate. The wire
/// keeps its number of turns; its lead and radius change uniformly, and its ends slide out and tilt with the helix.
struct CompressedCoil {
  double compression = 0;    ///< shortening of the active coils [m]
  double axial_force = 0;    ///< exerted by the seats, positive in compression [N]
  double axial_moment = 0;   ///< about e3, applied by seat K to prevent rotation [N m]
  Helix line;                ///< of the wire's sections, compressed
  double wire_height = 0;    ///< [m]
  double seat_distance = 0;  ///< [m]
  SeatedCoil coil;           ///< for dynamic stiffness, natural frequencies and reduction about this state
  /// Tangent stiffness 12×12 in this state, with geometric stiffness; symmetric: second derivative of the energy
  /// with respect to rotation vectors. Its product with a rigid rotation ψ is ψ × force, ½ ψ × moment at each end.
  Matrix12 stiffness = Matrix12::Zero();
  /// Force and moment that the bodies apply to the spring at its seats (N, K), local frame.
  spatial::Vector12 preload = spatial::Vector12::Zero();
};

/// @throws InvalidInput if the spring has errors or its coils would touch, NotComputable if it is stretched so far that
/// no equilibrium is found
[[nodiscard]] CompressedCoil compressed_by(const CoilSpring& spring, double compression);
[[nodiscard]] CompressedCoil compressed_with(const CoilSpring& spring, double axial_force);

/// Compression and force at which the spring first buckles laterally, with its seats held as given; nullopt if its
/// coils touch before.
struct Buckling {
  double compression = 0;  ///< [m]
  double axial_force = 0;  ///< [N]
};
[[nodiscard]] std::optional<Buckling> buckling(const CoilSpring& spring, SeatsHeld held);

/// Buckling compression by the formula of EN 13906-1 for parallel seats (ν = 0.5), a column of smeared coils; nullopt
/// if it predicts no buckling. It is valid for an index around 10 and many coils, and too low otherwise:
/// docs/elements/coil_spring.md.
[[nodiscard]] std::optional<double> standard_buckling(const CoilSpring& spring);

/// Error if the coils touch or the spring has buckled; warning close to buckling, or with fewer than 4 coils.
[[nodiscard]] foundation::Problems check_compression(const CoilSpring& spring, double compression);

}  // namespace trivet::elements
