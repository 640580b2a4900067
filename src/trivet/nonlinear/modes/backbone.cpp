// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/modes/backbone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/laws/end_reason.h"
#include "trivet/nonlinear/laws/held_by_friction.h"
#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/nonlinear/modes/free_motion.h"
#include "trivet/numerics/periodic/branch.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::BranchPoint;

/// The machine of small motions about rest; undamped: with its elastic laws alone, sliders sticking.
model::System about_rest(const model::System& given) { return with_references(given, tangents_at_rest(given)); }

std::vector<Deflection> laws_of(const model::System& system, const assembly::Assembled& assembled, bool damped) {
  std::vector<Deflection> found = nonlinear_deflections(system, assembled, tangents_at_rest(system));
  if (damped) {
    add_rubbings(system, assembled, found);
    return found;
  }
  std::size_t next = 0;
  for (const model::Element& element : system.elements())
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      elements::ScalarLaws elastic;
      for (elements::ElasticForce law : elements::only<elements::ElasticForce>(part.laws)) {
        if (auto* stop = std::get_if<elements::GapStop>(&law)) stop->dissipation = 0;
        elastic.emplace_back(law);
      }
      for (elements::PayneForce law : elements::only<elements::PayneForce>(part.laws)) {
        law.loss = 0;
        elastic.emplace_back(law);
      }
      found[next++].law = DeviationLaw(elastic, part.at_rest, elements::small_motion(elastic, part.at_rest));
    }
  for (const model::Element& element : system.elements())
    for (model::DistancePart part : element.distance_parts) {
      std::erase_if(part.law.laws, [](const elements::ScalarLaw& law) {
        return !std::holds_alternative<elements::ElasticForce>(law);
      });
      for (elements::ScalarLaw& law : part.law.laws)
        if (auto* stop = std::get_if<elements::GapStop>(&std::get<elements::ElasticForce>(law))) stop->dissipation = 0;
      found[next].distance.emplace(part.law, part.at_rest);
      next += 3;
    }
  return found;
}

/// Deflections with friction that sticks in undamped motion; without a spring it is left out.
std::vector<std::string> with_friction(const model::System& system, const assembly::Assembled& assembled) {
  std::vector<Deflection> deflections = nonlinear_deflections(system, assembled, tangents_at_rest(system));
  add_rubbings(system, assembled, deflections);
  std::vector<std::string> names;
  for (const Deflection& one : deflections)
    if (!one.law.bristles().empty() || (one.rubbing && one.rubbing->law.is_pressed_at_rest()) ||
        std::ranges::any_of(one.law.hysteretic(),
                            [](const DeviationLaw::Hysteretic& part) { return !elements::jumps_at_turns(part.law); }))
      names.push_back(one.name);
  return names;
}

class FreeCourse {
 public:
  FreeCourse(const model::System& given, const BackboneOptions& options)
      : options_(options),
        system_(about_rest(given)),
        assembled_(assembly::assemble(system_)),
        deflections_(laws_of(system_, assembled_, options.damped)),
        holding_(assembly::assemble(with_references(given, references_of(given, hold_at_rest(given)))).matrices.K),
        motion_(assembled_, deflections_, options.damped, options.harmonics, holding_),
        observer_(system_, assembled_, PeriodicExcitation(), deflections_, options.of, options.quantity) {
    if (assembled_.frequency_dependent())
      throw foundation::NotComputable(
          "backbone: elements whose stiffness is a function of frequency; give them constant matrices or a Maxwell "
          "model");
    std::vector<ModeAtRest> modes = modes_at_rest(system_, assembled_, holding_);
    if (options.mode < 0 || options.mode >= to_index(modes.size()))
      throw foundation::NotComputable(
          fmt::format("backbone: mode {} does not exist; {} modes have a frequency above 0, at rest or in motion",
                      options.mode + 1, modes.size()));
    omega_ = modes[options.mode].angular_frequency;
    shape_ = std::move(modes[options.mode].shape);
  }

  Backbone follow(const foundation::Progress& progress) {
    Backbone found{.mode = options_.mode, .angular_frequency = omega_, .harmonics = options_.harmonics};
    if (!options_.damped) found.held = with_friction(system_, assembled_);
    for (const assembly::Channel& channel : observer_.channels()) {
      found.results.push_back(channel.name);
      found.units.push_back(channel.unit);
    }
    // Where a slow load has left a mean force in smooth loops, small motions lose it, which is a large change to them.
    for (const double share : {1e-3, 1e-2, 1e-1}) {
      const VectorXd start = starting_shape(share);
      motion_.set_mode(shape_, start.cwiseAbs().maxCoeff());
      const double first_omega = frequency_of(start);
      const numerics::Branch branch(
          [this](const VectorXd& unknowns, double omega, numerics::Equations& equations) {
            motion_.evaluate(unknowns, omega, equations);
          },
          smallest_scale(start), typical_frequency(first_omega));
      if (const std::optional<BranchPoint> now = first(branch, start, first_omega)) {
        follow(branch, *now, found, progress);
        return found;
      }
    }
    throw foundation::NotComputable(
        "backbone: no motion of small amplitude was found at 0.1, 1 and 10 % of the end; give another up_to");
  }

