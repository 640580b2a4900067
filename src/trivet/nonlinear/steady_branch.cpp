// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/steady_branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/contact_share.h"
#include "trivet/nonlinear/periodic_stability.h"
#include "trivet/nonlinear/steady_path.h"
#include "trivet/nonlinear/winding_stability.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// The machine with references in place of its nonlinear parts, and the parts beyond them.
struct ReferenceMachine {
  ReferenceMachine(const model::System& given, const References& references,
                   const std::vector<std::string>& excitations)
      : system(with_references(given, references)),
        assembled(assembly::assemble(system)),
        deflections(nonlinear_deflections(system, assembled, references)),
        excitation(periodic_excitation(system, assembled, excitations)),
        condensed(assembled, deflections, excitation) {}
  model::System system;
  assembly::Assembled assembled;
  std::vector<Deflection> deflections;
  PeriodicExcitation excitation;
  CondensedMachine condensed;
};

/// Do the tangents at rest hold all bodies?
bool holds_at_rest(const model::System& given) {
  constexpr double singular = 1e-13;
  const assembly::Assembled assembled = assembly::assemble(with_references(given, tangents_at_rest(given)));
  return numerics::PivotedLu<double>(assembled.matrices.K).reciprocal_condition() > singular;
}

/// Tangents at rest, or what keeps the receptance of a machine finite that they do not hold or damp.
References references_of(const model::System& given, bool holds) {
  return holds && !has_slack_dampers(given) ? tangents_at_rest(given) : positive_references(given);
}

/// Results and stability of the motions on a path.
class Observed {
 public:
  /// @param all  with the path itself: the motions among which a jump lands
  Observed(const ReferenceMachine& machine, const SteadyPath& path, std::vector<const SteadyPath*> all,
           const SteadyOptions& options)
      : machine_(machine),
        path_(path),
        all_(std::move(all)),
        options_(options),
        observer_(machine.system, machine.assembled, machine.excitation, options.of, options.quantity),
        stability_(machine.assembled, machine.deflections),
        winding_(machine.condensed, machine.deflections) {
    for (std::size_t j = 0; j < machine.deflections.size(); ++j) {
      const Deflection& deflection = machine.deflections[j];
      const auto [low, high] = deflection.law.untouched();
      const bool is_ring = deflection.distance && deflection.distance->is_ring();
      if (std::isfinite(low) || std::isfinite(high) || is_ring) stops_.push_back(j);
    }
  }

  SteadyBranch branch(const foundation::Progress& progress) {
    SteadyBranch found;
    found.harmonics = path_.balance().harmonics();
    found.over = options_.over;
    found.first_harmonic = machine_.excitation.first_harmonic;
    found.of_shaft = machine_.excitation.of_shaft;
    found.excitations = machine_.excitation.names;
    found.left_out = path_.left_out();
    found.held_share = path_.held_share();
    found.ended = path_.ended();
    found.closed = path_.closed();
    const bool over_frequency = machine_.assembled.frequency_dependent();
    using Multipliers = SteadyBranch::Multipliers;
    found.multipliers_of = over_frequency    ? Multipliers::constant_machine
        : stability_.is_of_viscous_machine() ? Multipliers::viscous_machine
                                             : Multipliers::machine;
    for (const Deflection& deflection : machine_.deflections) found.deflections.push_back(deflection.name);
    for (const std::size_t stop : stops_) found.stops.push_back(machine_.deflections[stop].name);
    for (const assembly::Channel& channel : observer_.channels()) {
      found.results.push_back(channel.name);
      found.units.push_back(channel.unit);
    }
    for (const BranchPoint& point : path_.points()) {
      found.points.push_back(steady(point));
      note_sticking(point, found);
      if (progress)
        progress("stability", static_cast<double>(found.points.size()) / static_cast<double>(path_.points().size()));
    }
    const bool has_winding = !(over_frequency ? machine_.assembled.constant : machine_.assembled.matrices).lossy();
    if (has_winding && (options_.deep || over_frequency)) judge_by_winding(found, progress);
    for (const BranchPoint& point : path_.asked_for()) found.at.push_back(steady(point));
    for (const SteadyPath::Turn& turn : path_.turns())
      found.folds.push_back({steady(turn.point), turn.after, turn.upper, landing(turn.point)});
    add_changes(found);
    return found;
  }

