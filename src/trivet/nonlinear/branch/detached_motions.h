// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "trivet/nonlinear/branch/resonances_at_load.h"
#include "trivet/nonlinear/branch/steady_path.h"

namespace trivet::nonlinear {

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
