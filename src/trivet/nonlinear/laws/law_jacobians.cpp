// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/periodic_laws.h"

#include <cassert>
#include <cmath>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// ẏ = source − decay y over a step h.
struct Fading {
  Fading(double decay, double h) {
    // y(h) = e^{−x} y(0) + source h (1 − e^{−x})/x with x = decay h; its mean is (1 − e^{−x})/x y(0) + source h (1 −
    // mean)/x.
    const double x = decay * h;
    constexpr double small = 1e-4;
    mean = std::abs(x) > small ? -std::expm1(-x) / x : 1 - x / 2;
    mean_of_integral = std::abs(x) > small ? (1 - mean) / x : 1.0 / 2 - x / 6;
    lost = -std::expm1(-x);
  }
  double lost;              ///< y at the start less that at the end, by y at the start
  double mean;              ///< of e^{−decay t}: y at the end by source · h, the mean of y by that at the start
  double mean_of_integral;  ///< the mean of y by source · h
};

/// Bristles over a step h with constant tangents and a constant variation of the rate: of their variation ζ̇ = gain δ̇ −
/// decay ζ, and the mean of their force.
struct BristleKick {
  BristleKick(const BristleLoop::Here& at, double h) {
    const Fading fading(at.decay, h);
    lost = fading.lost;
    grown = at.gain * fading.mean * h;
    by_start = at.by_bristle * fading.mean;
    by_rate = at.by_rate + at.by_bristle * at.gain * fading.mean_of_integral * h;
  }
  double lost = 0, grown = 0;        ///< what ζ loses by that at the start, and ζ at the end by the rate
  double by_start = 0, by_rate = 0;  ///< the mean force by ζ at the start, and by the rate
};

/// Of the variation of the friction square to itself, by the time: from the deflections and their rates.
struct SlipSource {
  Eigen::Vector2d aside;  ///< its direction
  Eigen::RowVector3d by_deflection, by_rate;
};
SlipSource source_of(const RubbingLoop& loop, const RubbingLoop::Moment& here, double omega) {
  const ContactFrame& frame = here.frame;
  const FrameRates& rates = here.rates;
  const double k = loop.law().law().stiffness, curvature = frame.curvature;
  SlipSource found{{-here.direction.y(), here.direction.x()}, {}, {}};
  const Eigen::RowVector2d pulled = k * frame.friction(found.aside).transpose();
  found.by_rate = pulled * frame.on_wall;
  found.by_deflection = omega * pulled * rates.on_wall;
  // As a ring widens, friction and travel around it shrink.
  const double shrinks = curvature * found.aside.x();
  found.by_rate -= shrinks * here.friction.x() * frame.normal;
  found.by_deflection -= shrinks * omega *
      (here.friction.x() * (rates.normal - curvature * rates.along * frame.normal) +
       k * frame.hoop * rates.across.x() * frame.normal);
  // The limit grows.
  found.by_rate -= here.turning * omega * here.limit.by_rate * frame.normal;
  found.by_deflection -=
      here.turning * omega * (here.limit.by_deflection * frame.normal + here.limit.by_rate * omega * rates.normal);
  return found;
}

}  // namespace

VectorXd units_of_friction(const PeriodicLaws& motion, const VectorXd& accelerations) {
  VectorXd units(to_index(motion.rubbings.size()));
  for (std::size_t r = 0; r < motion.rubbings.size(); ++r) {
    const PeriodicLaws::Rubbing& one = motion.rubbings[r];
    const Eigen::Vector3d on = accelerations(one.on);
    const double k = one.loop.law().law().stiffness,
                 squared = k * on.tail(one.loop.law().is_ring() ? 3 : 2).cwiseAbs().maxCoeff();
    units(to_index(r)) = squared > 0 ? k / std::sqrt(squared) : k;
  }
  return units;
}

MatrixXd DeflectionResponse::left_side(const MatrixXd& by_deflection, const MatrixXd& by_rate, double step) const {
  const Index m = rates.rows();
  MatrixXd left = MatrixXd::Identity(m, m);
  if (massless) left -= by_deflection * (at_once + step / 2 * drifts);
  if (by_rate.size() > 0) left -= by_rate * (massless ? MatrixXd(drifts + step / 2 * rates) : step / 2 * rates);
  return left;
}

