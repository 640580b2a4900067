// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {
namespace {

/// From a tenth of the lowest to 1.5 times the highest natural frequency about rest, or the speeds at which orders are
/// there. Modes of parts that float, such as decouplers, do not count.
assembly::Band usual_band(const CaseContext& c, const std::vector<std::string>& excitations) {
  std::vector<double> frequencies;
  for (const modal::Mode& mode : c.modes.list)
    if (mode.angular_frequency && *mode.angular_frequency > 0) frequencies.push_back(*mode.angular_frequency);
  if (frequencies.empty())
    throw foundation::NotComputable("steady: no natural frequency about rest to choose a band from; give band = […]");
  constexpr double floats = 1e-3;
  const double high = std::ranges::max(frequencies);
  double low = high;
  for (const double omega : frequencies)
    if (omega > floats * high) low = std::min(low, omega);
  const nonlinear::PeriodicExcitation acting = nonlinear::periodic_excitation(c.system, c.assembled, excitations);
  const double first = acting.first_harmonic * static_cast<double>(acting.harmonics.front()),
               last = acting.first_harmonic * static_cast<double>(acting.highest());
  return {0.1 * low / last, 1.5 * high / first};
}

/// Within the band; on its lower end the curve begins, so a little above it.
std::vector<double> requested_places(const project::SteadyAnalysis& request, const nonlinear::SteadyOptions& options) {
  constexpr double beside = 1e-12;
  std::vector<double> places;
  for (const double place : request.harmonics_at) {
    if (!(place >= options.from * (1 - beside) && place <= options.to * (1 + beside)))
      throw foundation::InvalidInput(fmt::format(
          "steady: at = {:.6g} Hz is outside the band {:.6g} … {:.6g} Hz; give one inside, or another band in the file",
          place / foundation::two_pi, options.from / foundation::two_pi, options.to / foundation::two_pi));
    places.push_back(std::clamp(place, options.from * (1 + beside), options.to));
  }
  return places;
}

}  // namespace

nonlinear::SteadyBranch steady_motions(const CaseContext& c, const project::SteadyAnalysis& request,
                                       const std::vector<assembly::MotionQuantity>& quantities) {
  if (!model::is_nonlinear(c.system))
    throw foundation::InvalidInput(
        "steady: the machine is linear; take response, or give an element laws or a stop (docs/nonlinear.md)");
  nonlinear::SteadyOptions options;
  const auto band = [&] { return request.band ? *request.band : usual_band(c, request.selection.excitations); };
  if (request.over_load_factor) {
    options.over = nonlinear::Parameter::load_factor;
    options.angular_frequency = request.at;
    if (!request.phase_of.empty()) options.at_phase = {request.phase_of, request.lag, band().from, band().to};
    options.from = request.load_from;
    options.to = request.load_to;
  } else {
    options.from = band().from;
    options.to = band().to;
  }
  options.excitations = request.selection.excitations;
  options.of = request.selection.of;
  options.quantity = request.selection.quantity;
  options.quantities = quantities;
  options.at = requested_places(request, options);
  options.harmonics = request.harmonics;
  options.tolerance = request.tolerance;
  options.detached = request.all_branches;
  options.deep = request.deep;
  return nonlinear::steady_branch(c.system, options, c.progress);
}

