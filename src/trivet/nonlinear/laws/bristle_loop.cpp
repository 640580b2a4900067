// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/bristle_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;
using numerics::RadauPanel;

/// How far a panel may reach between two turning points.
class BristleLoop::Grading {
 public:
  Grading(const BristleLoop& loop, double from, double to) : loop_(loop), first_(at(from)), last_(at(to)) {}

  [[nodiscard]] bool is_fine(double from, double to) const {
    const elements::LuGreFriction& law = loop_.part_.law;
    const double here = at(from), there = at(to), since = std::abs(here - first_), left = std::abs(last_ - there),
                 travel = std::abs(there - here), fastest = std::max(std::abs(rate(from)), std::abs(rate(to)));
    // Until a layer has faded to round-off, its exponential function is resolved; then only places that double.
    constexpr double to_round_off = 40, resolved = 1.3, growth = 2;
    if (travel * decay(fastest) > resolved) {
      if (faded_ < to_round_off) return false;
      if (travel > growth * since || travel > growth * left) return false;
    }
    if (!law.has_stribeck_effect()) return true;
    constexpr double of_change = 0.35, beyond = 8;
    const double slowest = this->slowest(from, to);
    return slowest > beyond * law.stribeck_velocity ||
        fastest - slowest <= of_change * std::max(fastest, law.stribeck_velocity);
  }
  /// The layer has faded over a panel, at least by the decay of its smaller rate.
  void pass(double from, double to) { faded_ += std::abs(at(to) - at(from)) * decay(slowest(from, to)); }

 private:
  [[nodiscard]] static double value(double phase, const VectorXd& of) {
    return numerics::motion_at((of.size() - 1) / 2, phase, of);
  }
  [[nodiscard]] double at(double phase) const { return value(phase, loop_.deflection_); }
  [[nodiscard]] double rate(double phase) const { return loop_.omega_ * value(phase, loop_.slope_); }
  /// Rate of a panel that is short against the waves of the motion: by a parabola, which has a minimum if the motion
  /// almost stops within.
  [[nodiscard]] double slowest(double from, double to) const {
    const double a = std::abs(rate(from)), m = std::abs(rate((from + to) / 2)), b = std::abs(rate(to));
    const double slope = 4 * m - 3 * a - b, bend = 2 * (a + b - 2 * m), place = -slope / (2 * bend);
    const double lowest = std::min({a, m, b});
    if (!(bend > 0 && place > 0 && place < 1)) return lowest;
    return std::clamp(a + place * slope / 2, 0.0, lowest);
  }
  [[nodiscard]] double decay(double rate) const { return elements::bristle_decay(loop_.part_.law, rate, 1).per_travel; }

  const BristleLoop& loop_;
  double first_, last_, faded_ = 0;
};

BristleLoop::BristleLoop(const LawAbout::Bristles& part, const VectorXd& deflection, double omega,
                         const std::vector<double>& turns, double longest)
    : part_(part), deflection_(deflection), slope_(numerics::phase_derivative(deflection)), omega_(omega) {
  if (turns.empty() || !is_above_round_off(turns)) return;
  ends_ = {turns.front()};
  for (std::size_t i = 0; i < turns.size(); ++i)
    add_branch(turns[i], i + 1 < turns.size() ? turns[i + 1] : turns.front() + two_pi, longest);
  [[maybe_unused]] constexpr double of_period = 1e-9;
  assert(ends_.size() == senses_.size() + 1 && std::abs(ends_.back() - ends_.front() - two_pi) < of_period);
  const Index count = RadauPanel::nodes * to_index(senses_.size());
  for (VectorXd* of_nodes : {&phases_, &weights_, &slopes_, &by_rate_, &gains_, &fading_}) of_nodes->resize(count);
  VectorXd decays(count);
  double faded = 1;
  for (std::size_t p = 0; p < senses_.size(); ++p) {
    const Index first = RadauPanel::nodes * to_index(p);
    const double from = ends_[p], length = ends_[p + 1] - from;
    for (Index i = 0; i < RadauPanel::nodes; ++i) {
      const double phase = from + length * numerics::radau_panel().places(i),
                   slope = numerics::motion_at((slope_.size() - 1) / 2, phase, slope_);
      const elements::BristleDecay decay = elements::bristle_decay(part_.law, omega_ * slope, senses_[p]);
      phases_(first + i) = phase;
      weights_(first + i) = length * numerics::radau_panel().weights(i);
      slopes_(first + i) = slope;
      by_rate_(first + i) = decay.by_rate;
      gains_(first + i) = decay.per_travel;
      decays(first + i) = decay.per_travel * slope;
    }
    panels_.emplace_back(length, decays.segment<RadauPanel::nodes>(first));
    fading_.segment<RadauPanel::nodes>(first) = faded * panels_.back().of_start;
    faded = fading_(first + RadauPanel::nodes - 1);
  }
  decayed_ = weights_.dot(decays);
  // dz/dφ = δ' − p δ' z, so that a period keeps e^{−∫ p dδ} of z: z(φ₀) = z_from zero(2π)/(1 − e^{−∫ p dδ}).
  assert((omega_ <= 0 || !(decayed_ <= 0)) && "bristles that move forget; trials of Newton's method may have any ω");
  bristles_ = closed(slopes_);
  // By dδ/dφ: 1 − z (p + v dp/dv).
  gains_ = 1 - bristles_.array() * (gains_.array() + omega_ * slopes_.array() * by_rate_.array());
}