numerics::RowMatrix law_jacobians(const PeriodicLaws& motion, const DeflectionResponse& deflection_response,
                                  double from, double to, int steps) {
  const MatrixXd& rates_by_force = deflection_response.rates;
  const VectorXd accelerations = rates_by_force.diagonal();
  const Index m = rates_by_force.rows(), loops = to_index(motion.loops.size()),
              bristles = to_index(motion.bristles.size()), rubbings = to_index(motion.rubbings.size()),
              carried = motion.carried();
  const double phase_step = (to - from) / steps, step = phase_step / motion.omega;
  const bool damped = motion.is_damped();
  assert(steps > 0 && to > from && m == to_index(motion.courses.size()));
  assert((damped || (bristles == 0 && rubbings == 0)) && "bristles and contacts act on rates");
  const Index first_memory = damped ? 2 * m : m, first_rubbings = first_memory + 2 * loops,
              first_carried = first_memory + motion.kept();
  numerics::RowMatrix all((m + carried) * steps, first_memory + motion.memories());
  // Bristles are multiplied by the frequency at which they hold their mass: the transition then has entries of one
  // size, and its error is not that of stiff bristles alone.
  VectorXd scale = VectorXd::Ones(bristles);
  for (Index b = 0; b < bristles; ++b) {
    const PeriodicLaws::Bristles& one = motion.bristles[b];
    if (const double squared = one.loop->law().stiffness * std::abs(accelerations(one.deflection)); squared > 0)
      scale(b) = std::sqrt(squared);
  }
  const VectorXd units = units_of_friction(motion, accelerations);
  TangentsAlong tangent;
  MatrixXd forces(m, all.cols()), sources(rubbings, all.cols());
  for (int i = 0; i < steps; ++i) {
    set_tangents(motion, from + (i + 0.5) * phase_step, tangent);
    forces.setZero();
    forces.leftCols(m).diagonal() = tangent.by_deflection;
    if (damped) forces.middleCols(m, m).diagonal() = tangent.by_rate;
    for (std::size_t d = 0; d < motion.distances.size(); ++d) {
      const Index first = motion.distances[d].first;
      forces.block<3, 3>(first, first) += tangent.distances[d].by_deflection;
      if (damped) forces.block<3, 3>(first, m + first) += tangent.distances[d].by_rate;
    }
    for (Index h = 0; h < loops; ++h) {
      const Index j = motion.loops[h].deflection;
      forces(j, j) += tangent.by_travel(h);
      forces(j, first_memory + 2 * h) = -tangent.by_travel(h);
      forces(j, first_memory + 2 * h + 1) = tangent.by_start(h);
    }
    std::vector<BristleKick> of_bristles;
    for (Index b = 0; b < bristles; ++b) {
      const Index j = motion.bristles[b].deflection;
      of_bristles.emplace_back(tangent.bristles[b], step);
      forces(j, m + j) += of_bristles.back().by_rate;
      forces(j, first_carried + b) = of_bristles.back().by_start / scale(b);
    }
    sources.setZero();
    std::vector<Fading> of_rubbings;
    for (Index r = 0; r < rubbings; ++r) {
      const PeriodicLaws::Rubbing& one = motion.rubbings[r];
      const TangentsAlong::Rubbing& there = tangent.rubbings[r];
      of_rubbings.emplace_back(there.moment.fading * motion.omega, step);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
          forces(one.on[a], one.on[b]) += there.by_deflection(to_index(a), to_index(b));
          forces(one.on[a], m + one.on[b]) += there.by_rate(to_index(a), to_index(b));
        }
      if (!one.remembers()) continue;
      const ContactFrame& frame = there.moment.frame;
      if (there.moment.state == RubbingLoop::State::sticks)
        for (std::size_t a = 0; a < 3; ++a)
          forces.row(one.on[a]).segment<2>(first_rubbings + 2 * r) +=
              units(r) * frame.friction(frame.tangents.col(to_index(a))).transpose();
      if (there.moment.state != RubbingLoop::State::slips) continue;
      const SlipSource found = source_of(one.loop, there.moment, motion.omega);
      for (std::size_t b = 0; b < 3; ++b) {
        sources(r, one.on[b]) = found.by_deflection(to_index(b));
        sources(r, m + one.on[b]) = found.by_rate(to_index(b));
      }
      const Eigen::Vector3d aside = frame.tangents.transpose() * found.aside;
      for (std::size_t a = 0; a < 3; ++a) {
        auto force = forces.row(one.on[a]);
        force += aside(to_index(a)) * of_rubbings.back().mean_of_integral * step * sources.row(r);
        force(first_carried + bristles + r) += aside(to_index(a)) * of_rubbings.back().mean * units(r);
      }
    }
    if (damped || deflection_response.massless) {  // the kick changes the deflections and rates that it depends on
      const MatrixXd left = deflection_response.left_side(
          forces.leftCols(m), damped ? MatrixXd(forces.middleCols(m, m)) : MatrixXd(), step);
      forces = numerics::PivotedLu<double>(left).solve(forces);
    }
    const Index first = i * (m + carried);
    all.middleRows(first, m) = step * forces;
    for (Index b = 0; b < bristles; ++b) {
      const Index j = motion.bristles[b].deflection;
      auto change = all.row(first + m + b);
      const double grown = scale(b) * of_bristles[b].grown;
      change = grown * step / 2 * rates_by_force.row(j) * forces;
      change(m + j) += grown;
      change(first_carried + b) -= of_bristles[b].lost;
    }
    for (Index r = 0; r < rubbings; ++r) {
      const Fading& fading = of_rubbings[r];
      auto change = all.row(first + m + bristles + r);
      change = sources.row(r) + sources.row(r).segment(m, m) * (step / 2 * rates_by_force * forces);
      change *= fading.mean * step / units(r);
      change(first_carried + bristles + r) -= fading.lost;
    }
  }
  return all;
}

}  // namespace trivet::nonlinear