 private:
  [[nodiscard]] SteadyPoint steady(const BranchPoint& point) const {
    SteadyPoint result;
    const HarmonicBalance& balance = path_.balance();
    const auto [omega, factor] = path_.driving(point.parameter);
    result.angular_frequency = omega / machine_.excitation.first_harmonic;
    result.load_factor = factor;
    result.deflections = point.unknowns.reshaped(balance.coefficients(), machine_.condensed.size());
    const Eigen::MatrixXd forces = balance.forces(point.unknowns, omega);
    if (!observer_.channels().empty())
      result.results = observer_.at(machine_.condensed.coordinates(forces, omega, factor), forces, omega, factor);
    result.multipliers = stability_.multipliers(balance.laws(), point.unknowns, omega);
    for (const std::size_t stop : stops_) result.contact.push_back(contact(stop, result));
    result.stable = result.unstable_multipliers() == 0;
    if (by_winding_) {
      result.unstable_by_winding = winding_.unstable_exponents(point.unknowns, omega);
      if (result.unstable_by_winding) result.stable = *result.unstable_by_winding == 0;
    }
    return result;
  }

  [[nodiscard]] double contact(std::size_t stop, const SteadyPoint& point) const {
    const auto first = to_index(stop);
    for (const MachineLaws::Distance& one : path_.balance().laws().distances())
      if (one.first == first) return contact_share(one.law, point.deflections.middleCols(first, 3));
    return contact_share(path_.balance().laws().single()[stop], point.deflections.col(first),
                         point.angular_frequency * machine_.excitation.first_harmonic);
  }

  /// The second verdict: at all points, or, of elements that depend on frequency, at some and beside each change of
  /// the first one. If it contradicts the multipliers of the nearest constant matrices, it decides.
  void judge_by_winding(SteadyBranch& found, const foundation::Progress& progress) {
    constexpr std::size_t samples = 16;
    const std::size_t count = found.points.size(), every = 1 + count / samples;
    const auto is_beside_change = [&](std::size_t i) {
      return (i > 0 && found.points[i - 1].stable != found.points[i].stable) ||
          (i + 1 < count && found.points[i + 1].stable != found.points[i].stable);
    };
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; ++i)
      if (options_.deep || i % every == 0 || is_beside_change(i)) chosen.push_back(i);
    judge(chosen, found, progress);
    if (found.multipliers_of != SteadyBranch::Multipliers::constant_machine || found.winding.differs_at.empty()) return;
    chosen.clear();
    for (std::size_t i = 0; i < count; ++i)
      if (!found.points[i].unstable_by_winding) chosen.push_back(i);
    judge(chosen, found, progress);
    found.winding.decides = by_winding_ = true;
    for (SteadyPoint& point : found.points)
      if (point.unstable_by_winding) point.stable = *point.unstable_by_winding == 0;
  }

  void judge(const std::vector<std::size_t>& chosen, SteadyBranch& found, const foundation::Progress& progress) const {
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const BranchPoint& point = path_.points()[chosen[i]];
      SteadyPoint& judged = found.points[chosen[i]];
      judged.unstable_by_winding = winding_.unstable_exponents(point.unknowns, path_.driving(point.parameter).omega);
      ++found.winding.points;
      if (!judged.unstable_by_winding) ++found.winding.undecided;
      else if (*judged.unstable_by_winding != judged.unstable_multipliers())
        found.winding.differs_at.push_back(point.parameter);
      foundation::report_progress(progress, "stability by winding number",
                                  static_cast<double>(i) / static_cast<double>(chosen.size()));
    }
  }

  /// The only stable motion that is known at the parameter of a fold, besides those that meet there.
  [[nodiscard]] std::optional<SteadyPoint> landing(const BranchPoint& fold) const {
    constexpr double same = 1e-2;  // of the motion
    std::vector<SteadyPoint> stable;
    for (const SteadyPath* path : all_)
      for (const BranchPoint& other : path->all_at(fold.parameter)) {
        if ((other.unknowns - fold.unknowns).norm() < same * fold.unknowns.norm()) continue;
        SteadyPoint point = steady(other);
        if (point.stable) stable.push_back(std::move(point));
      }
    return stable.size() == 1 ? std::optional(std::move(stable.front())) : std::nullopt;
  }

  void note_sticking(const BranchPoint& point, SteadyBranch& found) const {
    const Index C = path_.balance().coefficients();
    for (Index j = 0; j < machine_.condensed.size(); ++j) {
      const LawHarmonics& law = path_.balance().laws().single()[to_size(j)];
      const std::string& name = machine_.deflections[to_size(j)].name;
      if (law.law().hysteretic().empty() ||
          std::find(found.sticking.begin(), found.sticking.end(), name) != found.sticking.end())
        continue;
      const LawCourse course = law.course(point.unknowns.segment(j * C, C), path_.driving(point.parameter).omega);
      if (std::any_of(course.loops().begin(), course.loops().end(),
                      [](const HystereticLoop& loop) { return loop.sticks(); }))
        found.sticking.push_back(name);
    }
  }

  void add_changes(SteadyBranch& found) const {
    for (std::size_t i = 0; i + 1 < found.points.size(); ++i) {
      if (found.points[i].stable == found.points[i + 1].stable) continue;
      const bool at_fold =
          std::any_of(found.folds.begin(), found.folds.end(), [i](const Fold& fold) { return fold.after == i; });
      if (at_fold) continue;
      found.changes.push_back(change_after(i));
    }
  }

  /// Where the largest multiplier passes the unit circle between a point and the next one.
  [[nodiscard]] StabilityChange change_after(std::size_t point) const {
    constexpr double accurate = 1e-10, of_multipliers = 1e-11;
    const auto excess = [&](const BranchPoint& there) {
      return stability_
                 .multipliers(path_.balance().laws(), there.unknowns, path_.driving(there.parameter).omega,
                              of_multipliers)
                 .cwiseAbs()
                 .maxCoeff() -
          1;
    };
    const auto by_winding = [&](const BranchPoint& there) {
      const std::optional<int> unstable =
          winding_.unstable_exponents(there.unknowns, path_.driving(there.parameter).omega);
      return unstable && *unstable > 0 ? 1.0 : -1.0;
    };
    std::optional<BranchPoint> middle =
        by_winding_ ? path_.zero_after(point, by_winding, accurate) : path_.zero_after(point, excess, accurate);
    if (!middle) middle = path_.points()[point + 1];  // not located; the next point is the nearest known
    StabilityChange change{steady(*middle), point};
    Index critical = 0;
    change.point.multipliers.cwiseAbs().maxCoeff(&critical);
    const std::complex<double> multiplier = change.point.multipliers(critical);
    constexpr double real_axis = 1e-6;
    change.kind = std::abs(multiplier.imag()) > real_axis ? StabilityChange::Kind::quasi_periodic
        : multiplier.real() < 0                           ? StabilityChange::Kind::period_doubling
                                                          : StabilityChange::Kind::branch_point;
    return change;
  }

  const ReferenceMachine& machine_;
  const SteadyPath& path_;
  std::vector<const SteadyPath*> all_;
  const SteadyOptions& options_;
  std::vector<std::size_t> stops_;  ///< deflections that have any
  Observer observer_;
  PeriodicStability stability_;
  WindingStability winding_;
  bool by_winding_ = false;  ///< the winding number decides, because the multipliers of constant matrices differ
};

