// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/steady_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::VectorXd;
using numerics::BranchPoint;

SteadyPath::SteadyPath(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
                       const SteadyOptions& options, Index harmonics)
    : options_(options),
      deflections_(deflections),
      balance_(machine, deflections, harmonics),
      branch_(
          [this](const VectorXd& unknowns, double parameter, numerics::Equations& equations) {
            balance_.evaluate(unknowns, driving(parameter), options_.over, equations);
          },
          smallest_scale(), width()) {}

Driving SteadyPath::driving(double parameter) const {
  if (options_.over == Parameter::frequency) return {parameter, 1};
  return {options_.angular_frequency, parameter};
}

std::string SteadyPath::place(double parameter) const {
  return options_.over == Parameter::frequency ? fmt::format("{:.10g} rad/s", parameter)
                                               : fmt::format("{:.10g} times the load", parameter);
}

/// Coefficients that stay near zero are compared with a thousandth of the linear motion.
VectorXd SteadyPath::smallest_scale() const {
  constexpr double share = 1e-3;
  const VectorXd motion = balance_.linear_motion(driving(options_.from));
  const double largest = motion.size() > 0 ? motion.cwiseAbs().maxCoeff() : 0;
  if (!(largest > 0)) throw foundation::NotComputable("steady: no excitation moves a nonlinear part");
  return VectorXd::Constant(motion.size(), share * largest);
}

/// From the linear motion; where Newton's method does not converge from there, from that of a raised load.
std::optional<BranchPoint> SteadyPath::first() const {
  const VectorXd linear = balance_.linear_motion(driving(options_.from));
  if (std::optional<BranchPoint> found = branch_.start(linear, options_.from)) return found;
  if (const std::optional<BranchPoint> raised = raised_to_load()) return branch_.start(raised->unknowns, options_.from);
  return std::nullopt;
}

/// The motion at the lower end of the band, followed as its load is raised from a small one.
std::optional<BranchPoint> SteadyPath::raised_to_load() const {
  const Driving whole = driving(options_.from);
  const numerics::Branch branch(
      [&](const VectorXd& unknowns, double factor, numerics::Equations& equations) {
        balance_.evaluate(unknowns, {whole.omega, factor}, Parameter::load_factor, equations);
      },
      smallest_scale(), whole.factor);
  const double small = 1e-3 * whole.factor;
  std::optional<BranchPoint> now = branch.start(balance_.linear_motion({whole.omega, small}), small);
  double step = 0.01;
  constexpr int most_points = 2000;
  for (int i = 0; now && i < most_points; ++i) {
    const std::optional<numerics::Branch::Advance> advance = branch.advance(*now, step, {.sharp_turns = 1e-4});
    if (!advance) return std::nullopt;
    if (advance->to.parameter > whole.factor) return branch.at(whole.factor, *now, 0, advance->length);
    now = advance->to;
  }
  return std::nullopt;
}

bool SteadyPath::follow(double most_left_out, const foundation::Progress& progress) {
  constexpr double first_step = 0.02;                            // in shares of the deflection and of the band
  constexpr numerics::StepControl control{.sharp_turns = 1e-4};  // a slider begins to slip in both senses
  const std::optional<BranchPoint> start = first();
  if (!start)
    throw foundation::NotComputable(
        fmt::format("steady: no motion was found at the lower end of the band, {}; begin elsewhere: lower, or above "
                    "the motions that were sought",
                    place(options_.from)));
  const auto add = [&](const BranchPoint& point) {
    points_.push_back(point);
    left_out_ = std::max(left_out_, balance_.left_out(point.unknowns, driving(point.parameter).omega));
    return left_out_ <= most_left_out;
  };
  if (!add(*start)) return false;
  double step = first_step;
  while (points_.back().parameter < options_.to) {
    const BranchPoint& now = points_.back();
    if (to_index(points_.size()) >= options_.most_points) {
      ended_ = fmt::format("stopped after {} points", options_.most_points);
      break;
    }
    std::optional<numerics::Branch::Advance> advance = branch_.advance(now, step, control);
    if (!advance || !(advance->to.parameter > 0)) {
      ended_ =
          fmt::format("no further motion beyond {}: the step of the branch became too short", place(now.parameter));
      break;
    }
    BranchPoint next = std::move(advance->to);
    add_pieces(advance->length, next);
    double length = advance->length;
    if (next.parameter > options_.to)
      if (std::optional<BranchPoint> end = at(options_.to, pieces_.back())) {
        length = numerics::Branch::length(now, *end);
        next = std::move(*end);
      }
    if (ended_ = leaves_curve(next); !ended_.empty()) break;
    lengths_.push_back(length);
    if (!add(next)) return false;
    if (next.parameter < options_.from) {
      ended_ = "left the band downwards at " + place(next.parameter);
      break;
    }
    if (progress) progress("steady motion", std::clamp((next.parameter - options_.from) / width(), 0.0, 1.0));
  }
  return true;
}

/// The pieces of the step from the last point, with the fold between them if the parameter turns, and the motions asked
/// for.
void SteadyPath::add_pieces(double length, const BranchPoint& next) {
  const std::size_t from = points_.size() - 1, first_new = pieces_.size();
  const BranchPoint& now = points_.back();
  const bool turns = next.parameter_direction() * now.parameter_direction() < 0;
  const std::optional<BranchPoint> fold = turns ? branch_.fold(now, length) : std::nullopt;
  if (fold) {
    turns_.push_back({*fold, from, now.parameter_direction() > 0});
    const double to_fold = numerics::Branch::length(now, *fold);
    pieces_.push_back({from, 0, to_fold, now.parameter, fold->parameter});
    pieces_.push_back({from, to_fold, length, fold->parameter, next.parameter});
  } else {
    pieces_.push_back({from, 0, length, now.parameter, next.parameter});
  }
  for (const double wanted : options_.at)
    for (std::size_t i = first_new; i < pieces_.size(); ++i)
      if (std::optional<BranchPoint> there = at(wanted, pieces_[i])) asked_for_.push_back(std::move(*there));
}

std::optional<BranchPoint> SteadyPath::at(double parameter, const Piece& piece) const {
  if ((piece.parameter_begin < parameter) == (piece.parameter_end < parameter)) return std::nullopt;
  return branch_.at(parameter, points_[piece.from], piece.begin, piece.end);
}

std::vector<BranchPoint> SteadyPath::all_at(double parameter) const {
  std::vector<BranchPoint> found;
  for (const Piece& piece : pieces_)
    if (std::optional<BranchPoint> there = at(parameter, piece)) found.push_back(std::move(*there));
  return found;
}

/// Of a motion that leaves the points of a curve which must not be extended.
std::string SteadyPath::leaves_curve(const BranchPoint& point) const {
  const Index C = balance_.coefficients();
  for (Index j = 0; j < to_index(deflections_.size()); ++j) {
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

}  // namespace trivet::nonlinear
