// SPDX-License-Identifier: BSD-3-Clause
// Every solver of a frequency sweep against LU in extended precision: all instruction sets, any size, load, tail and
// number of threads.
#include <gmock/gmock.h>

#include <cstring>
#include <random>

#include "support/hard_cases.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/numerics/sweep/sweep_kernels.h"
#include "trivet/numerics/sweep/sweep_workspace.h"

namespace sweep_kernels_test {

using namespace trivet;
using namespace trivet::numerics;

const SweepOptions quick{.every_backward_error = false, .threads = 1, .progress = {}};

Eigen::MatrixXd random_matrix(std::mt19937& generator, Eigen::Index n) {
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd result(n, n);
  for (double& entry : result.reshaped()) entry = number(generator);
  return result;
}

DynamicMatrices random_system(Eigen::Index n, unsigned seed, bool lossy = false) {
  std::mt19937 generator(seed);
  const Eigen::MatrixXd r = random_matrix(generator, n), s = random_matrix(generator, n),
                        q = random_matrix(generator, n);
  DynamicMatrices m{Eigen::MatrixXd::Identity(n, n) + 0.2 * r * r.transpose(),
                    0.5 * q * q.transpose(),
                    100 * s * s.transpose(),
                    {},
                    true};
  if (lossy) m.K_loss = 0.05 * m.K;
  return m;
}

Eigen::VectorXcd random_vector(Eigen::Index n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::VectorXcd result(n);
  for (Complex& entry : result) {
    entry.real(number(generator));
    entry.imag(number(generator));
  }
  return result;
}

std::vector<double> frequencies(std::size_t count, double from = 0, double step = 0.37) {
  std::vector<double> omega(count);
  for (std::size_t i = 0; i < count; ++i) omega[i] = from + step * static_cast<double>(i);
  return omega;
}

using Extended = std::complex<long double>;

/// ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in coordinates of unit mass diagonal, in extended precision.
double true_backward_error(const DynamicMatrices& m, const Eigen::VectorXcd& load, double omega,
                           const Eigen::VectorXcd& response) {
  const Eigen::VectorXd d = unit_scale(m);
  const DynamicMatrices scale = scaled(m, d);
  const Extended iw(0, omega);
  const ExtendedMatrix z =
      scale.complex_stiffness().cast<Extended>() + iw * scale.B.cast<Extended>() + iw * iw * scale.A.cast<Extended>();
  const ExtendedVector h = d.cast<Extended>().asDiagonal() * load.cast<Extended>();
  const ExtendedVector q = d.cast<Extended>().cwiseInverse().asDiagonal() * response.cast<Extended>();
  return static_cast<double>(
      (z * q - h).cwiseAbs().maxCoeff() /
      (z.cwiseAbs().rowwise().sum().maxCoeff() * q.cwiseAbs().maxCoeff() + h.cwiseAbs().maxCoeff()));
}

double worst_backward_error(const DynamicMatrices& m, const Load& load, const std::vector<double>& omega,
                            const Eigen::MatrixXcd& response) {
  double worst = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const Eigen::VectorXcd q = response.col(to_index(i));
    if (q.allFinite()) worst = std::max(worst, true_backward_error(m, load.at(omega[i]), omega[i], q));
  }
  return worst;
}

/// Each test runs with every instruction set that this processor has.
class SweepKernels : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { use_instruction_set(GetParam()); }
  void TearDown() override { use_instruction_set(""); }
};

INSTANTIATE_TEST_SUITE_P(All, SweepKernels, testing::ValuesIn(instruction_sets()),
                         [](const auto& info) { return info.param; });

TEST_P(SweepKernels, SolutionsAcceptedByTheGrowthOfFactorsHaveASmallBackwardError) {
  for (const test::HardCase& hard : test::hard_cases()) {
    std::vector<double> omega = test::awkward_frequencies(hard.m);
    for (const double more : frequencies(400, 0.05, 0.31)) omega.push_back(more);
    Eigen::VectorXcd real = test::load().real().cast<Complex>();
    for (const Load& load : {Load(test::load()), Load(real), Load(Eigen::VectorXcd::Unit(6, 2))}) {
      const SweepResult found = sweep(hard.m, load, omega, quick);
      EXPECT_EQ((!found.response.array().isFinite()).colwise().any().count(), found.singular) << hard.name;
      EXPECT_LE(worst_backward_error(hard.m, load, omega, found.response), accepted_backward_error) << hard.name;
    }
  }
}

TEST_P(SweepKernels, EverySizeAndLoadIsSolved) {
  for (const Eigen::Index n : {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 19}) {
    for (const bool lossy : {false, true}) {
      const DynamicMatrices m = random_system(n, static_cast<unsigned>(n), lossy);
      const std::vector<double> omega = frequencies(n <= 6 ? 300 : 50, 0.5, 0.1);  // more than one chunk if it is cheap
      Load turning(n);
      turning.add({2, 0, random_vector(n, 3)});
      turning.add({-1, 0.02, random_vector(n, 4)});
      Load late(n);
      late.add({1, 0.3, random_vector(n, 5).real().cast<Complex>()});
      for (const Load& load :
           {Load(random_vector(n, 1)), Load(random_vector(n, 2).real().cast<Complex>()), turning, late}) {
        const Eigen::MatrixXcd found = sweep(m, load, omega, quick).response;
        EXPECT_TRUE(found.allFinite()) << n;
        EXPECT_LE(worst_backward_error(m, load, omega, found), accepted_backward_error) << n;
      }
    }
  }
}

