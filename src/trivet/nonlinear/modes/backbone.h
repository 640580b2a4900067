// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/model/system.h"
#include "trivet/nonlinear/balance/observed_motion.h"

namespace trivet::nonlinear {

struct BackboneOptions {
  Eigen::Index mode = 0;  ///< of the machine about rest, ascending ω, from 0
  /// Largest deviation of any nonlinear deflection, translations [m] and rotations [rad], and largest energy [J]; one
  /// of them is finite.
  double up_to = std::numeric_limits<double>::infinity(), up_to_angle = std::numeric_limits<double>::infinity(),
         up_to_energy = std::numeric_limits<double>::infinity();
  Eigen::Index harmonics = 7;
  bool damped = false;
  std::vector<std::string> of;  ///< results, as channels
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
  std::vector<double> at_energy;  ///< also exactly at these energies [J], wherever the branch passes them
  int most_points = 4000;
};

/// A free periodic motion.
struct BackbonePoint {
  double angular_frequency = 0;         ///< [rad/s]
  double energy = 0;                    ///< above that of rest; damped: the largest kinetic energy [J]
  double damping_ratio = 0;             ///< of the mode; 0 if the backbone is undamped
  Eigen::MatrixXcd coordinates;         ///< free coordinates × harmonics 0, 1, …: complex amplitudes
  double deflection = 0;                ///< largest deviation of any nonlinear deflection [m, rad]
  double share = 0;                     ///< of the requested end
  std::vector<ObservedMotion> results;  ///< in the order of Backbone::results
};

struct Backbone {
  Eigen::Index mode = 0;         ///< from 0
  double angular_frequency = 0;  ///< natural frequency about rest [rad/s]
  std::vector<std::string> results, units;
  std::vector<BackbonePoint> points;     ///< along the branch, from small motions
  std::vector<BackbonePoint> at_energy;  ///< at the requested energies, in the order of the branch
  Eigen::Index harmonics = 0;
  double left_out = 0;            ///< largest share of the motion beyond the harmonics, at any point
  std::string ended;              ///< why it ends before the requested end; empty: it does not
  std::vector<std::string> held;  ///< undamped: deflections in which friction sticks to the end
};

/// The nonlinear mode that a mode about rest becomes as its energy grows: free periodic motions in which all
/// coordinates pass through their extremes together. Undamped: dampers are left out and friction sticks. Damped: with a
/// damping of −2 ζ ω A that feeds what all dampers and loops lose [extended periodic motion, Krack 2015]; ζ is the
/// damping ratio.
/// @throws foundation::NotComputable if there is no such mode, or with elements that depend on frequency
[[nodiscard]] Backbone backbone(const model::System& system, const BackboneOptions& options,
                                const foundation::Progress& progress = {});

}  // namespace trivet::nonlinear
