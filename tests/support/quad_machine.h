// SPDX-License-Identifier: BSD-3-Clause
// A machine with forces in phase, no moving ground and no frequency-dependent element, solved in quadruple precision.
#pragma once

#include <vector>

#include "support/quad_model.h"

namespace trivet::test {

/// Where a number of a model is in the list of a family.
enum Number { mass, damping, stiffness, loss, at_rest_load, force, random_force, motion, momentum, first_channel };
/// Per channel: terms of displacement (real, imaginary) and velocity, constant at rest, row at rest.
constexpr std::size_t per_channel = 4;

struct ChannelNumbers {
  QuadMatrix re, im, velocity, at_rest;
};

/// The model of one parameter value in quadruple precision.
class QuadMachine {
 public:
  QuadMachine(std::vector<QuadMatrix> numbers, const std::vector<double>& modal_ratios) : m_(std::move(numbers)) {
    modes_ = quad_modes(m_[stiffness], m_[mass]);
    if (modal_ratios.empty()) return;
    QuadMatrix twice = QuadMatrix::Zero(m_[mass].rows(), m_[mass].rows());
    for (Eigen::Index i = 0; i < twice.rows(); ++i) twice(i, i) = 2 * Quad(modal_ratios[i]) * sqrt(modes_.lambda(i));
    const QuadMatrix momentum_of_modes = m_[mass] * modes_.shapes;
    m_[damping] += momentum_of_modes * twice * momentum_of_modes.transpose();
  }

  [[nodiscard]] const QuadModes& modes() const { return modes_; }
  [[nodiscard]] const QuadMatrix& number(std::size_t i) const { return m_[i]; }
  [[nodiscard]] ChannelNumbers channel(std::size_t c) const {
    const std::size_t first = first_channel + per_channel * c;
    return {m_[first], m_[first + 1], m_[first + 2], m_[first + 3]};
  }
  [[nodiscard]] QuadPair at_root(const QuadComplex& s) const {
    const QuadComplex square = s * s;
    return {m_[stiffness] + s.real() * m_[damping] + square.real() * m_[mass],
            m_[loss] + s.imag() * m_[damping] + square.imag() * m_[mass]};
  }
  [[nodiscard]] QuadPair slope_at_root(const QuadComplex& s) const {
    return {m_[damping] + 2 * s.real() * m_[mass], 2 * s.imag() * m_[mass]};
  }

  /// ln|y| of a channel and its derivatives with respect to ω.
  struct Curve {
    Quad value, first, second;
  };
  [[nodiscard]] Curve curve(std::size_t c, int derivative, const Quad& omega, std::size_t load) const {
    const QuadFactors z(at_root({0, omega}));
    const auto zero = [&](const QuadMatrix& like) { return QuadMatrix(QuadMatrix::Zero(like.rows(), like.cols())); };
    const QuadPair h{m_[load], zero(m_[load])}, rate{-2 * omega * m_[mass], m_[damping]},
        twice{-2 * m_[mass], zero(m_[mass])};
    const QuadPair q = z.solve(h), q1 = z.solve(rate * q) * QuadComplex(-1),
                   q2 = z.solve(rate * q1 * QuadComplex(2) + twice * q) * QuadComplex(-1);
    const ChannelNumbers of = channel(c);
    const QuadPair row{of.re, of.im + omega * of.velocity}, row1{zero(of.re), of.velocity};
    const QuadComplex y = (row * q).value(), y1 = (row * q1).value() + (row1 * q).value(),
                      y2 = (row * q2).value() + QuadComplex(2) * (row1 * q1).value();
    // (iω)^d adds d/ω and −d/ω² to the derivatives of the logarithm.
    const QuadComplex r = y1 / y, r2 = y2 / y;
    const Quad d = derivative;
    return {log(norm(y)) / 2 + d * log(omega), r.real() + d / omega, (r2 - r * r).real() - d / (omega * omega)};
  }
  [[nodiscard]] QuadPair response(const Quad& omega, std::size_t load) const {
    return QuadFactors(at_root({0, omega})).solve({m_[load], QuadMatrix::Zero(m_[load].rows(), m_[load].cols())});
  }
  /// Without time derivatives.
  [[nodiscard]] QuadComplex value(std::size_t c, const QuadPair& q, const Quad& omega) const {
    const ChannelNumbers of = channel(c);
    return (QuadPair{of.re, of.im + omega * of.velocity} * q).value();
  }

 private:
  static Quad norm(const QuadComplex& y) { return y.real() * y.real() + y.imag() * y.imag(); }

  std::vector<QuadMatrix> m_;
  QuadModes modes_;
};

}  // namespace trivet::test
