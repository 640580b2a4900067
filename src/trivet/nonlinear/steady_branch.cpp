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

/// Lengths on the branch, in shares of the deflection and of the band.
constexpr double first_step = 0.02, longest_step = 0.1, shortest_step = 1e-9;
/// A step shorter than this hides no pair of folds worth finding.
constexpr double hidden_folds = 1e-4;
/// Directions of neighbouring points differ by less than about 15°.
constexpr double least_cosine = 0.966;

/// A linear machine that holds all its bodies, and what its stiffnesses stand for.
struct ReferenceMachine {
  explicit ReferenceMachine(const model::System& given)
      : references(tangents_at_rest(given)),
        system(with_references(given, references)),
        assembled(assembly::assemble(system)) {
    constexpr double singular = 1e-13;
    if (numerics::PivotedLu<double>(assembled.matrices.K).reciprocal_condition() > singular) return;
    is_about_rest = false;
    references = positive_references(given);
    system = with_references(given, references);
    assembled = assembly::assemble(system);
  }
  References references;
  model::System system;
  assembly::Assembled assembled;
  bool is_about_rest = true;  ///< its stiffnesses are the tangents at rest
};

class Course {
 public:
  Course(const model::System& system, const SteadyOptions& options)
      : options_(options),
        reference_(system),
        assembled_(reference_.assembled),
        deflections_(nonlinear_deflections(reference_.system, assembled_, reference_.references)),
        loading_(assembly::harmonic_loading(reference_.system, assembled_, options.excitations)),
        machine_(assembled_, deflections_, loading_),
        observer_(reference_.system, assembled_, machine_, loading_, options.of, options.quantity),
        balance_(machine_, deflections_, options.harmonics),
        stability_(assembled_, deflections_),
        branch_([this](const VectorXd& unknowns, double omega,
                       numerics::Equations& equations) { balance_.evaluate(unknowns, omega, equations); },
                smallest_scale(), options.to - options.from) {}