 private:
  /// Of a motion with this shape, by the balance of its first harmonic along itself.
  [[nodiscard]] double frequency_of(const VectorXd& start) const {
    const double probe = omega_ > 0 ? omega_ : 1;
    numerics::Equations equations;
    motion_.evaluate(start, probe, equations);
    const auto first = start.segment(motion_.place(1), motion_.coordinates());
    const double square = probe * probe +
        first.dot(equations.value.segment(motion_.place(1), motion_.coordinates())) /
            first.dot(assembled_.matrices.A * first);
    return square > 0 && std::isfinite(square) ? std::sqrt(square) : omega_;
  }

  /// By which changes of ω along the branch are measured: that of small motions, unless large ones are far faster.
  [[nodiscard]] double typical_frequency(double at_start) const {
    constexpr double faster = 10;
    const double at_end = frequency_of(starting_shape(1));
    return at_end > faster * std::max(omega_, at_start) || !(omega_ > 0) ? std::max(at_end, at_start) : omega_;
  }

  void follow(const numerics::Branch& branch, const BranchPoint& start, Backbone& found,
              const foundation::Progress& progress) const {
    found.points.push_back(observed(start, found));
    constexpr double accurate = 1e-13, first_step = 0.05;
    numerics::BranchWalk walk(branch, start, {.longest = 0.06, .shortest = 1e-8, .sharp_turns = 1e-4}, first_step, 0,
                              foundation::infinity);
    std::size_t points_before = found.points.size(), energies_before = 0;  // at the last smooth point
    while (found.points.back().share < 1) {
      if (static_cast<int>(found.points.size()) >= options_.most_points) {
        found.ended = fmt::format("stopped after {} points", options_.most_points);
        break;
      }
      std::optional<numerics::BranchWalk::Step> step = walk.next();
      const BranchPoint& now = walk.now();
      if (step && step->hops) {
        found.points.resize(points_before);
        found.at_energy.resize(energies_before);
      }
      if (!step || !(step->to.parameter > 0)) {
        found.ended = no_further(now, found.points.back().energy);
        break;
      }
      const BranchPoint& next = step->to;
      const bool ends = share(next) >= 1;
      if (ends && !step->hops)
        if (const auto end = branch.zero([&](const BranchPoint& point) { return share(point) - 1; }, now, 0,
                                         step->length, accurate)) {
          step->length = numerics::Branch::length(now, *end);
          step->to = *end;
        }
      const double energy = found.points.back().energy, next_energy = this->energy(next);
      for (const double wanted : options_.at_energy)
        if ((energy < wanted) != (next_energy < wanted))
          if (const auto there = branch.zero([&](const BranchPoint& point) { return this->energy(point) - wanted; },
                                             now, 0, step->length, accurate * wanted))
            found.at_energy.push_back(observed(*there, found));
      found.points.push_back(observed(next, found));
      constexpr double back = 0.5;  // of where it began
      if (found.points.back().deflection < back * found.points.front().deflection) {
        found.ended = fmt::format("the branch returns to rest at {:.6g} Hz", next.parameter / foundation::two_pi);
        break;
      }
      if (ends) break;
      if (progress) progress("backbone", std::clamp(found.points.back().share, 0.0, 1.0));
      walk.go(std::move(*step));
      if (!walk.is_smooth()) continue;
      points_before = found.points.size();
      energies_before = found.at_energy.size();
    }
  }

  /// Why the branch ends at a point from which no step leads further.
  [[nodiscard]] std::string no_further(const BranchPoint& point, double energy) const {
    constexpr double ahead = 1e-3;
    const Index size = point.unknowns.size();
    const VectorXd beyond = point.unknowns + ahead * point.tangent.head(size).cwiseProduct(point.scale.head(size));
    return fmt::format("no further motion beyond {:.6g} Hz and {:.4g} J: the step of the branch became too short{}",
                       point.parameter / foundation::two_pi, energy,
                       end_reason(deflections_, motion_.laws(), motion_.deflections(point.unknowns),
                                  motion_.deflections(beyond), point.parameter));
  }