TEST_P(SweepKernels, TheBackwardErrorOfAWrongSolutionIsTheTrueOne) {
  // |re| + |im| is within √2 of the modulus, in the numerator and in the denominator.
  constexpr double modulus = 1.4143, far_above_round_off = 1e-3;
  constexpr long count = 16;
  constexpr int n = 6;
  for (const double load_size : {1e-3, 1.0, 1e6}) {
    DynamicMatrices m = random_system(n, 3, true);
    const Eigen::VectorXd d = unit_scale(m);
    const sweep_kernels::Coefficients z(scaled(m, d));
    const Eigen::VectorXcd h = load_size * random_vector(n, 1), wrong = random_vector(n, 2);
    std::vector<double> omega = frequencies(count, 0.3), load(2 * n * count), q(2 * n * count), error(count);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t f = 0; f < count; ++f) {
        const Complex here = d(to_index(i)) * h(to_index(i)), x = wrong(to_index(i));
        load[i * count + f] = here.real(), load[(n + i) * count + f] = here.imag();
        q[i * count + f] = x.real(), q[(n + i) * count + f] = x.imag();
      }
    sweep_kernels::backward_errors(z,
                                   {omega.data(),
                                    count,
                                    {load.data(), load.data() + n * count, count},
                                    {},
                                    d.data(),
                                    {q.data(), q.data() + n * count, count},
                                    error.data()});
    for (std::size_t f = 0; f < count; ++f) {
      const double exact = true_backward_error(m, h, omega[f], wrong);
      EXPECT_GT(exact, far_above_round_off);
      EXPECT_GE(error[f], exact / modulus);
      EXPECT_LE(error[f], exact * modulus);
    }
  }
}

TEST_P(SweepKernels, ATailIsSolvedLikeAWholePack) {
  const DynamicMatrices m = random_system(6, 5);
  const Load load(random_vector(6, 1).real().cast<Complex>());
  const std::vector<double> omega = frequencies(600);
  const Eigen::MatrixXcd whole = sweep(m, load, omega, quick).response;
  for (const std::size_t count : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 255, 256, 257, 511}) {
    const std::vector<double> some(omega.begin(), omega.begin() + static_cast<std::ptrdiff_t>(count));
    EXPECT_TRUE(sweep(m, load, some, quick).response == whole.leftCols(to_index(count))) << count;
  }
}

TEST_P(SweepKernels, PivotedLanesSolveMatricesWithoutLeadingPivots) {
  constexpr double backward_error = 1e-15;  // 4.5 ε: seven coordinates, with pivoting
  constexpr long count = 16;
  DynamicMatrices m{
      Eigen::MatrixXd::Identity(7, 7), Eigen::MatrixXd::Zero(7, 7), Eigen::MatrixXd::Zero(7, 7), {}, false};
  std::mt19937 generator(8);
  m.K = random_matrix(generator, 7);
  m.K.diagonal().setZero();
  m.A.setZero();
  const sweep_kernels::Coefficients z(m);
  const std::vector<double> omega(count, 1.0), scale(7, 1.0);
  std::vector<double> load(2 * 7 * count), q(2 * 7 * count), error(count);
  const Eigen::VectorXcd h = random_vector(7, 9);
  for (int i = 0; i < 7; ++i)
    for (int f = 0; f < count; ++f) {
      load[i * count + f] = h(i).real() * (f + 1);
      load[(7 + i) * count + f] = h(i).imag() * (f + 1);
    }
  const sweep_kernels::Batch batch{omega.data(), count,        {load.data(), load.data() + 7 * count, count},
                                   {},           scale.data(), {q.data(), q.data() + 7 * count, count},
                                   error.data()};
  EXPECT_TRUE(sweep_kernels::solve_pivoted(z, batch));
  for (int f = 0; f < count; ++f) {
    Eigen::VectorXcd found(7);
    for (int i = 0; i < 7; ++i) found(i) = {q[i * count + f], q[(7 + i) * count + f]};
    EXPECT_LE(true_backward_error(m, h * (f + 1), 1.0, found), backward_error) << f;
  }
}

TEST(Sweep, IsTheSameByteForByteOnOneThreadAndSixteen) {
  const auto cases = test::hard_cases();
  const std::vector<double> omega = frequencies(25000, 0, 0.005);
  for (const std::size_t which : {0U, 9U, 12U, 14U}) {
    SweepOptions one = quick, sixteen = quick;
    one.threads = 1, sixteen.threads = 16;
    const SweepResult a = sweep(cases[which].m, test::load(), omega, one),
                      b = sweep(cases[which].m, test::load(), omega, sixteen);
    EXPECT_EQ(std::memcmp(a.response.data(), b.response.data(), sizeof(Complex) * to_size(a.response.size())), 0)
        << cases[which].name;
    EXPECT_EQ(a.fallbacks, b.fallbacks);
  }
}

TEST(Sweep, APartThatDependsOnFrequencyActsLikeTheSameMatrix) {
  const DynamicMatrices m = random_system(8, 2);
  DynamicMatrices rest = m;
  const Eigen::MatrixXd share = random_system(8, 3).K;
  rest.K -= share;
  const Eigen::VectorXcd more = random_vector(8, 6);
  const FrequencyPart part{[&](double omega, Eigen::MatrixXcd& z, Eigen::VectorXcd& h) {
    z += share.cast<Complex>();
    h += omega * more;
  }};
  Load load(random_vector(8, 1)), both = load;
  both.add({1, 0, Complex(0, -1) * more});
  const std::vector<double> omega = frequencies(90, 0.1);
  for (const bool symmetric : {true, false}) {
    rest.symmetric = symmetric;
    const SweepResult found = sweep(rest, load, part, omega);
    EXPECT_LE(found.backward_error.maxCoeff(), accepted_backward_error);
    EXPECT_LE(worst_backward_error(m, both, omega, found.response), accepted_backward_error);
  }
}

}  // namespace sweep_kernels_test