  SteadyBranch follow(const foundation::Progress& progress) {
    SteadyBranch found;
    found.harmonics = balance_.harmonics();
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
      std::optional<BranchPoint> next = branch_.after(now, step);
      const bool good = next && next->parameter > 0 && turn(now, *next) > least_cosine &&
          (step < hidden_folds || !numerics::Branch::hides_folds(now, *next, step));
      if (!good) {
        step /= 2;
        if (step >= shortest_step) continue;
        found.ended = fmt::format("no further motion beyond {:.10g} rad/s: the step of the branch fell below {:.0e}",
                                  now.parameter, shortest_step);
        break;
      }
      const std::size_t first_new = pieces.size();
      if (next->parameter_direction() * now.parameter_direction() < 0) {
        if (const std::optional<BranchPoint> fold = branch_.fold(now, step)) {
          found.folds.push_back(
              {steady(*fold, found), found.points.size() - 1, now.parameter_direction() > 0, std::nullopt});
          const double place = numerics::Branch::length(now, *fold);
          pieces.push_back({now, 0, place, now.parameter, fold->parameter});
          pieces.push_back({now, place, step, fold->parameter, next->parameter});
        }
      } else {
        pieces.push_back({now, 0, step, now.parameter, next->parameter});
      }
      for (const double omega : options_.at)
        for (std::size_t i = first_new; i < pieces.size(); ++i)
          if (const std::optional<BranchPoint> there = at(omega, pieces[i])) found.at.push_back(steady(*there, found));
      if (next->parameter > options_.to && !pieces.empty())
        if (std::optional<BranchPoint> end = at(options_.to, pieces.back())) next = std::move(end);
      now = *next;
      found.points.push_back(steady(now, found));
      if (now.parameter < options_.from) {
        found.ended = fmt::format("left the band downwards at {:.10g} rad/s", now.parameter);
        break;
      }
      if (now.iterations <= 4) step = std::min(longest_step, 1.4 * step);
      if (progress) progress("steady motion", std::clamp((now.parameter - options_.from) / width(), 0.0, 1.0));
    }
    if (!options_.with_results) return found;
    for (Fold& fold : found.folds) fold.lands = landing(fold, pieces, found);
    add_linear(found);
    return found;
  }

 private:
  [[nodiscard]] double width() const { return options_.to - options_.from; }
  static int to_size_of(const SteadyBranch& found) { return static_cast<int>(found.points.size()); }

  /// Coefficients that stay near zero are compared with a thousandth of the linear motion.
  [[nodiscard]] VectorXd smallest_scale() const {
    constexpr double share = 1e-3;
    const VectorXd motion = balance_.linear_motion(options_.from);
    const double largest = motion.size() > 0 ? motion.cwiseAbs().maxCoeff() : 0;
    if (!(largest > 0)) throw foundation::NotComputable("steady: no excitation moves a nonlinear part");
    return VectorXd::Constant(motion.size(), share * largest);
  }

  [[nodiscard]] BranchPoint first() const {
    const std::optional<BranchPoint> point = branch_.start(balance_.linear_motion(options_.from), options_.from);
    if (!point)
      throw foundation::NotComputable(
          fmt::format("steady: no motion was found at the lower end of the band, {:.6g} rad/s; begin at another "
                      "frequency: lower, or above the motions that were sought",
                      options_.from));
    return *point;
  }

  static double turn(const BranchPoint& from, const BranchPoint& to) {
    return from.tangent.dot(to.tangent.cwiseProduct(to.scale).cwiseQuotient(from.scale).normalized());
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

  void add_linear(SteadyBranch& found) const {
    if (!reference_.is_about_rest) return;
    constexpr int count = 400;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(numerics::coefficient_count(1), machine_.size());
    found.linear.resize(count, to_index(found.results.size()));
    for (int i = 0; i < count; ++i) {
      found.linear_at.push_back(options_.from * std::pow(options_.to / options_.from, i / (count - 1.0)));
      const std::vector<ObservedMotion> motions = observer_.at(none, found.linear_at.back());
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
      const std::optional<BranchPoint> other = at(fold.point.angular_frequency, piece);
      if (!other || (other->unknowns - at_fold).norm() < same * at_fold.norm()) continue;
      SteadyPoint point = steady(*other, found);
      if (point.stable) stable.push_back(std::move(point));
    }
    return stable.size() == 1 ? std::optional(std::move(stable.front())) : std::nullopt;
  }

  SteadyPoint steady(const BranchPoint& point, SteadyBranch& found) const {
    SteadyPoint result;
    result.angular_frequency = point.parameter;
    result.deflections = point.unknowns.reshaped(balance_.coefficients(), machine_.size());
    found.left_out = std::max(found.left_out, balance_.left_out(point.unknowns, point.parameter));
    if (!options_.with_results) return result;
    result.results = observer_.at(balance_.forces(point.unknowns), point.parameter);
    result.multipliers = stability_.multipliers(balance_.laws(), point.unknowns, point.parameter);
    constexpr double round_off = 1e-8;  // an undamped machine has multipliers of magnitude 1
    result.stable = (result.multipliers.cwiseAbs().array() < 1 + round_off).all();
    return result;
  }

  const SteadyOptions& options_;
  ReferenceMachine reference_;
  const assembly::Assembled& assembled_;
  std::vector<Deflection> deflections_;
  assembly::Loading loading_;
  CondensedMachine machine_;
  Observer observer_;
  HarmonicBalance balance_;
  PeriodicStability stability_;
  numerics::Branch branch_;
};

}  // namespace

SteadyBranch steady_branch(const model::System& system, const SteadyOptions& options,
                           const foundation::Progress& progress) {
  if (!(options.from > 0 && options.to > options.from && std::isfinite(options.to)))
    throw foundation::InvalidInput(
        fmt::format("steady: the band [{}, {}] rad/s must rise from above 0", options.from, options.to));
  if (options.harmonics < 1) throw foundation::InvalidInput("steady: at least one harmonic");
  return Course(system, options).follow(progress);
}

}  // namespace trivet::nonlinear