namespace {

std::string place_words(const nonlinear::SteadyBranch& branch, const nonlinear::SteadyPoint& point) {
  return branch.over == nonlinear::Parameter::load_factor
      ? fmt::format("{:.6g} times the load", point.load_factor)
      : fmt::format("{:.6g} Hz", point.angular_frequency / foundation::two_pi);
}

/// "12 harmonics leave out 0.002"
std::string left_out_words(const nonlinear::SteadyBranch& branch) {
  return fmt::format("{} {} out {:.2g}", branch.harmonics,
                     branch.harmonics == 1 ? "harmonic leaves" : "harmonics leave", branch.left_out);
}

/// Multipliers that are not accurate enough, and motions that creep.
/// @param of  "", or "further curve 2: "
void warn_of_multipliers(const std::string& of, const nonlinear::SteadyBranch& branch, foundation::Problems& warnings) {
  constexpr double slow = 0.999, real_axis = 1e-9, free = 1 - 1e-7;  // a free body has 1
  int inaccurate = 0, uncertain = 0, stable = 0, creep = 0;
  double worst = 0, slowest = 0;
  const nonlinear::SteadyPoint* first = nullptr;
  for (const nonlinear::SteadyPoint& point : branch.points) {
    if (point.uncertain) {
      ++uncertain;
      if (!first) first = &point;
    }
    if (!point.multipliers_hold) {
      ++inaccurate;
      worst = std::max(worst, point.multiplier_uncertainty);
      continue;
    }
    if (!point.stable) continue;
    ++stable;
    double largest = 0;
    for (const std::complex<double>& multiplier : point.multipliers)
      if (std::abs(multiplier.imag()) <= real_axis && multiplier.real() < free)
        largest = std::max(largest, multiplier.real());
    if (largest > slow) {
      ++creep;
      slowest = std::max(slowest, largest);
    }
  }
  if (inaccurate > 0)
    warnings.warning(
        "analyses.steady",
        fmt::format("{}the multipliers of {} of {} motions are uncertain", of, inaccurate, branch.points.size()),
        std::isfinite(worst) && worst > 0
            ? fmt::format("the shortest steps still change the transition over a period by up to {:.1g}", worst)
            : "deviations grow so far within a period, or their product is so far from Liouville's formula, that the "
              "numbers do not hold",
        "where the second verdict (the winding number) can be computed, it decides");
  if (uncertain > 0)
    warnings.warning(
        "analyses.steady",
        fmt::format("{}the stability of {} of {} motions is uncertain", of, uncertain, branch.points.size()),
        fmt::format("the first at {}; two verdicts differ, or the only one does not hold", place_words(branch, *first)),
        "they count neither as stable nor as unstable, and the largest values leave them out; take more "
        "harmonics, or a lower tolerance");
  if (2 * creep > stable)
    warnings.warning(
        "analyses.steady",
        fmt::format("{}{} of {} stable motions are reached slowly: a deviation falls to 1/e in up to {:.2g} "
                    "periods",
                    of, creep, stable, -1 / std::log(slowest)),
        "a multiplier is real and close to 1, for instance of friction that slips little",
        "a machine may run with another mean for a long time");
}

/// @param of  as above
/// A multiplier is 1 at a fold; with too few harmonics it is not.
void warn_of_folds(const std::string& of, const nonlinear::SteadyBranch& branch, foundation::Problems& warnings) {
  constexpr double far = 0.05;
  if (branch.multipliers_of != nonlinear::SteadyBranch::Multipliers::machine || branch.of_amplitude) return;
  double farthest = 0;
  const nonlinear::Fold* worst = nullptr;
  for (const nonlinear::Fold& fold : branch.folds) {
    const double away = (fold.point.multipliers.array() - 1.0).abs().minCoeff();
    if (away <= std::max(far, farthest)) continue;
    farthest = away;
    worst = &fold;
  }
  if (!worst) return;
  warnings.warning("analyses.steady",
                   fmt::format("{}no multiplier is 1 at the fold at {}: the nearest is {:.2g} away", of,
                               place_words(branch, worst->point), farthest),
                   "a stop is just touched there, or the harmonics are too few for verdicts beside it: stability is "
                   "lost at the fold, and changes near it may be false",
                   "take a lower tolerance, or more harmonics; if the number stays, a stop is touched");
}

void warn_of_verdicts(const std::string& of, const nonlinear::SteadyBranch& branch, foundation::Problems& warnings) {
  if (branch.held_share > 0)
    warnings.warning("analyses.steady",
                     of + "harmonics leave the table of an element, which is held constant beyond its end",
                     fmt::format("they have {:.2g} of the deflections", branch.held_share),
                     "extend the table if this share matters");
  if (!branch.winding.differs_at.empty() && !branch.winding.decides)
    warnings.warning(
        "analyses.steady",
        fmt::format("{}two verdicts on stability differ at {} of {} points", of, branch.winding.differs_at.size(),
                    branch.winding.points),
        branch.over == nonlinear::Parameter::load_factor
            ? fmt::format("the first at {:.6g} times the load", branch.winding.differs_at.front())
            : fmt::format("the first at {:.6g} Hz", branch.winding.differs_at.front() / foundation::two_pi),
        "take more harmonics; close to a change of stability both are uncertain");
  warn_of_multipliers(of, branch, warnings);
  warn_of_folds(of, branch, warnings);
}

}  // namespace

