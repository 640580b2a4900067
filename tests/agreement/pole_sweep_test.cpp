// SPDX-License-Identifier: BSD-3-Clause
// A sweep from poles and residues against LU with pivoting in quadruple precision, at resonances and near them.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "support/hard_cases.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/pole_sweep.h"

namespace {

using namespace trivet;
using numerics::DynamicMatrices;
using numerics::PoleSweep;

__extension__ typedef __float128 Quad;

struct QuadComplex {
  Quad re = 0, im = 0;
};
QuadComplex operator-(const QuadComplex& a, const QuadComplex& b) { return {a.re - b.re, a.im - b.im}; }
QuadComplex operator*(const QuadComplex& a, const QuadComplex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
QuadComplex operator/(const QuadComplex& a, const QuadComplex& b) {
  const Quad square = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}
double modulus(const QuadComplex& z) { return std::hypot(static_cast<double>(z.re), static_cast<double>(z.im)); }

struct Comparison {
  double forward = 0;   ///< ‖q − exact‖ / ‖exact‖
  double backward = 0;  ///< ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates of unit mass diagonal
};

Comparison compare(const DynamicMatrices& given, const Eigen::VectorXcd& load, double omega,
                   const Eigen::VectorXcd& q) {
  const auto n = to_size(given.size());
  const Eigen::VectorXd d = numerics::unit_scale(given.A);
  std::vector<std::vector<QuadComplex>> z(n, std::vector<QuadComplex>(n));
  std::vector<QuadComplex> x(n);
  double norm = 0, residual = 0, size = 0, h = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = to_index(i);
    x[i] = {Quad(d(row)) * load(row).real(), Quad(d(row)) * load(row).imag()};
    QuadComplex r = x[i];
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const auto column = to_index(j);
      const Quad scale = Quad(d(row)) * d(column);
      z[i][j] = {scale * (Quad(given.K(row, column)) - Quad(omega) * omega * given.A(row, column)),
                 scale * Quad(omega) * given.B(row, column)};
      r = r - z[i][j] * QuadComplex{Quad(q(column).real()) / d(column), Quad(q(column).imag()) / d(column)};
      sum += modulus(z[i][j]);
    }
    norm = std::max(norm, sum), residual = std::max(residual, modulus(r)), h = std::max(h, modulus(x[i])),
    size = std::max(size, std::abs(q(row)) / d(row));
  }
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c; i < n; ++i)
      if (modulus(z[i][c]) > modulus(z[pivot][c])) pivot = i;
    std::swap(z[c], z[pivot]);
    std::swap(x[c], x[pivot]);
    for (std::size_t i = c + 1; i < n; ++i) {
      const QuadComplex factor = z[i][c] / z[c][c];
      for (std::size_t j = c; j < n; ++j) z[i][j] = z[i][j] - factor * z[c][j];
      x[i] = x[i] - factor * x[c];
    }
  }
  double error = 0, exact = 0;
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) x[i] = x[i] - z[i][j] * x[j];
    x[i] = x[i] / z[i][i];
    const auto row = to_index(i);
    const QuadComplex difference = QuadComplex{Quad(q(row).real()) / d(row), Quad(q(row).imag()) / d(row)} - x[i];
    error = std::hypot(error, modulus(difference)), exact = std::hypot(exact, modulus(x[i]));
  }
  return {error / exact, residual / (norm * size + h)};
}

struct Answer {
  Eigen::ArrayXXd re, im;
  bool proven = false;
};
Answer response(const PoleSweep& poles, const std::vector<double>& omega, Eigen::Index n) {
  const auto count = to_index(omega.size());
  Answer answer{Eigen::ArrayXXd(count, n), Eigen::ArrayXXd(count, n)};
  answer.proven = poles.response(Eigen::Map<const Eigen::ArrayXd>(omega.data(), count), answer.re, answer.im);
  return answer;
}
Eigen::VectorXcd at(const Answer& answer, std::size_t i) {
  const auto row = to_index(i);
  return answer.re.row(row).matrix().transpose() + std::complex<double>(0, 1) * answer.im.row(row).matrix().transpose();
}

