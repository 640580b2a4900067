// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

/// What it costs to take elements for three springs: the same model with and without their rotational stiffness and
/// coupling.
namespace trivet::study {

/// A mode of the model as it is, beside the mode of the simplified model that moves the bodies most alike.
struct ModeComparison {
  int number = 0;  ///< of the mode in the model as it is
  std::string name;
  std::optional<double> full;        ///< angular frequency [rad/s]; 0 for a free motion, none if the motion grows
  std::optional<double> simplified;  ///< likewise; none also where no mode is left to compare with
  double likeness =
      0;  ///< squared cosine of the shapes of the bodies, weighted with their mass: 1 alike, 0 nothing in common
};

/// The highest resonance peak of one curve.
struct HighestPeak {
  double angular_frequency = 0;  ///< [rad/s]
  double amplitude = 0;          ///< infinite without damping
};
struct PeakComparison {
  std::string name, unit;
  std::optional<HighestPeak> full, simplified;  ///< none: the curve has no peak
  bool vanishes = false;                        ///< the simplified curve is zero but for round-off, the full one is not
};

struct Simplification {
  std::vector<std::string> replaced;  ///< names of the elements taken for three springs
  std::vector<std::string> left_out;  ///< what these lose besides rotational stiffness and coupling, in words
  std::vector<ModeComparison> modes;  ///< of the bodies, ascending
  int inner_modes = 0;                ///< of the model as it is: motions mostly inside elements, which are not compared
  std::optional<double> first_inner_mode;  ///< [rad/s]
  std::vector<std::string> free_motions;   ///< what the simplified model leaves free and the full one holds, in words
  std::vector<PeakComparison> peaks;
  std::string no_peaks;  ///< why there are none; empty otherwise
};

/// simplified / full − 1; none unless both are finite numbers and `full` > 0.
[[nodiscard]] std::optional<double> relative_difference(std::optional<double> full, std::optional<double> simplified);

/// The system with some elements as `elements::three_springs` of their nominal stiffness: scale and kind of damping
/// stay (a damping matrix becomes three dashpots likewise); mass, preload and frequency dependence go.
/// @throws foundation::NotComputable if such a system fails the checks
[[nodiscard]] model::System with_three_springs(const model::System& system, const std::vector<std::size_t>& replaced);

/// Modes and highest peaks of a case with and without the simplification; without excitation modes only.
/// @throws foundation::NotComputable as `with_three_springs`
[[nodiscard]] Simplification simplification(const project::Case& variant, const std::vector<std::size_t>& replaced,
                                            const foundation::Progress& progress = {});

}  // namespace trivet::study
