// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/steady_branch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/harmonic_balance.h"
#include "trivet/nonlinear/periodic_stability.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// Length on the branch, in shares of the deflection and of the band.
constexpr double first_step = 0.02;
constexpr numerics::StepControl control{.sharp_turns = 1e-4};  // a slider begins to slip in both senses

/// The machine with references in place of its nonlinear parts, and the parts beyond them.
struct ReferenceMachine {
  ReferenceMachine(const model::System& given, const References& references,
                   const std::vector<std::string>& excitations)
      : system(with_references(given, references)),
        assembled(assembly::assemble(system)),
        deflections(nonlinear_deflections(system, assembled, references)),
        loading(assembly::harmonic_loading(system, assembled, excitations)) {}
  model::System system;
  assembly::Assembled assembled;
  std::vector<Deflection> deflections;
  assembly::Loading loading;
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

class Course {
 public:
  Course(const model::System& system, const SteadyOptions& options)
      : options_(options),
        given_(system),
        holds_at_rest_(holds_at_rest(system)),
        reference_(system, references_of(system, holds_at_rest_), options.excitations),
        deflections_(reference_.deflections),
        machine_(reference_.assembled, deflections_, reference_.loading),
        observer_(reference_.system, reference_.assembled, reference_.loading.motion, options.of, options.quantity),
        balance_(machine_, deflections_, options.harmonics),
        stability_(reference_.assembled, deflections_),
        branch_(
            [this](const VectorXd& unknowns, double parameter, numerics::Equations& equations) {
              balance_.evaluate(unknowns, driving(parameter), options_.over, equations);
            },
            smallest_scale(), options.to - options.from) {}

  SteadyBranch follow(const foundation::Progress& progress) {
    SteadyBranch found;
    found.harmonics = balance_.harmonics();
    found.over = options_.over;
    found.stability_of_viscous_machine = stability_.is_of_viscous_machine();
    for (const Deflection& deflection : deflections_) found.deflections.push_back(deflection.name);
    for (const assembly::Channel& channel : observer_.channels()) {
      found.results.push_back(channel.name);
      found.units.push_back(channel.unit);
    }
    BranchPoint now = first();
    std::vector<Piece> pieces;
    found.points.push_back(steady(now, found));
    double step = first_step;
    while (now.parameter < options_.to) {
      if (to_size_of(found) >= options_.most_points) {
        found.ended = fmt::format("stopped after {} points", options_.most_points);
        break;
      }
      std::optional<numerics::Branch::Advance> advance = branch_.advance(now, step, control);
      if (!advance || !(advance->to.parameter > 0)) {
        found.ended =
            fmt::format("no further motion beyond {}: the step of the branch became too short", place(now.parameter));
        break;
      }
      BranchPoint next = std::move(advance->to);
      const double length = advance->length;
      const std::size_t first_new = pieces.size();
      bool folded = false;
      if (next.parameter_direction() * now.parameter_direction() < 0) {
        if (const std::optional<BranchPoint> fold = branch_.fold(now, length)) {
          folded = true;
          found.folds.push_back(
              {steady(*fold, found), found.points.size() - 1, now.parameter_direction() > 0, std::nullopt});
          const double to_fold = numerics::Branch::length(now, *fold);
          pieces.push_back({now, 0, to_fold, now.parameter, fold->parameter});
          pieces.push_back({now, to_fold, length, fold->parameter, next.parameter});
        }
      } else {
        pieces.push_back({now, 0, length, now.parameter, next.parameter});
      }
      for (const double wanted : options_.at)
        for (std::size_t i = first_new; i < pieces.size(); ++i)
          if (const std::optional<BranchPoint> there = at(wanted, pieces[i])) found.at.push_back(steady(*there, found));
      if (next.parameter > options_.to && !pieces.empty())
        if (std::optional<BranchPoint> end = at(options_.to, pieces.back())) next = std::move(*end);
      if (found.ended = leaves_curve(next); !found.ended.empty()) break;
      SteadyPoint reached = steady(next, found);
      if (options_.with_results && !folded && reached.stable != found.points.back().stable)
        add_change(now, length, found);
      now = std::move(next);
      found.points.push_back(std::move(reached));
      if (now.parameter < options_.from) {
        found.ended = "left the band downwards at " + place(now.parameter);
        break;
      }
      if (progress) progress("steady motion", std::clamp((now.parameter - options_.from) / width(), 0.0, 1.0));
    }
    if (!options_.with_results) return found;
    for (Fold& fold : found.folds) fold.lands = landing(fold, pieces, found);
    add_linear(found);
    return found;
  }