  /// The mode with a small amplitude, as cosines of the first harmonic.
  /// @param small  share of the end
  [[nodiscard]] VectorXd starting_shape(double small) const {
    double factor = std::numeric_limits<double>::infinity();
    const double round_off = 1e-9 * shape_.cwiseAbs().maxCoeff();
    bool moves_any = false;
    for (const Deflection& one : deflections_) {
      const double deflection = std::abs(one.on_coordinates.dot(shape_));
      if (deflection <= round_off) continue;
      moves_any = true;
      factor = std::min(factor, small * end_of(one) / deflection);
    }
    if (std::isfinite(options_.up_to_energy))
      factor = std::min(factor,
                        omega_ > 0 ? small * std::sqrt(2 * options_.up_to_energy) / omega_  // modal mass 1
                                   : amplitude_of(small * small * options_.up_to_energy));
    if (!std::isfinite(factor) && moves_any)
      throw foundation::NotComputable(fmt::format("backbone: mode {} moves nonlinear parts in {} only; give {}",
                                                  options_.mode + 1,
                                                  std::isfinite(options_.up_to) ? "rotation" : "translation",
                                                  std::isfinite(options_.up_to) ? "up_to_angle" : "up_to"));
    if (!std::isfinite(factor))
      throw foundation::NotComputable(fmt::format(
          "backbone: mode {} does not move the nonlinear parts, so it stays linear; take others", options_.mode + 1));
    VectorXd unknowns = VectorXd::Zero(motion_.size());
    unknowns.segment(motion_.place(1), motion_.coordinates()) = factor * shape_;
    return unknowns;
  }

  /// Factor on the mode at which it has this potential energy.
  [[nodiscard]] double amplitude_of(double energy) const {
    double high = 1;
    constexpr double largest = 1e12, accurate = 1e-6;
    while (potential(high * shape_) > energy && high > 1 / largest) high /= 2;
    while (potential(high * shape_) < energy && high < largest) high *= 2;
    double low = high / 2;
    while (high - low > accurate * high) {
      const double middle = (low + high) / 2;
      (potential(middle * shape_) < energy ? low : high) = middle;
    }
    return high;
  }

  /// Coordinates that stay near zero are compared with a hundredth of the largest; ζ with 1.
  [[nodiscard]] VectorXd smallest_scale(const VectorXd& start) const {
    constexpr double share = 1e-2;
    return VectorXd::Constant(start.size(), share * start.cwiseAbs().maxCoeff());
  }

  /// From the mode about rest, along which its amplitude grows and its frequency stays.
  [[nodiscard]] std::optional<BranchPoint> first(const numerics::Branch& branch, const VectorXd& start,
                                                 double omega) const {
    BranchPoint point{start, omega, {}, {}, 0};
    if (options_.damped) {
      const MatrixXd& B = assembled_.matrices.B;
      const double mass = shape_.dot(assembled_.matrices.A * shape_);
      double loss = shape_.dot(B * shape_) / (2 * omega * mass);
      if (assembled_.matrices.lossy())
        loss += shape_.dot(assembled_.matrices.K_loss * shape_) / (2 * omega * omega * mass);
      point.unknowns(start.size() - 1) = start.cwiseAbs().maxCoeff() * loss;
    }
    const double largest = start.cwiseAbs().maxCoeff();
    point.scale = VectorXd::Constant(start.size() + 1, largest);
    point.scale(start.size()) = omega;
    point.tangent = VectorXd::Zero(start.size() + 1);
    point.tangent.head(start.size()) = start / largest;
    point.tangent.normalize();
    return branch.after(point, 0);
  }

  /// Undamped: above rest, at phase 0, where all is at rest. Damped, or where a stiffness depends on the amplitude, so
  /// that it has no potential: the largest kinetic energy over a period.
  [[nodiscard]] double energy(const BranchPoint& point) const {
    const MatrixXd motion = motion_.motion(point.unknowns);
    const bool has_potential =
        std::ranges::all_of(deflections_, [](const Deflection& one) { return one.law.of_amplitude().empty(); });
    if (!options_.damped && has_potential) {
      return potential((numerics::fourier_row(options_.harmonics, 0) * motion).transpose());
    }
    MatrixXd rates(motion.rows(), motion.cols());
    for (Index i = 0; i < motion.cols(); ++i)
      rates.col(i) = point.parameter * numerics::phase_derivative(motion.col(i));
    const Index samples = this->samples();
    double largest = 0;
    for (Index n = 0; n < samples; ++n) {
      const VectorXd v = (numerics::fourier_row(options_.harmonics, phase(n, samples)) * rates).transpose();
      largest = std::max(largest, v.dot(assembled_.matrices.A * v) / 2);
    }
    return largest;
  }

