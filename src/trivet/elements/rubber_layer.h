// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/law.h"
#include "trivet/elements/materials.h"
#include "trivet/foundation/problems.h"

/// Rubber layers bonded between two rigid plates, linear, not preloaded. End N is the centre of one bonded face, K of
/// the other, e3 points from N to K: arm = (0, 0, thickness). Formulas, range and measured accuracy:
/// docs/elements/rubber.md.
namespace trivet::elements {

/// `measured` (default) corrects the pressure solution at the free edges by finite-element results: within 1 … 4 %.
/// `textbook`: Gent–Lindley compression, Gent–Meinecke tilting, shear G A/h; within 3 … 25 %.
enum class LayerFormulas { measured, textbook };

/// Cylinder, with or without a central hole whose wall is free. Lengths [m]. dynamic_factor [1] = dynamic over static
/// stiffness.
struct RubberDisc {
  Rubber rubber;
  double radius = 0;
  double hole_radius = 0;
  double thickness = 0;
  double dynamic_factor = 1;
  LayerFormulas formulas = LayerFormulas::measured;
};

/// Rectangular block, width_1 along e1, width_2 along e2 [m].
struct RubberBlock {
  Rubber rubber;
  double width_1 = 0;
  double width_2 = 0;
  double thickness = 0;
  double dynamic_factor = 1;
  LayerFormulas formulas = LayerFormulas::measured;
};

/// Constants of a layer at its mid-height: shear and axial [N/m]; bending about e1 and e2 with the plates' centres held
/// in the shear-free position, torsion about e3 [N m/rad].
struct LayerConstants {
  double shear_1 = 0, shear_2 = 0, axial = 0, bending_1 = 0, bending_2 = 0, torsion = 0;
};
[[nodiscard]] LayerConstants layer_constants(const RubberDisc& disc);
[[nodiscard]] LayerConstants layer_constants(const RubberBlock& block);

/// Stiffness 12×12 of one layer. @throws InvalidInput if check() finds an error
[[nodiscard]] Matrix12 rubber_disc(const RubberDisc& disc);
[[nodiscard]] Matrix12 rubber_block(const RubberBlock& block);

[[nodiscard]] foundation::Problems check(const RubberDisc& disc);
[[nodiscard]] foundation::Problems check(const RubberBlock& block);

}  // namespace trivet::elements
