// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"

/// Piston engines. The engine frame has its origin on the crank axis, x along the crankshaft and z up, the axis of an
/// upright cylinder. The crank turns positively about x (from y to z). θ is the crank angle from z, positive with the
/// rotation.
namespace trivet::excitation {

/// One cylinder. An axis at bank angle β points along (0, −sin β, cos β): like θ, β is measured from z with the
/// rotation.
struct Cylinder {
  double position = 0;    ///< x of its axis [m]
  double bank_angle = 0;  ///< β [rad]
  double crank_angle =
      0;  ///< angle of its throw at θ = 0 [rad]; its piston is at top dead centre when θ + crank_angle = β
  double firing_angle =
      std::numeric_limits<double>::quiet_NaN();  ///< θ of its firing top dead centre [rad]; unset: no gas torque
};

struct Engine {
  double crank_radius = 0;      ///< r [m] > 0
  double rod_ratio = 0;         ///< λ = r / length of the rod, 0 < λ < 1
  double oscillating_mass = 0;  ///< [kg] ≥ 0 per cylinder: piston, pin, and small-end share of the rod
  double rotating_mass = 0;     ///< [kg] ≥ 0 per cylinder, at the crank radius: big-end share of the rod, and the throw
  double counterweight = 0;     ///< [kg m] ≥ 0 per cylinder, mass × radius opposite to its throw
  int strokes = 4;              ///< 4 or 2: a cycle takes 4π or 2π of θ
  std::vector<Cylinder> cylinders = {};

  [[nodiscard]] double cycle() const { return strokes * std::numbers::pi; }
};

/// Errors: numbers out of range, no cylinder, a firing angle at which the piston is not at top dead centre (to 0.01°).
[[nodiscard]] foundation::Problems check(const Engine& engine, const std::string& subject);

/// Cylinder layout of an engine with even firing intervals.
struct EngineLayout {
  enum class Kind { in_line, vee, boxer };
  Kind kind = Kind::in_line;
  int cylinders = 1;       ///< even for vee and boxer, numbered first along one bank (at +β/2, from the front),
                           ///< then along the other
  double bank_angle = 0;   ///< [rad], between the banks of a vee; a boxer has π
  double spacing = 0;      ///< [m] between neighbours of a bank
  double bank_offset = 0;  ///< [m] distance of the second bank behind the first
  /// Numbers from 1. Empty: the usual order of a four-stroke in-line engine of 1 … 6 or 8 cylinders.
  std::vector<int> firing_order = {};
  int strokes = 4;
};

/// Cylinders of the layout, cylinder 1 in front at the largest x, all centred about x = 0. The crank angles follow from
/// the firing order: its entry k, from 0, fires at θ = k · cycle/count.
/// @throws foundation::InvalidInput for a layout that does not exist
[[nodiscard]] std::vector<Cylinder> evenly_firing_cylinders(const EngineLayout& layout);

}  // namespace trivet::excitation