/// ω of each undamped and each damped mode, and ω shifted by ±1e-12 … 3 ζ.
std::vector<double> near_resonances(const DynamicMatrices& m) {
  std::vector<double> omega = test::awkward_frequencies(m);
  const auto roots = numerics::roots_from_states(m).lambda;
  for (Eigen::Index k = 0; k < roots.size(); ++k) {
    const double modulus = std::abs(roots(k)), zeta = -roots(k).real() / modulus;
    for (const double shift : {0.0, 1e-12, 1e-9, 0.3 * zeta, zeta, 3 * zeta})
      for (const double sign : {-1.0, 1.0}) omega.push_back(modulus * std::max(0.0, 1 + sign * shift));
  }
  return omega;
}

TEST(PoleSweep, IsRightNearEveryResonanceOfEveryHardCaseThatItSolves) {
  // Poles keep all digits of Re λ of light damping. The other cases include close poles and a mass ratio of 1e-6.
  constexpr double of_light_damping = 1e-11, of_others = 1e-9;
  int answered = 0;
  for (const test::HardCase& hard : test::hard_cases()) {
    const std::string name = hard.name;
    const std::optional<PoleSweep> poles = PoleSweep::try_build(hard.m, test::load());
    if (!poles) continue;
    const std::vector<double> omega = near_resonances(hard.m);
    const Answer found = response(*poles, omega, hard.m.size());
    if (!found.proven) continue;
    ++answered;
    const bool general_light = name == "general damping, ratio 1e-6";
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const Comparison with = compare(hard.m, test::load(), omega[i], at(found, i));
      EXPECT_LE(with.backward, numerics::accepted_backward_error) << name << " at " << omega[i];
      EXPECT_LE(with.forward, general_light ? of_light_damping : of_others) << name << " at " << omega[i];
    }
  }
  EXPECT_GE(answered, 7);
}

TEST(PoleSweep, DeclinesSystemsWithoutAProof) {
  for (const test::HardCase& hard : test::hard_cases()) {
    const std::string name = hard.name;
    const bool impossible = name.starts_with("critical") || name == "exceptional point" || name == "indefinite mass" ||
        name == "unsymmetric" || name.starts_with("loss factor");
    if (impossible) {
      EXPECT_FALSE(PoleSweep::try_build(hard.m, test::load())) << name;
    }
    const bool regular =
        name.starts_with("general") || name.starts_with("proportional") || name.starts_with("coincident");
    if (regular) {
      EXPECT_TRUE(PoleSweep::try_build(hard.m, test::load())) << name;
    }
  }
}

DynamicMatrices random_system(int n, unsigned seed, double damping) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto definite = [&](int rank) {
    const Eigen::MatrixXd g = Eigen::MatrixXd::NullaryExpr(n, rank, [&] { return normal(generator); });
    return Eigen::MatrixXd(g * g.transpose());
  };
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  return {definite(n) + n * one, damping * definite(n), 1e3 * (definite(n) + one), {}, true};
}

TEST(PoleSweep, AgreesForAnyNumberOfCoordinatesAndFrequenciesOnEveryInstructionSet) {
  constexpr double round_off = 1e-12;  // times the condition of systems without very light damping
  struct Restore {
    ~Restore() { numerics::use_instruction_set(""); }
  } restore;
  for (const std::string& set : numerics::instruction_sets()) {
    numerics::use_instruction_set(set);
    int proven = 0;
    for (int n = 1; n <= 12; ++n)
      for (const double damping : {0.01, 1.0}) {
        const DynamicMatrices m = random_system(n, static_cast<unsigned>(n), damping);
        const Eigen::VectorXcd load =
            Eigen::VectorXcd::LinSpaced(n, std::complex<double>(1, n % 2), std::complex<double>(-0.7, 0.4));
        const std::optional<PoleSweep> poles = PoleSweep::try_build(m, load);
        const bool fused =
            set != "SCALAR" && set != "EMU128";  // without fused products light damping cannot be checked
        if (!poles && !fused) continue;
        ASSERT_TRUE(poles) << set << ", n = " << n << ", damping " << damping;
        ++proven;
        for (const int count : {1, 7, 8, 21}) {
          std::vector<double> omega;
          for (int i = 0; i < count; ++i) omega.push_back(3.1 * i);
          const Answer found = response(*poles, omega, n);
          EXPECT_TRUE(found.proven);
          for (std::size_t i = 0; i < omega.size(); ++i)
            EXPECT_LE(compare(m, load, omega[i], at(found, i)).forward, round_off) << set << ", n = " << n;
        }
      }
    EXPECT_GE(proven, 12) << set;
  }
}

