// SPDX-License-Identifier: BSD-3-Clause
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/machine/linear_machine.h"
#include "trivet/numerics/linalg/pole_residue.h"

namespace trivet::nonlinear {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

class MachineOfPoles final : public LinearMachine {
 public:
  MachineOfPoles(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                 const std::vector<assembly::Loading>& loadings)
      : size_(to_index(deflections.size())) {
    const Index n = assembled.matrices.size();
    MatrixXd rows(n, size_), ground_rows(assembled.ground.size(), size_);
    for (Index j = 0; j < size_; ++j) {
      rows.col(j) = deflections[j].on_coordinates;
      ground_rows.col(j) = deflections[j].on_ground;
    }
    MatrixXcd right_sides = rows.cast<Complex>();
    for (const assembly::Loading& loading : loadings) {
      Excited excited{{}, numerics::Load(size_)};
      const numerics::Load right = assembly::right_side(assembled, loading);
      for (const numerics::LoadTerm& term : right.terms()) {
        excited.terms.push_back({term.power, term.delay, right_sides.cols()});
        right_sides.conservativeResize(Eigen::NoChange, right_sides.cols() + 1);
        right_sides.rightCols<1>() = term.value;
      }
      for (const numerics::LoadTerm& term : loading.motion.terms())
        excited.ground.add({term.power, term.delay, ground_rows.transpose().cast<Complex>() * term.value});
      loadings_.push_back(std::move(excited));
    }
    const numerics::PoleResidueForm form = numerics::pole_residue_form(assembled.matrices, right_sides);
    if (form.free_motion.size() > 0 && form.free_motion.cwiseAbs().maxCoeff() > 0)
      throw foundation::NotComputable(free_when_removed);
    const MatrixXcd across = rows.transpose().cast<Complex>();
    poles_ = form.poles;
    shapes_ = across * form.shapes;
    participation_ = form.participation;
    static_part_ = across * form.static_part;
    residues_.resize(size_ * size_, poles_.size());
    for (Index p = 0; p < poles_.size(); ++p)
      residues_.col(p) = (shapes_.col(p) * participation_.row(p).head(size_)).reshaped();
    all_shapes_ = form.shapes;
    all_static_ = form.static_part;
  }

  [[nodiscard]] const VectorXcd& poles() const override { return poles_; }

  void set_receptance(double omega, MatrixXcd& found) const override {
    found = static_part_.leftCols(size_);
    for (Index p = 0; p < poles_.size(); ++p) add_residues(about_pole(p, omega), p, found);
  }

  void set_receptance(double omega, Receptance& found) const override {
    found.receptance = static_part_.leftCols(size_);
    found.slope.setZero(size_, size_);
    for (Index p = 0; p < poles_.size(); ++p) {
      const Complex inverse = about_pole(p, omega),
                    slope(2 * inverse.real() * inverse.imag(),  // −i inverse²
                          inverse.imag() * inverse.imag() - inverse.real() * inverse.real());
      add_residues(inverse, p, found.receptance);
      add_residues(slope, p, found.slope);
    }
  }

  [[nodiscard]] LinearMotion motion(std::size_t loading, double omega) const override {
    const Complex s(0, omega), i(0, 1);
    assert(loading < loadings_.size());
    const VectorXcd inverse = about_poles(omega);
    LinearMotion found{VectorXcd::Zero(size_), VectorXcd::Zero(size_)};
    const auto add = [&](int power, double delay, const VectorXcd& value, const VectorXcd& slope) {
      const Complex factor = numerics::integer_power(s, power) * std::exp(-s * delay);
      found.motion += factor * value;
      found.slope += factor * (slope + i * (static_cast<double>(power) / s - delay) * value);
    };
    for (const Term& term : loadings_[loading].terms) {
      const VectorXcd weighted = inverse.asDiagonal() * participation_.col(term.column);
      add(term.power, term.delay, shapes_ * weighted + static_part_.col(term.column),
          Complex(0, -1) * (shapes_ * (inverse.asDiagonal() * weighted)));
    }
    for (const numerics::LoadTerm& term : loadings_[loading].ground.terms())
      add(term.power, term.delay, term.value, VectorXcd::Zero(size_));
    return found;
  }

  [[nodiscard]] VectorXcd coordinates(double omega, const VectorXcd& forces, const std::size_t* loading,
                                      double factor) const override {
    const Complex s(0, omega);
    VectorXcd weights = VectorXcd::Zero(static_part_.cols());
    weights.head(size_) = -forces;
    assert(forces.size() == size_);
    if (loading)
      for (const Term& term : loadings_[*loading].terms)
        weights(term.column) = factor * numerics::integer_power(s, term.power) * std::exp(-s * term.delay);
    const VectorXcd inverse = about_poles(omega);
    return all_shapes_ * (inverse.asDiagonal() * (participation_ * weights)) + all_static_ * weights;
  }

