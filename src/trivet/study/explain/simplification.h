// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

/// Error of replacing elements by three springs: compares the model with and without their rotational stiffness and
/// coupling.
namespace trivet::study {

/// A mode of the full model and the mode of the simplified model with the most similar motion of the bodies.
struct ModeComparison {
  int number = 0;  ///< of the mode in the full model
  std::string name;
  std::optional<double> full;        ///< angular frequency [rad/s]; 0 for a rigid-body mode, none if unstable
  std::optional<double> simplified;  ///< the same; also none if no mode is left to compare with
  double similarity =
      0;  ///< squared cosine between the shapes of the bodies, mass-weighted: 1 for equal shapes, 0 for orthogonal ones
};

/// The highest resonance peak of one curve.
struct HighestPeak {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;          ///< infinite without damping
};
struct PeakComparison {
  std::string name, unit;
  std::optional<HighestPeak> full, simplified;  ///< none: the curve has no peak
  bool vanishes = false;  ///< the simplified curve is zero except for round-off, the full one is not
};

struct Simplification {
  std::vector<std::string> replaced;  ///< names of the elements replaced by three springs
  std::vector<std::string> left_out;  ///< properties lost in addition to rotational stiffness and coupling, as text
  std::vector<ModeComparison> modes;  ///< of the bodies, ascending
  int inner_modes = 0;                ///< of the full model: motions mostly inside elements, which are not compared
  std::optional<double> first_inner_mode;  ///< [rad/s]
  std::vector<std::string> free_motions;   ///< rigid-body modes that only the simplified model has, as text
  std::vector<PeakComparison> peaks;
  std::string no_peaks;  ///< reason if there are none; empty otherwise
};

/// simplified / full − 1; none unless both are finite numbers and `full` > 0.
[[nodiscard]] std::optional<double> relative_difference(std::optional<double> full, std::optional<double> simplified);

/// The system with some elements replaced by `elements::three_springs` of their nominal stiffness: scale and kind of
/// damping remain (a damping matrix becomes three dashpots); mass, preload and frequency dependence are dropped.
/// @throws foundation::NotComputable if such a system fails the checks
[[nodiscard]] model::System with_three_springs(const model::System& system, const std::vector<std::size_t>& replaced);

/// Modes and highest peaks of a case with and without the simplification; without excitation only modes.
/// @throws foundation::NotComputable as `with_three_springs`
[[nodiscard]] Simplification simplification(const project::Case& variant, const std::vector<std::size_t>& replaced,
                                            const foundation::Progress& progress = {});

}  // namespace trivet::study
