// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/balance/observed_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace trivet::nonlinear {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Names of results, and what they are of points.
struct RequestedChannels {
  const std::vector<std::string>& of;
  assembly::MotionQuantity quantity;
  const std::vector<assembly::MotionQuantity>& quantities;

  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system,
                                                        const assembly::Assembled& assembled) const {
    if (quantities.empty()) return assembly::channels(system, assembled, of, quantity);
    std::vector<assembly::Channel> all;
    for (std::size_t i = 0; i < of.size(); ++i)
      for (assembly::Channel& one : assembly::channels(system, assembled, {of[i]}, quantities[i]))
        all.push_back(std::move(one));
    return all;
  }
};

/// The machine at rest with a unit force in one nonlinear part, which a force of an element at rest contains.
std::vector<double> forces_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                   const RequestedChannels& requested) {
  std::vector<double> values;
  for (const assembly::Channel& channel : requested.channels(system, assembled)) values.push_back(channel.at_rest);
  return values;
}

MatrixXd direct_forces(const model::System& system, const assembly::Assembled& assembled,
                       const RequestedChannels& requested) {
  Index parts = 0;
  for (const model::Element& element : system.elements())
    parts += to_index(element.nonlinear_parts.size()) + 3 * to_index(element.distance_parts.size()) +
        2 * to_index(element.rubbing_parts.size());
  const std::vector<double> without = forces_at_rest(system, assembled, requested);
  MatrixXd direct(to_index(without.size()), parts);
  Index column = 0;
  const auto add = [&](std::size_t e, const elements::Vector12& on_ends) {
    model::Description description = system.description();
    description.elements[e].law.nonlinear->offset += on_ends;
    const model::System with_force = system.in_other_state(std::move(description));
    const std::vector<double> with = forces_at_rest(with_force, assembled, requested);
    for (std::size_t c = 0; c < with.size(); ++c) direct(to_index(c), column) = with[c] - without[c];
    ++column;
  };
  const auto span = [&](const model::Element& element) { return model::span(system.bodies(), element.n, element.k); };
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    for (const model::NonlinearPart& part : element.nonlinear_parts) {
      // Forces on inner coordinates stay inside the element.
      if (part.is_inner()) direct.col(column++).setZero();
      else
        add(e, elements::deflection_row(part.axis, span(element).arm, span(element).n_from_k, part.centre).transpose());
    }
  }
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    for (std::size_t p = 0; p < system.elements()[e].distance_parts.size(); ++p)
      for (Index a = 0; a < 3; ++a)
        add(e, elements::difference_rows(span(system.elements()[e]).n_from_k).row(a).transpose());
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    for (const model::RubbingPart& part : system.elements()[e].rubbing_parts)
      for (const elements::Vector12& row :
           rows_across(system.elements()[e].nonlinear_parts[part.pressed_by], span(system.elements()[e])))
        add(e, row);
  assert(column == parts && "one column for each force of a law");
  return direct;
}

Complex observed(const numerics::CurveTerms& terms, Complex s, const VectorXcd& values) {
  Complex sum = (terms.on_displacement.transpose() * values)(0);
  if (terms.on_velocity.size() > 0) sum += s * (terms.on_velocity.cast<Complex>().transpose() * values)(0);
  if (terms.on_acceleration.size() > 0) sum += s * s * (terms.on_acceleration.cast<Complex>().transpose() * values)(0);
  return sum;
}

/// Largest value of a periodic course: of samples, then refined by Newton's method on its rate.
double largest_of(const VectorXd& coefficients, const MatrixXd& samples) {
  const Index harmonics = (coefficients.size() - 1) / 2;
  Index at = 0;
  const double sampled = (samples * coefficients).maxCoeff(&at);
  const VectorXd rate = numerics::phase_derivative(coefficients), curvature = numerics::phase_derivative(rate);
  double phase = foundation::two_pi * static_cast<double>(at) / static_cast<double>(samples.rows());
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i) {
    const double bend = numerics::motion_at(harmonics, phase, curvature);
    if (!(bend < 0)) break;
    phase -= numerics::motion_at(harmonics, phase, rate) / bend;
  }
  return std::max(sampled, numerics::motion_at(harmonics, phase, coefficients));
}

/// The basis and the remainders of all forces at the phases of these.
struct RemainderCourses {
  Eigen::VectorXd phases, weights;  ///< weights of means
  MatrixXd rows, remainder;         ///< of the basis; phases × nonlinear deflections
};