 private:
  [[nodiscard]] double width() const { return options_.to - options_.from; }
  [[nodiscard]] Driving driving(double parameter) const {
    if (options_.over == Parameter::frequency) return {parameter, 1};
    return {options_.angular_frequency, parameter};
  }
  [[nodiscard]] std::string place(double parameter) const {
    return options_.over == Parameter::frequency ? fmt::format("{:.10g} rad/s", parameter)
                                                 : fmt::format("{:.10g} times the load", parameter);
  }
  static int to_size_of(const SteadyBranch& found) { return static_cast<int>(found.points.size()); }

  /// Coefficients that stay near zero are compared with a thousandth of the linear motion.
  [[nodiscard]] VectorXd smallest_scale() const {
    constexpr double share = 1e-3;
    const VectorXd motion = balance_.linear_motion(driving(options_.from));
    const double largest = motion.size() > 0 ? motion.cwiseAbs().maxCoeff() : 0;
    if (!(largest > 0)) throw foundation::NotComputable("steady: no excitation moves a nonlinear part");
    return VectorXd::Constant(motion.size(), share * largest);
  }

  [[nodiscard]] BranchPoint first() const {
    const std::optional<BranchPoint> point =
        branch_.start(balance_.linear_motion(driving(options_.from)), options_.from);
    if (!point)
      throw foundation::NotComputable(
          fmt::format("steady: no motion was found at the lower end of the band, {}; begin elsewhere: lower, or above "
                      "the motions that were sought",
                      place(options_.from)));
    return *point;
  }

  /// A part of the branch in which the frequency rises or falls: lengths from a point, and their frequencies.
  struct Piece {
    BranchPoint from;
    double begin, end;
    double parameter_begin, parameter_end;
  };

  /// The motion of a piece at a frequency. Empty if the piece does not pass it.
  [[nodiscard]] std::optional<BranchPoint> at(double omega, const Piece& piece) const {
    if ((piece.parameter_begin < omega) == (piece.parameter_end < omega)) return std::nullopt;
    return branch_.at(omega, piece.from, piece.begin, piece.end);
  }

  /// Of a motion that leaves the points of a curve which must not be extended.
  [[nodiscard]] std::string leaves_curve(const BranchPoint& point) const {
    const Index C = balance_.coefficients();
    for (Index j = 0; j < machine_.size(); ++j) {
      const auto [low, high] = deflections_[to_size(j)].law.range();
      if (!std::isfinite(low)) continue;
      const VectorXd motion = point.unknowns.segment(j * C, C);
      const Index samples = 4 * C;
      for (Index n = 0; n < samples; ++n) {
        const double phase = foundation::two_pi * static_cast<double>(n) / static_cast<double>(samples);
        const double deviation = numerics::motion_at(balance_.harmonics(), phase, motion);
        if (deviation >= low && deviation <= high) continue;
        return fmt::format("{} leaves its curve at {}: {:.6g} from rest, known from {:.6g} to {:.6g}",
                           deflections_[to_size(j)].name, place(point.parameter), deviation, low, high);
      }
    }
    return "";
  }

  void note_sticking(const BranchPoint& point, SteadyBranch& found) const {
    const Index C = balance_.coefficients();
    for (Index j = 0; j < machine_.size(); ++j) {
      const LawHarmonics& law = balance_.laws()[to_size(j)];
      const std::string& name = deflections_[to_size(j)].name;
      if (law.law().hysteretic().empty() ||
          std::find(found.sticking.begin(), found.sticking.end(), name) != found.sticking.end())
        continue;
      const LawCourse course = law.course(point.unknowns.segment(j * C, C), driving(point.parameter).omega);
      if (std::any_of(course.loops().begin(), course.loops().end(),
                      [](const HystereticLoop& loop) { return loop.sticks(); }))
        found.sticking.push_back(name);
    }
  }

