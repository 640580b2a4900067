// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/branch/steady_branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/branch/branched_motions.h"
#include "trivet/nonlinear/branch/enough_harmonics.h"
#include "trivet/nonlinear/branch/observed_path.h"
#include "trivet/nonlinear/branch/phase_resonance.h"
#include "trivet/nonlinear/branch/steady_path.h"
#include "trivet/nonlinear/laws/held_by_friction.h"
#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;

/// Amplitudes of the machine that is linear about rest.
void add_linear(const model::System& given, const SteadyOptions& options, SteadyBranch& found) {
  constexpr int count = 400;
  const ReferenceMachine about_rest(given, tangents_at_rest(given), options.excitations);
  const Observer observer(about_rest.system, about_rest.assembled, about_rest.excitation, about_rest.deflections,
                          options.of, options.quantity, options.quantities);
  const PeriodicExcitation& excitation = about_rest.excitation;
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(numerics::coefficient_count(excitation.highest()),
                                                     about_rest.condensed.basis().spread.cols());
  found.linear.resize(count, to_index(found.results.size()));
  for (int i = 0; i < count; ++i) {
    const double parameter = options.from * std::pow(options.to / options.from, i / (count - 1.0));
    found.linear_at.push_back(parameter);
    const bool over_frequency = options.over == Parameter::frequency;
    const double omega = excitation.first_harmonic * (over_frequency ? parameter : options.angular_frequency),
                 factor = over_frequency ? 1 : parameter;
    const std::vector<ObservedMotion> motions =
        observer.at(about_rest.condensed.coordinates(none, omega, factor), none, omega, factor);
    for (std::size_t c = 0; c < motions.size(); ++c)
      found.linear(i, to_index(c)) =
          excitation.of_shaft ? motions[c].half_of_range() : std::abs(motions[c].harmonics(0));
  }
}

/// A curve begins where the harmonics have it, and the multipliers pass 1 beside it by what the harmonics leave out. As
/// near as that the verdict is one of errors: motions there have that of the first one farther away.
void settle_end(const StabilityChange& at, bool is_last, SteadyBranch& curve) {
  constexpr double farther = 10, least = 1e-5;
  std::vector<SteadyPoint>& points = curve.points;
  const auto count = to_index(points.size());
  const auto place = [&](Index i) { return to_size(is_last ? count - 1 - i : i); };
  const double change = curve.parameter(at.point), beside = std::abs(curve.parameter(points[place(0)]) - change),
               near = std::max(farther * beside, least * change);
  Index first = 1;
  while (first + 1 < count && std::abs(curve.parameter(points[place(first)]) - change) <= near) ++first;
  for (Index i = 0; i < first; ++i) {
    points[place(i)].stable = points[place(first)].stable;
    points[place(i)].uncertain = points[place(first)].uncertain;
  }
  std::erase_if(curve.changes, [&](const StabilityChange& one) {
    return is_last ? to_index(one.after) >= count - 1 - first : to_index(one.after) < first;
  });
}

/// Does a curve of the same period pass the motion at a change of stability? Where it was not located exactly, a curve
/// from another change may come by.
bool passes(const SteadyBranch& curve, const SteadyPoint& change, const HarmonicBalance& balance) {
  constexpr double near = 1e-3, same = 0.02;
  const double parameter = curve.parameter(change);
  return std::ranges::any_of(curve.points, [&](const SteadyPoint& point) {
    return std::abs(curve.parameter(point) - parameter) < near * parameter &&
        balance.are_same(balance.unknowns_of(point.deflections), balance.unknowns_of(change.deflections), same);
  });
}

/// Is any motion of a curve stable at a parameter?
bool is_stable_at(const SteadyBranch& curve, double parameter) {
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const SteadyPoint &here = curve.points[i], &next = curve.points[i + 1];
    if ((curve.parameter(here) < parameter) != (curve.parameter(next) < parameter) && here.stable && next.stable)
      return true;
  }
  return false;
}