void warn_of_motions(const CaseContext& c, const project::SteadyAnalysis& request,
                     const nonlinear::SteadyBranch& branch, foundation::Problems& warnings) {
  if (!branch.of_shaft && request.selection.excitations.empty())
    for (const model::Excitation& excitation : c.system.description().excitations)
      if (std::holds_alternative<model::Orders>(excitation.course))
        warnings.warning("analyses.steady", "\"" + excitation.name + "\" does not act",
                         "harmonic excitations and orders have no common period, and the harmonic ones are taken",
                         "name it in excitations of steady to have the motion under its orders");
  if (branch.left_out > request.tolerance)
    warnings.warning("analyses.steady", fmt::format("{} of the deflections", left_out_words(branch)),
                     fmt::format("the tolerance is {:.2g}", request.tolerance),
                     request.harmonics > 0      ? "take more, or leave their number to the tolerance"
                         : branch.stops.empty() ? "give their number, above 60: harmonics = 120"
                                                : "near grazing contact no number of harmonics is enough");
  warn_of_verdicts("", branch, warnings);
  for (std::size_t i = 0; i < branch.further.size(); ++i) {
    const nonlinear::SteadyBranch& curve = branch.further[i];
    if (curve.left_out > request.tolerance)
      warnings.warning("analyses.steady",
                       fmt::format("further curve {}: {} of the deflections", i + 1, left_out_words(curve)),
                       fmt::format("the tolerance is {:.2g}", request.tolerance), "take more harmonics");
    if (!curve.ended.empty())
      warnings.warning("analyses.steady", fmt::format("further curve {} is not whole", i + 1), curve.ended,
                       "what lies beyond is not computed");
    warn_of_verdicts(fmt::format("further curve {}: ", i + 1), curve, warnings);
  }
  if (!branch.lost_means.empty())
    warnings.warning("analyses.steady",
                     foundation::comma_separated(branch.lost_means) +
                         ": smooth friction bears a part of the load at rest, and none in motion",
                     "the mean of the motion contains this shift, however small the excitation",
                     "compare half the peak-to-peak value, or leave the load to other elements");
  if (!branch.sticking.empty())
    warnings.warning(
        "analyses.steady",
        foundation::comma_separated(branch.sticking) + ": friction sticks all the time at some frequencies",
        "the mean of its force is then undetermined; here a slider has stuck since rest, and "
        "a stop that rubs where it is farthest from slip",
        "take such means as one of many");
  if (!branch.ended.empty())
    warnings.warning("analyses.steady", "the branch of motions ends before the end of the band", branch.ended,
                     "no motion beyond is computed; give another band");
}

namespace {

nonlinear::SteadyBranch steady_result(const CaseContext& c, const project::SteadyAnalysis& request,
                                      foundation::Problems& warnings) {
  nonlinear::SteadyBranch branch = steady_motions(c, request);
  warn_of_motions(c, request, branch, warnings);
  return branch;
}

}  // namespace

const AnalysisRun steady_run = computed_by<&project::Analyses::steady, &CaseResults::steady, steady_result>(
    "periodic motions of nonlinear machines, with folds, jumps and stability");

}  // namespace trivet::study