  /// Where the largest multiplier passes the unit circle between a point and the one at `length` from it.
  void add_change(const BranchPoint& from, double length, SteadyBranch& found) const {
    constexpr int most = 40;
    constexpr double accurate = 1e-10;
    const auto excess = [&](const BranchPoint& point) {
      return stability_.multipliers(balance_.laws(), point.unknowns, driving(point.parameter).omega)
                 .cwiseAbs()
                 .maxCoeff() -
          1;
    };
    double low = 0, high = length, at_low = excess(from);
    std::optional<BranchPoint> middle = branch_.after(from, length);
    double at_high = middle ? excess(*middle) : 0;
    for (int i = 0; middle && i < most && std::abs(high - low) > accurate * length && std::abs(at_high) > accurate;
         ++i) {  // regula falsi (Illinois)
      const double next = (low * at_high - high * at_low) / (at_high - at_low);
      middle = branch_.after(from, next);
      if (!middle) return;
      const double value = excess(*middle);
      if (value * at_high > 0) {
        at_low /= 2;
      } else {
        low = high;
        at_low = at_high;
      }
      high = next;
      at_high = value;
    }
    if (!middle) return;
    StabilityChange change{steady(*middle, found), found.points.size() - 1};
    Index critical = 0;
    change.point.multipliers.cwiseAbs().maxCoeff(&critical);
    const std::complex<double> multiplier = change.point.multipliers(critical);
    constexpr double real_axis = 1e-6;
    change.kind = std::abs(multiplier.imag()) > real_axis ? StabilityChange::Kind::quasi_periodic
        : multiplier.real() < 0                           ? StabilityChange::Kind::period_doubling
                                                          : StabilityChange::Kind::branch_point;
    found.changes.push_back(std::move(change));
  }

  void add_linear(SteadyBranch& found) const {
    if (!holds_at_rest_) return;
    constexpr int count = 400;
    const ReferenceMachine about_rest(given_, tangents_at_rest(given_), options_.excitations);
    const CondensedMachine machine(about_rest.assembled, about_rest.deflections, about_rest.loading);
    const Observer observer(about_rest.system, about_rest.assembled, about_rest.loading.motion, options_.of,
                            options_.quantity);
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(numerics::coefficient_count(1), machine.size());
    found.linear.resize(count, to_index(found.results.size()));
    for (int i = 0; i < count; ++i) {
      found.linear_at.push_back(options_.from * std::pow(options_.to / options_.from, i / (count - 1.0)));
      const auto [omega, factor] = driving(found.linear_at.back());
      const std::vector<ObservedMotion> motions =
          observer.at(machine.coordinates(none, omega, factor), none, omega, factor);
      for (std::size_t c = 0; c < motions.size(); ++c) found.linear(i, to_index(c)) = std::abs(motions[c].harmonics(0));
    }
  }

  /// The only stable motion at the frequency of a fold, besides those that meet there.
  [[nodiscard]] std::optional<SteadyPoint> landing(const Fold& fold, const std::vector<Piece>& pieces,
                                                   SteadyBranch& found) const {
    constexpr double same = 1e-2;  // of the motion
    const VectorXd at_fold = fold.point.deflections.reshaped();
    std::vector<SteadyPoint> stable;
    for (const Piece& piece : pieces) {
      const std::optional<BranchPoint> other = at(found.parameter(fold.point), piece);
      if (!other || (other->unknowns - at_fold).norm() < same * at_fold.norm()) continue;
      SteadyPoint point = steady(*other, found);
      if (point.stable) stable.push_back(std::move(point));
    }
    return stable.size() == 1 ? std::optional(std::move(stable.front())) : std::nullopt;
  }

  SteadyPoint steady(const BranchPoint& point, SteadyBranch& found) const {
    SteadyPoint result;
    const auto [omega, factor] = driving(point.parameter);
    result.angular_frequency = omega;
    result.load_factor = factor;
    result.deflections = point.unknowns.reshaped(balance_.coefficients(), machine_.size());
    found.left_out = std::max(found.left_out, balance_.left_out(point.unknowns, omega));
    if (!options_.with_results) return result;
    note_sticking(point, found);
    const Eigen::MatrixXd forces = balance_.forces(point.unknowns, omega);
    result.results = observer_.at(machine_.coordinates(forces, omega, factor), forces, omega, factor);
    result.multipliers = stability_.multipliers(balance_.laws(), point.unknowns, omega);
    constexpr double round_off = 1e-8;  // an undamped machine has multipliers of magnitude 1
    result.stable = (result.multipliers.cwiseAbs().array() < 1 + round_off).all();
    return result;
  }

  const SteadyOptions& options_;
  const model::System& given_;
  bool holds_at_rest_;
  ReferenceMachine reference_;
  const std::vector<Deflection>& deflections_;
  CondensedMachine machine_;
  Observer observer_;
  HarmonicBalance balance_;
  PeriodicStability stability_;
  numerics::Branch branch_;
};

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
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput(
        fmt::format("steady: the band [{}, {}] must rise from above 0", options.from, options.to));
  if (options.over == Parameter::load_factor && !(options.angular_frequency > 0))
    throw foundation::InvalidInput("steady: over the load factor, the frequency must be above 0");
  if (options.harmonics < 1) throw foundation::InvalidInput("steady: at least one harmonic");
  return Course(system, options).follow(progress);
}

}  // namespace trivet::nonlinear