/// The curves beside the connected one, in the order in which they are reported.
class Curves {
 public:
  /// @param beside  another curve that is known; null: none
  Curves(const ReferenceMachine& machine, SteadyPath& path, std::unique_ptr<SteadyPath> beside,
         const SteadyOptions& options, const foundation::Progress& progress)
      : machine_(machine),
        path_(path),
        beside_(std::move(beside)),
        options_(options),
        progress_(progress),
        observed_(machine, path, options) {}

  /// @returns nothing if another curve leaves out more than that; `enough_harmonics` then has a number to begin with
  [[nodiscard]] std::optional<SteadyBranch> all(double most_left_out) {
    SteadyBranch found = observed_.branch(progress_);
    const bool doubles = std::ranges::any_of(found.changes, [](const StabilityChange& change) {
      return change.kind == StabilityChange::Kind::period_doubling;
    });
    if (doubles) twice_ = std::make_unique<const ReferenceMachine>(machine_, ReferenceMachine::TwoPeriods());
    branched_ = branched_paths(found.changes, path_, machine_, twice_.get(), options_, progress_);
    for (const std::size_t change : branched_.sought_at) found.changes[change].sought = true;
    for (const BranchedPath& one : branched_.paths) require_harmonics(*one.path, most_left_out, one.periods);
    if (enough_harmonics_ > path_.balance().harmonics()) return std::nullopt;
    std::vector<const SteadyPath*> of_one_period = {&path_};
    for (const BranchedPath& one : branched_.paths)
      if (one.periods == 1) of_one_period.push_back(one.path.get());
    if (beside_) of_one_period.push_back(beside_.get());
    if (options_.detached) {
      const auto new_path = [&] { return path_with(machine_, path_.balance().harmonics()); };
      detached_ =
          detached_paths(path_, of_one_period, machine_.deflections, to_other_positions_of_rest(machine_.system),
                         resonances(), options_, new_path, progress_);
      for (const auto& one : detached_.paths) {
        require_harmonics(*one, most_left_out, 1);
        of_one_period.push_back(one.get());
      }
      if (enough_harmonics_ > path_.balance().harmonics()) return std::nullopt;
      found.search = detached_.search;
    }
    if (beside_) detached_.paths.insert(detached_.paths.begin(), std::move(beside_));
    for (const auto& one : detached_.paths) {
      ObservedPath observed(machine_, *one, options_);
      found.further.push_back(observed.branch(progress_));
      observed.add_landings(motions_of(of_one_period), found.further.back());
    }
    observed_.add_landings(motions_of(of_one_period), found);
    for (const BranchedPath& one : branched_.paths) add(one, motions_of(of_one_period), found);
    for (const SteadyBranch& curve : found.further) {
      if (curve.periods != 2) continue;
      note_doubled(curve, found);
      for (SteadyBranch& other : found.further)
        if (other.periods == 1) note_doubled(curve, other);
    }
    return found;
  }

  [[nodiscard]] Index enough_harmonics() const { return enough_harmonics_; }

 private:
  [[nodiscard]] ResonancesAtLoad resonances() const {
    if (options_.over != Parameter::frequency) return {};
    return resonances_at_load(machine_, options_, path_.balance().harmonics(), load_of_search, progress_);
  }

  [[nodiscard]] std::unique_ptr<SteadyPath> path_with(const ReferenceMachine& machine, Index harmonics) const {
    return std::make_unique<SteadyPath>(machine.condensed, machine.deflections, machine.excitation, options_,
                                        harmonics);
  }

  /// Raises `enough_harmonics` to what a curve needs, counted over one period of the excitation.
  void require_harmonics(const SteadyPath& curve, double most_left_out, int periods) {
    if (!(curve.left_out() > most_left_out)) return;
    const ReferenceMachine& machine = periods == 2 ? *twice_ : machine_;
    const auto finer = [&](Index harmonics) { return path_with(machine, periods * harmonics); };
    enough_harmonics_ = std::max(enough_harmonics_, harmonics_for(curve, most_left_out, periods, finer));
  }

  static ObservedPath::MotionsAt motions_of(const std::vector<const SteadyPath*>& paths) {
    return [paths](double parameter) {
      std::vector<numerics::BranchPoint> all;
      for (const SteadyPath* path : paths)
        for (numerics::BranchPoint& point : path->motions().all_at(parameter)) all.push_back(std::move(point));
      return all;
    };
  }

