// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/nonlinear/branch/steady_path.h"
#include "trivet/nonlinear/machine/reference_machine.h"

namespace trivet::nonlinear {

/// Motions under the whole load that lie on curves of phase resonance: along such a curve the excitation feeds what is
/// dissipated, so that it is the backbone of a mode with the load that holds it there.
struct ResonancesAtLoad {
  int curves = 0;  ///< followed
  std::vector<SteadyEquations::Place> motions;
};

/// For each damped mode about rest whose resonance may come into the band, and each excited harmonic: the translation
/// and the rotation of nonlinear parts that it moves most are held at the phase of the linear resonance, and the load
/// is raised from a small one through the folds of the curve, at most 400 points of 64 such curves.
/// @param options  over frequency
[[nodiscard]] ResonancesAtLoad resonances_at_load(const ReferenceMachine& machine, const SteadyOptions& options,
                                                  Eigen::Index harmonics, double load_up_to,
                                                  const foundation::Progress& progress);

/// The load is raised to this many times itself where detached motions are sought.
inline constexpr double load_of_search = 20;

/// What was done to find motions that are not connected with the one at the lower end of the band. It is a search, not
/// a proof that there are no more.
struct DetachedSearch {
  int places = 0;           ///< of the parameter, evenly over the band
  int starts = 0;           ///< of Newton's method, with random amplitudes and phases
  int beside_unstable = 0;  ///< starts beside unstable motions that are known
  int rests = 0;            ///< other positions of rest, about which motions were sought at each place
  int resonances = 0;       ///< curves of phase resonance over the load, on which it was sought too
  double load_up_to = 0;    ///< the load was raised there at each place, through the folds of its path
};

struct DetachedPaths {
  DetachedSearch search;
  std::vector<std::unique_ptr<SteadyPath>> paths;
};

/// @param known     paths of the same period: the connected one and those that branch off it; their mirror images are
///                  known too
/// @param rests     from the position of rest to others: changes of the deflections
/// @param resonances  under the whole load; empty over the load factor
/// @param new_path  an empty path of the same machine and harmonics
[[nodiscard]] DetachedPaths detached_paths(const SteadyPath& connected, const std::vector<const SteadyPath*>& known,
                                           const std::vector<Deflection>& deflections,
                                           const std::vector<Eigen::VectorXd>& rests,
                                           const ResonancesAtLoad& resonances, const SteadyOptions& options,
                                           const std::function<std::unique_ptr<SteadyPath>()>& new_path,
                                           const foundation::Progress& progress);

}  // namespace trivet::nonlinear
