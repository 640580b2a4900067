// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/laws/bristle_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>

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

BristleLoop::BristleLoop(const DeviationLaw::Bristles& part, const VectorXd& deflection, double omega,
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

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using foundation::two_pi;

namespace {

/// Bristles that do not move stick with their stiffness, but for a mean that they forget.
MatrixXd sticking(const elements::LuGreFriction& law, Index count, double omega) {
  MatrixXd stiffness = law.stiffness * MatrixXd::Identity(count, count);
  stiffness(0, 0) = 0;
  return stiffness +
      omega * (law.damping + law.viscous) * numerics::phase_derivatives(MatrixXd::Identity(count, count));
}

}  // namespace

BristleHarmonics bristle_harmonics(const BristleLoop& loop, const VectorXd& deflection, double omega,
                                   bool with_tangent) {
  const elements::LuGreFriction& law = loop.law();
  // F = σ₀ z + σ₁ ż + σ₂ v: of coefficients σ₀ ẑ + ω D (σ₁ ẑ + σ₂ δ̂), D the derivative by the phase.
  assert(deflection.size() % 2 == 1 && loop.weights().size() == loop.phases().size());
  const Index count = deflection.size(), harmonics = (count - 1) / 2, nodes = loop.phases().size();
  BristleHarmonics found{VectorXd::Zero(count), {}, {}};
  if (!loop.moves()) {
    const MatrixXd stuck = sticking(law, count, omega);
    found.force = stuck * deflection;
    if (with_tangent) {
      found.tangent = stuck;
      found.by_omega = sticking(law, count, 1) * deflection - sticking(law, count, 0) * deflection;
    }
    return found;
  }
  MatrixXd basis(count, nodes);
  Eigen::RowVectorXd row;
  for (Index i = 0; i < nodes; ++i) {
    numerics::set_fourier_row(harmonics, loop.phases()(i), row);
    basis.col(i) = row.transpose();
  }
  const VectorXd weights = loop.weights() / (two_pi / 2);
  const VectorXd bristles = basis * weights.cwiseProduct(loop.bristles()),
                 rate = numerics::phase_derivative(deflection), bristle_rate = numerics::phase_derivative(bristles);
  found.force = law.stiffness * bristles + omega * (law.damping * bristle_rate + law.viscous * rate);
  found.force(0) -= 2 * loop.at_state();
  if (!with_tangent) return found;
  // dδ/dφ by the coefficients at the nodes.
  MatrixXd slopes = MatrixXd::Zero(nodes, count);
  for (Index k = 1; k <= harmonics; ++k) {
    slopes.col(2 * k - 1) = -static_cast<double>(k) * basis.row(2 * k).transpose();
    slopes.col(2 * k) = static_cast<double>(k) * basis.row(2 * k - 1).transpose();
  }
  const MatrixXd integral = basis * weights.asDiagonal(), by_motion = integral * loop.variation(slopes);
  found.tangent = law.stiffness * by_motion + omega * law.damping * numerics::phase_derivatives(by_motion) +
      omega * law.viscous * numerics::phase_derivatives(MatrixXd::Identity(count, count));
  const VectorXd by_omega = integral * loop.variation_by_omega();
  found.by_omega = law.stiffness * by_omega +
      law.damping * (omega * numerics::phase_derivative(by_omega) + bristle_rate) + law.viscous * rate;
  return found;
}

namespace {

// As waves turn by at most a period, so that μ turns them by at most π/2 from the middle, the error is below 1e-8.
constexpr int chebyshev_places = 12;

double chebyshev_angle(int place) { return two_pi / 4 * (2 * place + 1) / chebyshev_places; }

/// Place of an interpolation between 0 and 1/2.
double chebyshev_place(int place) { return (1 + std::cos(chebyshev_angle(place))) / 4; }

/// Barycentric weights, whose sum is 1.
Eigen::VectorXd chebyshev_weights(double mu) {
  assert(mu >= 0 && mu <= 0.5 && "other multipliers are those of −μ or μ + 1");
  VectorXd weights(chebyshev_places);
  for (int j = 0; j < chebyshev_places; ++j) {
    const double distance = mu - chebyshev_place(j);
    if (distance == 0) return VectorXd::Unit(chebyshev_places, j);
    weights(j) = (j % 2 == 0 ? 1 : -1) * std::sin(chebyshev_angle(j)) / distance;
  }
  return weights / weights.sum();
}

}  // namespace

BristleVariation::BristleVariation(const BristleLoop& loop, double omega, Index harmonics)
    : law_(loop.law()), moves_(loop.moves()), omega_(omega), faded_(loop.faded()), harmonics_(harmonics) {
  for (int j = 0; moves_ && j < chebyshev_places; ++j) at_places_.push_back(open(loop, chebyshev_place(j)));
}

/// In the wave e^{iμ(φ − φ_0)} from the first turning point on, which cancels in the amplitudes.
BristleVariation::Open BristleVariation::open(const BristleLoop& loop, double mu) const {
  const Index count = 2 * harmonics_ + 1, nodes = loop.phases().size();
  MatrixXcd waves(nodes, count), slopes(nodes, count);
  for (Index i = 0; i < nodes; ++i) {
    const double phase = loop.phases()(i);
    const Complex turn = std::polar(1.0, phase);
    Complex wave = std::polar(1.0, mu * (phase - loop.first_turn()) - static_cast<double>(harmonics_) * phase);
    for (Index k = 0; k < count; ++k, wave *= turn) {
      waves(i, k) = wave;
      slopes(i, k) = Complex(0, mu + static_cast<double>(k - harmonics_)) * wave;
    }
  }
  const MatrixXcd bristles = loop.variation_from_zero(slopes),
                  integral = waves.adjoint() * (loop.weights() / two_pi).asDiagonal();
  return {integral * bristles, integral * loop.fading(), bristles.bottomRows<1>()};
}

MatrixXcd BristleVariation::at(double mu) const {
  const Index count = 2 * harmonics_ + 1;
  Eigen::VectorXcd orders(count);  // i (μ + k)
  for (Index k = 0; k < count; ++k) orders(k) = Complex(0, mu + static_cast<double>(k - harmonics_));
  if (!moves_) return (law_.stiffness + omega_ * (law_.damping + law_.viscous) * orders.array()).matrix().asDiagonal();
  assert(at_places_.size() == static_cast<std::size_t>(chebyshev_places));
  const VectorXd weights = chebyshev_weights(mu);
  Open sum{MatrixXcd::Zero(count, count), Eigen::VectorXcd::Zero(count), Eigen::RowVectorXcd::Zero(count)};
  for (int j = 0; j < chebyshev_places; ++j) {
    const Open& one = at_places_[static_cast<std::size_t>(j)];
    sum.from_zero += weights(j) * one.from_zero;
    sum.fading += weights(j) * one.fading;
    sum.ends += weights(j) * one.ends;
  }
  // A start ζ₀ with ζ(2π) = e^{2πiμ} ζ₀ = ends + e^{−∫ p dδ} ζ₀.
  sum.from_zero += sum.fading * (sum.ends / (std::polar(1.0, two_pi * mu) - faded_));
  MatrixXcd found = (law_.stiffness + omega_ * law_.damping * orders.array()).matrix().asDiagonal() * sum.from_zero;
  found.diagonal() += omega_ * law_.viscous * orders;
  return found;
}

}  // namespace trivet::nonlinear