  /// A motion of one period cannot be said to jump to one of two: there are several.
  static void note_doubled(const SteadyBranch& doubled, SteadyBranch& curve) {
    for (Fold& fold : curve.folds)
      if (is_stable_at(doubled, curve.parameter(fold.point))) {
        fold.lands.reset();
        ++fold.stable_there;
      }
  }

  void add(const BranchedPath& one, const ObservedPath::MotionsAt& of_one_period, SteadyBranch& found) const {
    for (const std::size_t change : one.changes_at_ends) found.changes[change].curve = found.further.size();
    const bool doubled = one.periods == 2;
    ObservedPath observed(doubled ? *twice_ : machine_, *one.path, options_);
    SteadyBranch curve = observed.branch(progress_);
    curve.found = SteadyBranch::Found::branched;
    curve.periods = one.periods;
    settle_end(found.changes[one.changes_at_ends.front()], false, curve);
    if (one.changes_at_ends.size() > 1) settle_end(found.changes[one.changes_at_ends.back()], true, curve);
    if (!doubled) {
      for (StabilityChange& change : found.changes)
        if (!change.curve && change.kind == StabilityChange::Kind::branch_point &&
            passes(curve, change.point, path_.balance()))
          change.curve = found.further.size();
      observed.add_landings(of_one_period, curve);
    } else {
      observed.add_landings(
          [&](double parameter) {
            std::vector<numerics::BranchPoint> all = one.path->motions().all_at(parameter);
            for (numerics::BranchPoint& point : of_one_period(parameter)) {
              point.unknowns =
                  one.path->balance().unknowns_of(over_two_periods(path_.balance().motion(point.unknowns)));
              all.push_back(std::move(point));
            }
            return all;
          },
          curve);
      // It may end at a change that the multipliers place beside the one of the harmonics.
      constexpr double near = 1e-3;
      const double end = curve.parameter(curve.points.back());
      const bool leaves_band = end <= options_.from || end >= options_.to;
      for (StabilityChange& change : found.changes)
        if (!leaves_band && !change.curve && change.kind == StabilityChange::Kind::period_doubling &&
            std::abs(found.parameter(change.point) - end) < near * end)
          change.curve = found.further.size();
    }
    found.further.push_back(std::move(curve));
  }

  const ReferenceMachine& machine_;
  SteadyPath& path_;
  std::unique_ptr<SteadyPath> beside_;
  const SteadyOptions& options_;
  const foundation::Progress& progress_;
  ObservedPath observed_;
  std::unique_ptr<const ReferenceMachine> twice_;
  BranchedPaths branched_;
  DetachedPaths detached_;
  Index enough_harmonics_ = 0;
};

/// Deflections whose smooth loops bear a force at rest, which they lose in motion.
std::vector<std::string> lost_means(const std::vector<Deflection>& deflections) {
  std::vector<std::string> names;
  for (const Deflection& deflection : deflections)
    if (std::ranges::any_of(deflection.law.hysteretic(),
                            [](const auto& part) {
                              return part.at_state != 0 && !std::holds_alternative<elements::Slider>(part.law);
                            }) ||
        std::ranges::any_of(deflection.law.bristles(), [](const auto& part) { return part.at_state != 0; }))
      names.push_back(deflection.name);
  return names;
}

void check(const SteadyOptions& options) {
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput(
        fmt::format("steady: the band [{}, {}] must rise from above 0", options.from, options.to));
  if (options.at_phase &&
      !(options.over == Parameter::load_factor && options.at_phase->from > 0 &&
        options.at_phase->to > options.at_phase->from))
    throw foundation::InvalidInput("steady: a phase is held over the load factor, in a band that rises from above 0");
  if (options.over == Parameter::load_factor && !options.at_phase && !(options.angular_frequency > 0))
    throw foundation::InvalidInput("steady: over the load factor, the frequency must be above 0");
  if (options.at_phase && (options.deep || options.detached))
    throw foundation::InvalidInput(
        "steady: at a phase one curve is followed, with one verdict on stability; leave out deep and branches");
  if (options.harmonics < 0) throw foundation::InvalidInput("steady: at least one harmonic");
}