/// Results larger than the caches are written by another method, for any alignment of the rows to memory lines.
TEST(PoleSweep, ResultLargerThanTheCachesIsThatOfItsPieces) {
  constexpr Eigen::Index count = 400'003, piece = 999;
  const DynamicMatrices m = random_system(6, 3, 0.1);
  const std::optional<PoleSweep> poles = PoleSweep::try_build(m, Eigen::VectorXcd::Ones(6));
  ASSERT_TRUE(poles);
  const Eigen::ArrayXd omega = Eigen::ArrayXd::LinSpaced(count, 0.01, 50);
  for (const Eigen::Index rows : {count, count + 5, count + 7}) {  // distances that are not multiples of a memory line
    Eigen::ArrayXXd memory_re(rows, 6), memory_im(rows, 6);
    ASSERT_TRUE(poles->response(omega, memory_re.topRows(count), memory_im.topRows(count)));
    for (Eigen::Index first = 0; first < count; first += piece) {
      const Eigen::Index taken = std::min(piece, count - first);
      Eigen::ArrayXXd re(taken, 6), im(taken, 6);
      ASSERT_TRUE(poles->response(omega.segment(first, taken), re, im));
      ASSERT_TRUE((memory_re.middleRows(first, taken) == re).all() && (memory_im.middleRows(first, taken) == im).all())
          << rows << " " << first;
    }
  }
}

TEST(PoleSweep, NeedsArraysOfTheRightSize) {
  const std::optional<PoleSweep> poles = PoleSweep::try_build(random_system(3, 1, 0.1), Eigen::VectorXcd::Ones(3));
  ASSERT_TRUE(poles);
  Eigen::ArrayXXd re(4, 3), im(4, 2);
  EXPECT_THROW(static_cast<void>(poles->response(Eigen::ArrayXd::Ones(4), re, im)), foundation::InvalidInput);
}

TEST(PoleSweep, IsUsedByALongSweepWithoutErrorsAndAgreesWithTheDirectOne) {
  constexpr double round_off_at_resonances =
      3e-8;  // of the direct method: 100 epsilon over the smallest damping ratio of these cases, 1e-6
  std::vector<double> omega;
  for (int i = 0; i < 30000; ++i) omega.push_back(1e-4 * i);
  for (const auto& hard : test::hard_cases()) {
    const Eigen::VectorXcd load = test::load();
    if (!PoleSweep::try_build(hard.m, load)) continue;
    const numerics::SweepResult direct = numerics::sweep(hard.m, load, omega);
    numerics::SweepPlanes one, sixteen;
    numerics::sweep(hard.m, load, omega, one, {.every_backward_error = false, .threads = 1});
    numerics::sweep(hard.m, load, omega, sixteen, {.every_backward_error = false, .threads = 16});
    EXPECT_TRUE((one.re == sixteen.re).all() && (one.im == sixteen.im).all()) << hard.name;
    bool differs = false;
    for (Eigen::Index f = 0; f < direct.response.cols(); ++f) {
      const Eigen::VectorXcd q =
          one.re.row(f).transpose().matrix() + numerics::Complex(0, 1) * one.im.row(f).transpose().matrix();
      differs = differs || q != direct.response.col(f);
      EXPECT_LE((q - direct.response.col(f)).norm(), round_off_at_resonances * q.norm())
          << hard.name << " at " << omega[to_size(f)];
    }
    EXPECT_TRUE(differs) << hard.name << ": solved directly";
  }
}

}  // namespace