/// Amplitudes of the machine that is linear about rest.
void add_linear(const model::System& given, const SteadyOptions& options, SteadyBranch& found) {
  constexpr int count = 400;
  const ReferenceMachine about_rest(given, tangents_at_rest(given), options.excitations);
  const Observer observer(about_rest.system, about_rest.assembled, about_rest.excitation, options.of, options.quantity);
  const PeriodicExcitation& excitation = about_rest.excitation;
  const Eigen::MatrixXd none =
      Eigen::MatrixXd::Zero(numerics::coefficient_count(excitation.highest()), about_rest.condensed.size());
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

/// Gas hardens without limit as it is compressed: stability depends on a small share of the motion.
constexpr double share_for_gas = 0.1;
bool has_gas(const model::System& system) {
  const auto is_gas = [](const elements::ScalarLaw& law) {
    const auto* elastic = std::get_if<elements::ElasticForce>(&law);
    return elastic && std::holds_alternative<elements::GasForce>(*elastic);
  };
  const auto any = [&](const auto& laws) { return std::any_of(laws.begin(), laws.end(), is_gas); };
  return std::any_of(system.elements().begin(), system.elements().end(), [&](const model::Element& element) {
    return std::any_of(element.nonlinear_parts.begin(), element.nonlinear_parts.end(),
                       [&](const auto& part) { return any(part.laws); }) ||
        std::any_of(element.distance_parts.begin(), element.distance_parts.end(),
                    [&](const auto& part) { return any(part.law.laws); });
  });
}

/// 5, 7, 10, 14 …: a number that is too small is found out early.
Index more_harmonics(Index harmonics) { return 7 * harmonics / 5; }

/// Deflections whose smooth loops bear a force at rest, which they lose in motion.
std::vector<std::string> lost_means(const std::vector<Deflection>& deflections) {
  std::vector<std::string> names;
  for (const Deflection& deflection : deflections)
    if (std::any_of(deflection.law.hysteretic().begin(), deflection.law.hysteretic().end(), [](const auto& part) {
          return part.at_state != 0 && !std::holds_alternative<elements::Slider>(part.law);
        }))
      names.push_back(deflection.name);
  return names;
}

void check(const SteadyOptions& options) {
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput(
        fmt::format("steady: the band [{}, {}] must rise from above 0", options.from, options.to));
  if (options.over == Parameter::load_factor && !(options.angular_frequency > 0))
    throw foundation::InvalidInput("steady: over the load factor, the frequency must be above 0");
  if (options.harmonics < 0) throw foundation::InvalidInput("steady: at least one harmonic");
}

/// What the excitation and the data of elements allow.
void check(const SteadyOptions& options, const ReferenceMachine& machine) {
  const Index highest = machine.excitation.highest();
  if (highest > most_steady_harmonics)
    throw foundation::NotComputable(
        fmt::format("steady: the highest order is harmonic {} of the motion, and at most {} are computed; name "
                    "excitations whose orders have a larger common divisor",
                    highest, most_steady_harmonics));
  if (options.harmonics > 0 && options.harmonics < highest)
    throw foundation::InvalidInput(fmt::format(
        "steady: {} harmonics, and the highest order is harmonic {} of the motion, of which order {:.6g} is the first; "
        "take at least {}",
        options.harmonics, highest, machine.excitation.first_harmonic, highest));
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

std::vector<const SteadyPoint*> stable_points(const SteadyBranch& branch) {
  std::vector<const SteadyPoint*> stable;
  for (const SteadyPoint& point : branch.points)
    if (point.stable) stable.push_back(&point);
  for (const Fold& fold : branch.folds) {
    const std::size_t next = std::min(fold.after + 1, branch.points.size() - 1);
    if (branch.points[fold.after].stable || branch.points[next].stable) stable.push_back(&fold.point);
  }
  for (const SteadyBranch& detached : branch.detached) {
    const std::vector<const SteadyPoint*> more = stable_points(detached);
    stable.insert(stable.end(), more.begin(), more.end());
  }
  return stable;
}

namespace {

using Stretch = std::pair<double, double>;

void add_stable_stretches(const SteadyBranch& branch, std::vector<Stretch>& stretches) {
  const auto add = [&](const SteadyPoint& a, const SteadyPoint& b) {
    stretches.emplace_back(std::minmax({branch.parameter(a), branch.parameter(b)}));
  };
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const SteadyPoint &here = branch.points[i], &next = branch.points[i + 1];
    const auto in_step = [i](const auto& one) { return one.after == i; };
    const auto fold = std::find_if(branch.folds.begin(), branch.folds.end(), in_step);
    const auto change = std::find_if(branch.changes.begin(), branch.changes.end(), in_step);
    const SteadyPoint* middle = fold != branch.folds.end() ? &fold->point
        : change != branch.changes.end()                   ? &change->point
                                                           : nullptr;
    if (!middle && here.stable && next.stable) add(here, next);
    if (middle && here.stable) add(here, *middle);
    if (middle && next.stable) add(*middle, next);
  }
}

}  // namespace

std::vector<std::pair<double, double>> without_stable_motion(const SteadyBranch& branch) {
  std::vector<Stretch> stable, without;
  add_stable_stretches(branch, stable);
  for (const SteadyBranch& detached : branch.detached) add_stable_stretches(detached, stable);
  std::sort(stable.begin(), stable.end());
  const auto [from, to] =
      std::minmax({branch.parameter(branch.points.front()), branch.parameter(branch.points.back())});
  double covered = from;
  constexpr double round_off = 1e-9;
  for (const auto& [low, high] : stable) {
    if (low > covered * (1 + round_off)) without.emplace_back(covered, std::min(low, to));
    covered = std::max(covered, high);
    if (covered >= to) break;
  }
  if (covered < to * (1 - round_off)) without.emplace_back(covered, to);
  return without;
}

SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                           const foundation::Progress& progress) {
  check(options);
  const bool holds = holds_at_rest(system);
  const ReferenceMachine machine(system, references_of(system, holds), options.excitations);
  check(options, machine);
  const Index fewest = std::max<Index>(5, machine.excitation.highest());
  const bool is_given = options.harmonics > 0;
  for (Index harmonics = is_given ? options.harmonics : fewest;;
       harmonics = std::min(most_steady_harmonics, more_harmonics(harmonics))) {
    const bool is_last = is_given || harmonics == most_steady_harmonics;
    SteadyPath path(machine.condensed, machine.deflections, machine.excitation, options, harmonics);
    const double most_left_out = options.tolerance * (has_gas(system) ? share_for_gas : 1);
    if (!path.follow(is_last ? std::numeric_limits<double>::infinity() : most_left_out, progress)) continue;
    DetachedPaths others;
    if (options.detached)
      others = detached_paths(
          path, machine.deflections, options,
          [&] {
            return std::make_unique<SteadyPath>(machine.condensed, machine.deflections, machine.excitation, options,
                                                harmonics);
          },
          progress);
    std::vector<const SteadyPath*> all = {&path};
    for (const auto& other : others.paths) all.push_back(other.get());
    SteadyBranch found = Observed(machine, path, all, options).branch(progress);
    if (options.detached) found.search = others.search;
    for (const auto& other : others.paths)
      found.detached.push_back(Observed(machine, *other, all, options).branch(progress));
    found.lost_means = lost_means(machine.deflections);
    if (holds && !found.results.empty()) add_linear(system, options, found);
    return found;
  }
}

}  // namespace trivet::nonlinear