/// What the excitation and the data of elements allow.
void check(const SteadyOptions& options, const ReferenceMachine& machine) {
  check_harmonics(options, machine.excitation);
  const Index highest = machine.excitation.highest();
  const double last = options.over == Parameter::frequency ? options.to : options.angular_frequency,
               excited = static_cast<double>(highest) * machine.excitation.first_harmonic * last;
  if (excited > machine.condensed.known_to())
    throw foundation::NotComputable(
        fmt::format("steady: the excitation reaches {:.6g} Hz, and the table of an element ends at {:.6g} Hz; end the "
                    "band at {:.6g} "
                    "Hz",
                    excited / foundation::two_pi, machine.condensed.known_to() / foundation::two_pi,
                    machine.condensed.known_to() / excited * last / foundation::two_pi));
}

}  // namespace

int SteadyPoint::unstable_multipliers() const {
  constexpr double round_off = 1e-6;  // an undamped machine has multipliers of magnitude 1, as exact as the splitting
  return static_cast<int>((multipliers.cwiseAbs().array() >= 1 + round_off).count());
}

std::vector<const SteadyBranch*> SteadyBranch::further_ones(Found how) const {
  std::vector<const SteadyBranch*> curves;
  for (const SteadyBranch& curve : further)
    if (curve.found == how) curves.push_back(&curve);
  return curves;
}

const char* words(StabilityChange::Kind kind) {
  switch (kind) {
    case StabilityChange::Kind::period_doubling:
      return "period doubling";
    case StabilityChange::Kind::quasi_periodic:
      return "quasi-periodic motion begins";
    case StabilityChange::Kind::branch_point:
      return "branch point";
  }
  return "";
}

SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                           const foundation::Progress& progress) {
  check(options);
  require_elastic_hold(system, "steady");
  const HoldAtRest hold = hold_at_rest(system);
  const References references = references_of(system, hold);
  if (options.at_phase) return phase_resonances(system, options, references, progress);
  const ReferenceMachine machine(system, references, options.excitations);
  check(options, machine);
  const Index fewest = std::max<Index>(5, machine.excitation.highest());
  const bool is_given = options.harmonics > 0;
  std::optional<SteadyPath::Known> known;
  Index harmonics = is_given ? options.harmonics : fewest;
  const auto raise = [&] { harmonics = std::min(options.most_harmonics, more_harmonics(harmonics)); };
  for (;;) {
    const bool is_last = is_given || harmonics >= options.most_harmonics;
    const double most_left_out = is_last ? std::numeric_limits<double>::infinity() : allowed_left_out(system, options);
    const auto new_path = [&] {
      return std::make_unique<SteadyPath>(machine.condensed, machine.deflections, machine.excitation, options,
                                          harmonics);
    };
    std::unique_ptr<SteadyPath> path = new_path(), beside;
    const bool is_enough = path->follow(most_left_out, known ? &*known : nullptr, progress);
    known = path->known();
    if (!is_enough) {
      raise();
      continue;
    }
    if (path->returned()) {
      std::unique_ptr<SteadyPath> above = new_path();
      if (!above->follow_above(*path, most_left_out, progress)) {
        raise();
        continue;
      }
      if (!above->motions().points().empty()) {
        beside = std::move(path);
        path = std::move(above);
      }
    }
    Curves curves(machine, *path, std::move(beside), options, progress);
    std::optional<SteadyBranch> found = curves.all(most_left_out);
    if (!found) {
      harmonics = std::min(options.most_harmonics, curves.enough_harmonics());
      continue;
    }
    if (path->returned() && found->ended.empty())
      found->ended =
          fmt::format("the curve returns to the lower end of the band; at {} places above it no other motion was found",
                      SteadyPath::places_above);
    found->lost_means = lost_means(machine.deflections);
    found->requested_at = options.at;
    if (hold.holds && !found->results.empty()) add_linear(system, options, *found);
    return *std::move(found);
  }
}

}  // namespace trivet::nonlinear