  /// Of the coordinates, above that of rest, without dampers and loops.
  [[nodiscard]] double potential(const VectorXd& q) const {
    double sum = q.dot(assembled_.matrices.K * q) / 2;
    const VectorXd deviations = motion_.across().transpose() * q;
    for (Index j = 0; j < deviations.size(); ++j) {
      const Deflection& deflection = deflections_[j];
      sum += deflection.law.energy(deviations(j));
      if (deflection.distance) sum += deflection.distance->energy(deviations.segment<3>(j));
    }
    return sum;
  }

  struct Reached {
    double deflection = 0;  ///< largest deviation of any nonlinear deflection
    double share = 0;       ///< of the requested end
  };
  [[nodiscard]] Reached reached(const BranchPoint& point) const {
    Reached found{0, energy(point) / options_.up_to_energy};
    const MatrixXd course = motion_.deflections(point.unknowns);
    const Index samples = this->samples();
    for (Index n = 0; n < samples; ++n) {
      const Eigen::RowVectorXd row = numerics::fourier_row(options_.harmonics, phase(n, samples));
      for (Index j = 0; j < course.cols(); ++j) {
        const double deviation = std::abs(row.dot(course.col(j)));
        found.deflection = std::max(found.deflection, deviation);
        found.share = std::max(found.share, deviation / end_of(deflections_[j]));
      }
    }
    return found;
  }
  [[nodiscard]] double share(const BranchPoint& point) const { return reached(point).share; }

  [[nodiscard]] BackbonePoint observed(const BranchPoint& point, Backbone& found) const {
    BackbonePoint result;
    result.angular_frequency = point.parameter;
    result.energy = energy(point);
    result.damping_ratio = motion_.damping_ratio(point.unknowns);
    const MatrixXd motion = motion_.motion(point.unknowns);
    result.coordinates.resize(motion.cols(), options_.harmonics + 1);
    result.coordinates.col(0) = motion.row(0).transpose().cast<std::complex<double>>();
    for (Index k = 1; k <= options_.harmonics; ++k)
      for (Index i = 0; i < motion.cols(); ++i) result.coordinates(i, k) = {motion(2 * k - 1, i), -motion(2 * k, i)};
    const MatrixXd course = motion_.deflections(point.unknowns);
    const Reached reached = this->reached(point);
    result.deflection = reached.deflection;
    result.share = reached.share;
    const MatrixXd forces = motion_.forces(point.unknowns, point.parameter);
    std::optional<ForceRemainder> remainder;
    if (observer_.follows_forces()) remainder.emplace(motion_.laws(), course, forces, point.parameter);
    result.results = observer_.at(result.coordinates, forces, point.parameter, 0, remainder ? &*remainder : nullptr);
    found.left_out = std::max(found.left_out, motion_.left_out(point.unknowns, point.parameter));
    return result;
  }

  /// Of a period: between them the highest harmonic turns by less than a tenth of a revolution.
  [[nodiscard]] Index samples() const { return std::max<Index>(64, 10 * options_.harmonics); }
  static double phase(Index sample, Index samples) {
    return foundation::two_pi * static_cast<double>(sample) / static_cast<double>(samples);
  }

  [[nodiscard]] double end_of(const Deflection& deflection) const {
    return deflection.is_rotation ? options_.up_to_angle : options_.up_to;
  }

  const BackboneOptions& options_;
  model::System system_;
  assembly::Assembled assembled_;
  std::vector<Deflection> deflections_;
  MatrixXd holding_;  ///< stiffness in all directions that deflect nonlinear parts
  FreeMotion motion_;
  Observer observer_;
  double omega_ = 0;
  VectorXd shape_;
};

}  // namespace

Backbone backbone(const model::System& system, const BackboneOptions& options, const foundation::Progress& progress) {
  const double ends[] = {options.up_to, options.up_to_angle, options.up_to_energy};
  if (std::none_of(std::begin(ends), std::end(ends), [](double end) { return std::isfinite(end); }) ||
      std::any_of(std::begin(ends), std::end(ends), [](double end) { return !(end > 0); }))
    throw foundation::InvalidInput("backbone: give an end above 0: a deflection or an energy");
  if (options.harmonics < 1) throw foundation::InvalidInput("backbone: at least one harmonic");
  if (options.damped) require_elastic_hold(system, "backbone");
  return FreeCourse(system, options).follow(progress);
}

}  // namespace trivet::nonlinear