RemainderCourses remainder_courses(const ForceRemainder& forces, Index harmonics) {
  const std::vector<double>& phases = forces.phases();
  const auto count = to_index(phases.size());
  RemainderCourses found{VectorXd(count), VectorXd(count), MatrixXd(count, numerics::coefficient_count(harmonics)), {}};
  for (Index n = 0; n < count; ++n) {
    const double phase = phases[n];
    found.phases(n) = phase;
    const double before = n > 0 ? phases[n - 1] : phases.back() - foundation::two_pi,
                 after = n + 1 < count ? phases[n + 1] : phases.front() + foundation::two_pi;
    found.weights(n) = (after - before) / 2 / foundation::two_pi;
    found.rows.row(n) = numerics::fourier_row(harmonics, phase);
    const Eigen::RowVectorXd here = forces.at(phase);
    if (n == 0) found.remainder.resize(count, here.size());
    found.remainder.row(n) = here;
  }
  assert(std::abs(found.weights.sum() - 1) < 1e-9 && "phases ascend over one period");
  return found;
}

/// Largest of values over a period: of the samples, then of the parabolas through them.
template <typename At>
double largest_at(const VectorXd& phases, const VectorXd& values, const At& at) {
  Index place = 0;
  double largest = values.maxCoeff(&place);
  const Index count = values.size();
  constexpr double apart = 1e-8;  // farther than both sides of a jump
  const auto neighbour = [&](Index step) {
    Index other = (place + step + count) % count;
    while (other != place && std::abs(std::remainder(phases(other) - phases(place), foundation::two_pi)) <= apart)
      other = (other + step + count) % count;
    return other;
  };
  const Index before = neighbour(-1), after = neighbour(1);
  double x[3] = {phases(before), phases(place), phases(after)}, y[3] = {values(before), largest, values(after)};
  if (x[0] > x[1]) x[0] -= foundation::two_pi;
  if (x[2] < x[1]) x[2] += foundation::two_pi;
  constexpr int steps = 3;
  for (int i = 0; i < steps && x[1] > x[0] && x[2] > x[1]; ++i) {
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]),
                 bend = (right - left) / (x[2] - x[0]);
    if (!(bend < 0)) break;
    const double vertex = (x[0] + x[1]) / 2 - left / (2 * bend);
    if (!(vertex > x[0] && vertex < x[2])) break;
    const double there = at(vertex);
    if (!(there > y[1])) break;
    (vertex < x[1] ? x[2] : x[0]) = x[1];
    (vertex < x[1] ? y[2] : y[0]) = y[1];
    x[1] = vertex;
    y[1] = largest = there;
  }
  return largest;
}

}  // namespace

double ObservedMotion::value_at(double phase) const {
  double sum = mean;
  for (Index k = 0; k < harmonics.size(); ++k)
    sum += (harmonics(k) * std::polar(1.0, static_cast<double>(k + 1) * phase)).real();
  return sum;
}

double ObservedMotion::slope_at(double phase) const {
  double sum = 0;
  for (Index k = 0; k < harmonics.size(); ++k) {
    const auto order = static_cast<double>(k + 1);
    sum -= order * (harmonics(k) * std::polar(1.0, order * phase)).imag();
  }
  return sum;
}

Observer::Observer(const model::System& system, const assembly::Assembled& assembled, PeriodicExcitation excitation,
                   const std::vector<Deflection>& deflections, const std::vector<std::string>& of,
                   assembly::MotionQuantity quantity, const std::vector<assembly::MotionQuantity>& quantities)
    : assembled_(assembled),
      excitation_(std::move(excitation)),
      channels_(RequestedChannels{of, quantity, quantities}.channels(system, assembled)),
      direct_(MatrixXd::Zero(to_index(channels_.size()), to_index(deflections.size()))),
      feedthrough_(MatrixXd::Zero(direct_.rows(), direct_.cols())) {
  // Undamped free motion has no friction of stops, whose columns are the last, and a displacement that is followed as a
  // deflection bears no force.
  const MatrixXd direct = direct_forces(system, assembled, {of, quantity, quantities});
  const Index both = std::min(direct.cols(), direct_.cols());
  direct_.leftCols(both) = direct.leftCols(both);
  constexpr int acceleration = 2;
  if (std::ranges::none_of(channels_,
                           [](const assembly::Channel& channel) { return channel.derivative == acceleration; }))
    return;
  MatrixXd across(assembled.matrices.size(), direct_.cols());
  for (Index j = 0; j < across.cols(); ++j) across.col(j) = deflections[j].on_coordinates;
  const MatrixXd per_force = accelerations_per_force(assembled.matrices, across);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    if (channels_[c].derivative != acceleration) continue;
    const VectorXd row = channels_[c].on_displacement.real();
    for (Index j = 0; j < across.cols(); ++j) {
      double found = 0;
      for (Index i = 0; i < row.size(); ++i)
        if (row(i) != 0) found -= row(i) * per_force(i, j);
      if (std::isfinite(found)) feedthrough_(to_index(c), j) = found;  // else on a node without mass
    }
  }
}

