// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/steady_branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/periodic_stability.h"
#include "trivet/nonlinear/steady_path.h"
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
        loading(assembly::harmonic_loading(system, assembled, excitations)),
        condensed(assembled, deflections, loading) {}
  model::System system;
  assembly::Assembled assembled;
  std::vector<Deflection> deflections;
  assembly::Loading loading;
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
  Observed(const ReferenceMachine& machine, const SteadyPath& path, const SteadyOptions& options)
      : machine_(machine),
        path_(path),
        options_(options),
        observer_(machine.system, machine.assembled, machine.loading.motion, options.of, options.quantity),
        stability_(machine.assembled, machine.deflections) {}

  SteadyBranch branch(const foundation::Progress& progress) const {
    SteadyBranch found;
    found.harmonics = path_.balance().harmonics();
    found.over = options_.over;
    found.left_out = path_.left_out();
    found.ended = path_.ended();
    found.stability_of_viscous_machine = stability_.is_of_viscous_machine();
    for (const Deflection& deflection : machine_.deflections) found.deflections.push_back(deflection.name);
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
    result.angular_frequency = omega;
    result.load_factor = factor;
    result.deflections = point.unknowns.reshaped(balance.coefficients(), machine_.condensed.size());
    const Eigen::MatrixXd forces = balance.forces(point.unknowns, omega);
    if (!observer_.channels().empty())
      result.results = observer_.at(machine_.condensed.coordinates(forces, omega, factor), forces, omega, factor);
    result.multipliers = stability_.multipliers(balance.laws(), point.unknowns, omega);
    constexpr double round_off = 1e-6;  // an undamped machine has multipliers of magnitude 1, as exact as the splitting
    result.stable = (result.multipliers.cwiseAbs().array() < 1 + round_off).all();
    return result;
  }

  /// The only stable motion at the parameter of a fold, besides those that meet there.
  [[nodiscard]] std::optional<SteadyPoint> landing(const BranchPoint& fold) const {
    constexpr double same = 1e-2;  // of the motion
    std::vector<SteadyPoint> stable;
    for (const BranchPoint& other : path_.all_at(fold.parameter)) {
      if ((other.unknowns - fold.unknowns).norm() < same * fold.unknowns.norm()) continue;
      SteadyPoint point = steady(other);
      if (point.stable) stable.push_back(std::move(point));
    }
    return stable.size() == 1 ? std::optional(std::move(stable.front())) : std::nullopt;
  }

  void note_sticking(const BranchPoint& point, SteadyBranch& found) const {
    const Index C = path_.balance().coefficients();
    for (Index j = 0; j < machine_.condensed.size(); ++j) {
      const LawHarmonics& law = path_.balance().laws()[to_size(j)];
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
    constexpr double accurate = 1e-10;
    const auto excess = [&](const BranchPoint& there) {
      return stability_.multipliers(path_.balance().laws(), there.unknowns, path_.driving(there.parameter).omega)
                 .cwiseAbs()
                 .maxCoeff() -
          1;
    };
    std::optional<BranchPoint> middle = path_.zero_after(point, excess, accurate);
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
  const SteadyOptions& options_;
  Observer observer_;
  PeriodicStability stability_;
};

/// Amplitudes of the machine that is linear about rest.
void add_linear(const model::System& given, const SteadyOptions& options, SteadyBranch& found) {
  constexpr int count = 400;
  const ReferenceMachine about_rest(given, tangents_at_rest(given), options.excitations);
  const Observer observer(about_rest.system, about_rest.assembled, about_rest.loading.motion, options.of,
                          options.quantity);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(numerics::coefficient_count(1), about_rest.condensed.size());
  found.linear.resize(count, to_index(found.results.size()));
  for (int i = 0; i < count; ++i) {
    const double parameter = options.from * std::pow(options.to / options.from, i / (count - 1.0));
    found.linear_at.push_back(parameter);
    const bool over_frequency = options.over == Parameter::frequency;
    const double omega = over_frequency ? parameter : options.angular_frequency,
                 factor = over_frequency ? 1 : parameter;
    const std::vector<ObservedMotion> motions =
        observer.at(about_rest.condensed.coordinates(none, omega, factor), none, omega, factor);
    for (std::size_t c = 0; c < motions.size(); ++c) found.linear(i, to_index(c)) = std::abs(motions[c].harmonics(0));
  }
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

}  // namespace

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
  const bool holds = holds_at_rest(system);
  const ReferenceMachine machine(system, references_of(system, holds), options.excitations);
  constexpr Index first_harmonics = 5;
  const bool is_given = options.harmonics > 0;
  for (Index harmonics = is_given ? options.harmonics : first_harmonics;;
       harmonics = std::min(most_steady_harmonics, more_harmonics(harmonics))) {
    const bool is_last = is_given || harmonics == most_steady_harmonics;
    SteadyPath path(machine.condensed, machine.deflections, options, harmonics);
    if (!path.follow(is_last ? std::numeric_limits<double>::infinity() : options.tolerance, progress)) continue;
    SteadyBranch found = Observed(machine, path, options).branch(progress);
    found.lost_means = lost_means(machine.deflections);
    if (holds && !found.results.empty()) add_linear(system, options, found);
    return found;
  }
}

}  // namespace trivet::nonlinear
