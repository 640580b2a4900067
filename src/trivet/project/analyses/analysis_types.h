// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/excitation/human_weighting.h"
#include "trivet/excitation/shock_spectrum.h"
#include "trivet/model/harmonic_force.h"
#include "trivet/project/analyses/analysis.h"
#include "trivet/project/analyses/limit_line_request.h"
#include "trivet/project/analyses/requirements.h"

namespace trivet::project {

/// Nonlinear modes: free periodic motions over their amplitude.
struct BackboneAnalysis : Analysis {
  std::vector<int> modes = {1};  ///< of the machine about rest, from 1
  /// Largest deflection of any nonlinear part, translations [m] and rotations [rad], and largest energy [J].
  double up_to = std::numeric_limits<double>::infinity(), up_to_angle = std::numeric_limits<double>::infinity(),
         up_to_energy = std::numeric_limits<double>::infinity();
  bool damped = false;
  int harmonics = 0;        ///< 0: as many as `tolerance` needs
  double tolerance = 1e-3;  ///< share of the deflections that harmonics beyond the last one may add
};

/// Largest results of an earthquake by its response spectrum.
struct EarthquakeAnalysis : Analysis {
  excitation::ResponseSpectrum spectrum;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

/// What happens at the speeds at which the machine runs: the table [operation]. Results named by `selection.of`; none:
/// all coordinates and all points.
struct OperationAnalysis : Analysis {
  std::vector<assembly::Band> speeds;               ///< [rad/s]; from = to: one speed, else a range
  std::vector<AmplitudeLimit> limits;               ///< of amplitudes at these speeds, without a scope of their own
  std::optional<excitation::BandWidth> bands = {};  ///< root mean squares of the orders in these bands too
  std::vector<LimitLineRequest> lines = {};         ///< over bands; those of this width bound them

  [[nodiscard]] bool has_lines() const {
    return std::ranges::any_of(lines, [this](const LimitLineRequest& line) { return line.bands == bands; });
  }
};

/// Run-up: all orders over the speed of the shaft.
struct OrdersAnalysis : Analysis {
  assembly::Band speed;         ///< [rad/s]
  std::vector<double> at = {};  ///< single speeds that are told besides [rad/s]
};

/// Mean power into the ground at each mount.
struct PowerAnalysis : BandAnalysis {
  std::vector<double> at = {};  ///< single frequencies that are told besides [rad/s]
};

/// Root mean squares and spectral densities under the random excitations.
struct RandomAnalysis : Analysis {
  std::optional<excitation::Weighting> weighting;  ///< of the accelerations of all requested motions
  std::optional<excitation::ContactPoint>
      contact;  ///< instead: each axis as people feel it there, with the vibration total value
  std::optional<excitation::BandWidth> bands = {};  ///< root mean squares in these bands too
};

/// Operating deflection shapes at single frequencies.
struct ShapesAnalysis : Analysis {
  std::vector<double> at;  ///< [rad/s]
};

/// Shock response spectra of time excitations.
struct ShockSpectrumAnalysis : Analysis {
  double damping_ratio = 0.05;
  assembly::Band band;  ///< of natural frequencies [rad/s]
};

/// Periodic motions of a nonlinear machine under its harmonic excitations, over their frequency or their load factor.
struct SteadyAnalysis : BandAnalysis {
  bool over_load_factor = false;
  double at = 0;  ///< over the load factor: the fixed ω [rad/s]
  double load_from = 0, load_to = 0;
  std::string phase_of;       ///< or, over the load factor, at the frequency where this result lags; empty: at `at`
  double lag = 0;             ///< by this phase [rad]
  int harmonics = 0;          ///< 0: as many as `tolerance` needs
  bool all_branches = false;  ///< seek detached motions too
  bool deep = false;          ///< judge the stability of every point in two ways
  std::vector<double> harmonics_at = {};  ///< tell the harmonics of all motions there [rad/s]
  double tolerance = 1e-3;                ///< share of the deflections that harmonics beyond the last one may add
};

/// Time histories under the excitations of type time.
struct TransientAnalysis : Analysis {
  double from = 0;             ///< [s]
  std::optional<double> to;    ///< [s]
  std::optional<double> step;  ///< [s]
  bool nearest_linear_system = false;
  std::vector<std::pair<std::string, double>> displacements,
      velocities;  ///< initial, by coordinate: "frame.z" [m, rad, m/s, rad/s]
};

/// Force on the ground over one force excitation, or motion of the wanted bodies and points over a unit motion of the
/// whole ground.
struct TransmissibilityAnalysis : BandAnalysis {
  std::string force;            ///< the excitation; empty: a motion of the ground
  model::Direction direction;   ///< of a motion
  std::vector<double> at = {};  ///< single frequencies that are told besides [rad/s]
};

}  // namespace trivet::project
