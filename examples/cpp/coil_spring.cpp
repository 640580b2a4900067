// SPDX-License-Identifier: BSD-3-Clause
// How stiff is a coil spring across its axis, and at which frequencies does it surge?
#include <cstdio>
#include <numbers>

#include "trivet/elements/coil_dynamics.h"
#include "trivet/elements/coil_spring.h"

int main() {
  using namespace trivet::elements;
  const CoilSpring spring{.wire = RoundWire{.diameter = 0.016},
                          .mean_diameter = 0.12,
                          .active_coils = 6.5,
                          .active_length = 0.25,
                          .youngs_modulus = 206e9,
                          .shear_modulus = 79.3e9,
                          .density = 7850};
  const Matrix12 k = stiffness(spring);  // ends N and K, three translations and three rotations each
  std::printf("axial %.1f N/mm, transverse %.1f and %.1f N/mm\n", k(8, 8) / 1e3, k(6, 6) / 1e3, k(7, 7) / 1e3);
  for (const double omega : natural_frequencies(spring, SeatsHeld::both, 4))
    std::printf("surge mode at %.1f Hz\n", omega / (2 * std::numbers::pi));
}