  [[nodiscard]] double known_to() const override { return std::numeric_limits<double>::infinity(); }

 private:
  /// 1/(iω − pole). Division by the library checks for overflow, which takes ten times as long.
  [[nodiscard]] Complex about_pole(Index p, double omega) const {
    const double re = -poles_(p).real(), im = omega - poles_(p).imag(), scale = 1 / (re * re + im * im);
    return {re * scale, -im * scale};
  }
  /// The residues of a pole times a number, by real numbers: Eigen's complex product took 1.6 times the instructions.
  void add_residues(Complex factor, Index pole, MatrixXcd& sum) const {
    const double re = factor.real(), im = factor.imag();
    const Complex* const from = residues_.col(pole).data();
    Complex* const to = sum.data();
    for (Index i = 0; i < sum.size(); ++i)
      to[i] = {to[i].real() + re * from[i].real() - im * from[i].imag(),
               to[i].imag() + re * from[i].imag() + im * from[i].real()};
  }
  [[nodiscard]] VectorXcd about_poles(double omega) const {
    VectorXcd inverse(poles_.size());
    for (Index p = 0; p < poles_.size(); ++p) inverse(p) = about_pole(p, omega);
    return inverse;
  }

  /// A term s^power e^{−s delay} of the excitation: its column among the right sides of the poles.
  struct Term {
    int power;
    double delay;
    Index column;
  };
  struct Excited {
    std::vector<Term> terms;
    numerics::Load ground;  ///< deflections by the motion of the ground alone
  };

  Index size_;
  std::vector<Excited> loadings_;
  MatrixXcd all_shapes_;  ///< coordinates × poles
  MatrixXcd all_static_;  ///< coordinates × right sides
  VectorXcd poles_;
  MatrixXcd shapes_;         ///< deflections × poles
  MatrixXcd participation_;  ///< poles × right sides
  MatrixXcd static_part_;    ///< deflections × right sides
  MatrixXcd residues_;       ///< entries of the receptance × poles
};

/// Frequencies beside poles so close to each other that they may be one without as many shapes.
std::vector<double> beside_close_poles(const VectorXcd& poles) {
  constexpr double close = 1e-2;  // round-off separates k equal poles by its k-th root
  constexpr double beside = 1.1;  // of the pole, where an undamped machine has motions too
  std::vector<double> frequencies;
  for (Index i = 0; i < poles.size(); ++i) {
    const Complex& one = poles(i);
    if (!std::isfinite(std::abs(one)) || one == 0.0 || one.imag() < 0) continue;
    for (Index k = 0; k < i; ++k)
      if (std::abs(poles(k) - one) <= close * std::abs(one)) {
        frequencies.push_back(beside * std::abs(one));
        break;
      }
  }
  return frequencies;
}

/// Are receptances and motions under the excitation the same to round-off?
bool agree(const LinearMachine& one, const LinearMachine& other, std::size_t loadings, double omega) {
  constexpr double round_off = 1e-10;
  MatrixXcd ours, theirs;
  one.set_receptance(omega, ours);
  other.set_receptance(omega, theirs);
  const Eigen::VectorXd size = theirs.diagonal().cwiseAbs().cwiseSqrt();
  assert(ours.rows() == theirs.rows() && ours.cols() == theirs.cols());
  if (!((ours - theirs).cwiseAbs().array() <= round_off * (size * size.transpose()).array()).all()) return false;
  for (std::size_t i = 0; i < loadings; ++i) {
    const VectorXcd moved = other.motion(i, omega).motion;
    if (!((one.motion(i, omega).motion - moved).cwiseAbs().maxCoeff() <= round_off * moved.cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

}  // namespace

std::unique_ptr<LinearMachine> machine_of_poles(const assembly::Assembled& assembled,
                                                const std::vector<Deflection>& deflections,
                                                const std::vector<assembly::Loading>& loadings) {
  auto found = std::make_unique<MachineOfPoles>(assembled, deflections, loadings);
  const std::vector<double> doubtful = beside_close_poles(found->poles());
  if (doubtful.empty()) return found;
  auto direct = machine_over_frequency(assembled, deflections, loadings);
  for (const double omega : doubtful)
    if (!agree(*found, *direct, loadings.size(), omega)) return direct;
  return found;
}

}  // namespace trivet::nonlinear