/// Of a smaller travel, what the bristles forget in a period is round-off.
bool BristleLoop::is_above_round_off(const std::vector<double>& turns) const {
  constexpr double least = 1e-9;  // of the travel over which they forget
  std::vector<double> places;
  for (const double turn : turns) places.push_back(numerics::motion_at((slope_.size() - 1) / 2, turn, deflection_));
  const auto [low, high] = std::ranges::minmax_element(places);
  return *high - *low > least * part_.law.slip / part_.law.stiffness;
}

void BristleLoop::add_branch(double from, double to, double longest) {
  Grading grading(*this, from, to);
  const double sense = numerics::motion_at((slope_.size() - 1) / 2, (from + to) / 2, slope_) < 0 ? -1 : 1;
  constexpr double shortest = 1e-12, nearly = 1.01;
  double at = from, step = longest;
  while (at < to) {
    step = std::min(2 * step, longest);
    while (step > shortest && !grading.is_fine(at, std::min(at + step, to))) step /= 2;
    const double next = at + nearly * step >= to ? to : at + step;
    grading.pass(at, next);
    at = next;
    ends_.push_back(at);
    senses_.push_back(sense);
  }
}

template <typename Matrix>
Matrix BristleLoop::from_zero(const Matrix& source) const {
  using Row = Eigen::Matrix<typename Matrix::Scalar, 1, Eigen::Dynamic>;
  constexpr Index count = RadauPanel::nodes;
  assert(source.rows() == count * to_index(panels_.size()));
  Matrix found(source.rows(), source.cols());
  Row start = Row::Zero(source.cols());
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    const Index first = count * to_index(p);
    found.middleRows(first, count).noalias() = panels_[p].of_source * source.middleRows(first, count);
    found.middleRows(first, count).noalias() += panels_[p].of_start * start;
    start = found.row(first + count - 1);
  }
  return found;
}

MatrixXd BristleLoop::closed(const MatrixXd& source) const {
  MatrixXd found = from_zero(source);
  const Eigen::RowVectorXd start = found.bottomRows<1>() / -std::expm1(-decayed_);
  found.noalias() += fading_ * start;
  return found;
}

MatrixXd BristleLoop::variation(const MatrixXd& slopes) const { return closed(gains_.asDiagonal() * slopes); }

MatrixXcd BristleLoop::variation_from_zero(const MatrixXcd& slopes) const {
  return from_zero<MatrixXcd>(gains_.asDiagonal() * slopes);
}

double BristleLoop::faded() const { return std::exp(-decayed_); }

VectorXd BristleLoop::variation_by_omega() const {
  return closed(-bristles_.array() * by_rate_.array() * slopes_.array().square());
}

BristleLoop::Here BristleLoop::at(double phase) const {
  while (phase < ends_.front()) phase += two_pi;
  while (phase >= ends_.back()) phase -= two_pi;
  const auto after = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, phase);
  const auto p = static_cast<std::size_t>(after - ends_.begin()) - 1;
  assert(p < panels_.size() && phase >= ends_[p] && phase <= ends_[p + 1]);
  const Index first = RadauPanel::nodes * to_index(p);
  Eigen::Matrix<double, RadauPanel::nodes + 1, 1> values;
  values << bristles_(first > 0 ? first - 1 : bristles_.size() - 1), bristles_.segment<RadauPanel::nodes>(first);
  const double z = numerics::radau_panel().interpolation((phase - ends_[p]) / (ends_[p + 1] - ends_[p])) * values,
               v = omega_ * numerics::motion_at((slope_.size() - 1) / 2, phase, slope_);
  const elements::LuGreFriction& law = part_.law;
  const auto [per_travel, by_rate] = elements::bristle_decay(law, v, senses_[p]);
  const double decay = per_travel * v, gain = 1 - z * (per_travel + v * by_rate);
  return {law.stiffness * z + law.damping * (v - decay * z) + law.viscous * v - part_.at_state,
          law.damping * gain + law.viscous, law.stiffness - law.damping * decay, gain, decay};
}

std::vector<double> BristleLoop::corners() const {
  std::vector<double> found;
  for (std::size_t p = 0; p + 1 < ends_.size(); ++p) found.push_back(std::fmod(ends_[p], two_pi));
  return found;
}

}  // namespace trivet::nonlinear