/// Without the forces of nonlinear parts.
Complex Observer::value(std::size_t c, Complex s, const VectorXcd& coordinates, const VectorXcd& ground) const {
  const assembly::Channel& channel = channels_[c];
  Complex sum = observed(channel, s, coordinates);
  const bool moves = ground.size() > 0;
  if (moves && !channel.ground.empty()) sum += observed(channel.ground, s, ground);
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled_.elements[force.element];
    VectorXcd ends = map.coordinates(coordinates);
    if (moves) ends += map.moved_by_ground(ground);
    const double known = std::min(s.imag(), map.defined_to);
    const VectorXcd wrenches = known > 0 ? VectorXcd(map.dynamic_stiffness(known, known) * ends.head(12))
                                         : VectorXcd(map.matrices.stiffness.topRows<12>().cast<Complex>() * ends);
    sum += (force.row.cast<Complex>() * wrenches)(0);
  }
  return sum;
}

std::vector<ObservedMotion> Observer::at(const Eigen::MatrixXcd& coordinates, const MatrixXd& forces, double omega,
                                         double factor, const ForceRemainder* remainder) const {
  const Index harmonics = (forces.rows() - 1) / 2;
  std::vector<VectorXd> courses(channels_.size(), VectorXd::Zero(forces.rows()));
  assert(forces.rows() % 2 == 1 && coordinates.cols() == harmonics + 1 && "the mean, then a cosine and a sine each");
  for (Index k = 0; k <= harmonics; ++k) {
    const Complex s(0, static_cast<double>(k) * omega);
    VectorXcd force(forces.cols());
    for (Index j = 0; j < forces.cols(); ++j)
      force(j) = k == 0 ? Complex(forces(0, j)) : Complex(forces(2 * k - 1, j), -forces(2 * k, j));
    VectorXcd ground;
    for (std::size_t e = 0; e < excitation_.harmonics.size(); ++e)
      if (excitation_.harmonics[e] == k && !excitation_.loadings[e].motion.vanishes())
        ground = factor * excitation_.loadings[e].motion.at(s.imag());
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      Complex value = this->value(c, s, coordinates.col(k), ground) +
          (direct_.row(to_index(c)).cast<Complex>() * force.head(direct_.cols()))(0);
      value *= numerics::integer_power(s, channels_[c].derivative);
      if (k == 0) {
        courses[c](0) = value.real();
      } else {
        courses[c](2 * k - 1) = value.real();
        courses[c](2 * k) = -value.imag();
      }
    }
  }
  const Index count = 8 * (harmonics + 1);
  MatrixXd samples(count, forces.rows());
  for (Index n = 0; n < count; ++n)
    samples.row(n) =
        numerics::fourier_row(harmonics, foundation::two_pi * static_cast<double>(n) / static_cast<double>(count));
  std::vector<ObservedMotion> results;
  for (const VectorXd& course : courses) {
    ObservedMotion motion;
    motion.mean = course(0);
    motion.harmonics.resize(harmonics);
    for (Index k = 1; k <= harmonics; ++k) motion.harmonics(k - 1) = {course(2 * k - 1), -course(2 * k)};
    motion.largest = largest_of(course, samples);
    motion.smallest = -largest_of(-course, samples);
    motion.rms = course.tail(course.size() - 1).norm() / std::sqrt(2.0);
    assert(!(motion.smallest > motion.largest));
    results.push_back(std::move(motion));
  }
  if (!remainder || !follows_forces()) return results;
  const RemainderCourses all = remainder_courses(*remainder, harmonics);
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const Eigen::RowVectorXd direct = direct_.row(to_index(c)) + feedthrough_.row(to_index(c));
    if (direct.isZero(0)) continue;
    const VectorXd left_out = all.remainder.leftCols(direct.size()) * direct.transpose(),
                   values = all.rows * courses[c] + left_out;
    const auto at = [&](double phase) {
      return numerics::motion_at(harmonics, phase, courses[c]) + direct.dot(remainder->at(phase).head(direct.size()));
    };
    results[c].largest = largest_at(all.phases, values, at);
    results[c].smallest = -largest_at(all.phases, -values, [&](double phase) { return -at(phase); });
    results[c].rms = std::sqrt(results[c].rms * results[c].rms + all.weights.dot(left_out.cwiseAbs2()));
  }
  return results;
}

}  // namespace trivet::nonlinear
