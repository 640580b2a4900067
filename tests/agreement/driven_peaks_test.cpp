// SPDX-License-Identifier: BSD-3-Clause
// Peaks of many designs with loss factors, any phases and powers of s, from all poles in ω, against the search on discs
// free of poles, which expands the response of one design from solutions of Z q = h.
#include "trivet/numerics/batch/driven_peaks.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

#include "support/random_designs.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/peaks/disc_search.h"
#include "trivet/numerics/peaks/peak_count.h"

namespace trivet {
namespace driven_peaks_test {

using Complex = std::complex<double>;

/// Stated in design_peaks.h for heights that are not lightly damped.
constexpr double nine_digits = 1e-9;
/// Error of the solutions in the search on discs: ε/ζ of the height, ζ ≥ 1e-6, and a margin.
constexpr double lightly_damped = 2e-8;
/// Share of the highest value: 5 % of the rise that makes a peak, if round-off hides the position of a deep minimum
/// (docs/decisions/peaks-of-designs.md).
constexpr double base_in_doubt = 5e-8;
/// Most designs must be solved by the kernel: the others have nearly coincident or undamped poles.
constexpr double most_are_proven = 0.75;
/// With twelve strongly coupled modes.
constexpr double few_are_proven = 0.3;

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double operator()() { return normal_(generator_); }
  Eigen::ArrayXXd numbers(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::ArrayXXd::NullaryExpr(rows, columns, [&] { return (*this)(); });
  }

 private:
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
};

struct Kind {
  int n = 6;
  double damping = 1e-2;  ///< least damping ratio
  double loss = 0.1;      ///< loss factor of about half of the stiffness; 0: none
  std::vector<int> load_powers = {0};
  std::vector<int> row_powers = {0};
  bool moving_ground = false;  ///< a constant motion is part of the results
  unsigned seed = 1;
};

/// D between 0 and `loss` K, with no loss in half of all directions: K = L Lᵀ, D = L M Lᵀ.
Eigen::ArrayXXd random_loss(const Eigen::ArrayXXd& K, int n, double loss, Random& random) {
  Eigen::ArrayXXd D(K.rows(), K.cols());
  for (Eigen::Index d = 0; d < K.rows(); ++d) {
    const Eigen::MatrixXd L = Eigen::LLT<Eigen::MatrixXd>(numerics::unpacked(K, d)).matrixL();
    const Eigen::MatrixXd Q = Eigen::HouseholderQR<Eigen::MatrixXd>(random.numbers(n, n).matrix()).householderQ();
    const Eigen::MatrixXd half = L * Q.leftCols((n + 1) / 2);
    numerics::pack(loss * half * half.transpose(), D, d);
  }
  return D;
}

numerics::DrivenDesigns driven_designs(Eigen::Index count, const Kind& kind) {
  const numerics::Designs plain = test::random_designs(count, kind.n, kind.damping, kind.seed);
  Random random(kind.seed);
  numerics::DrivenDesigns designs{plain.A, plain.B, plain.K, {}, {}, {}};
  if (kind.loss > 0) designs.D = random_loss(plain.K, kind.n, kind.loss, random);
  const auto terms = [&](const std::vector<int>& powers, Eigen::Index rows) {
    std::vector<numerics::DesignTerm> result;
    for (const int power : powers) {
      const double scale = std::pow(0.1, power);  // near 10 rad/s, all powers matter
      result.push_back({power, scale * random.numbers(rows, kind.n), scale * random.numbers(rows, kind.n)});
    }
    return result;
  };
  designs.loads.push_back(terms(kind.load_powers, count));
  for (int c = 0; c < 3; ++c) {
    const Eigen::Index rows = c == 0 ? 1 : count;  // the first result is the same in all designs
    designs.curves.push_back(
        {0, terms(kind.row_powers, rows), Eigen::ArrayXXd::Zero(1, 1), Eigen::ArrayXXd::Zero(1, 1)});
    if (kind.moving_ground) {
      designs.curves.back().constant_re = 1e-3 * random.numbers(rows, 1);
      designs.curves.back().constant_im = 1e-3 * random.numbers(rows, 1);
    }
  }
  return designs;
}

Eigen::VectorXcd row_of(const numerics::DesignTerm& term, Eigen::Index d) {
  const Eigen::Index row = term.re.rows() > 1 ? d : 0;
  return term.re.row(row).matrix().transpose().cast<Complex>() +
      Complex(0, 1) * term.im.row(row).matrix().transpose().cast<Complex>();
}

/// One design for the search on discs. Complex rows on velocity have no place there, so a curve has one power.
std::vector<numerics::SearchedCurve> by_discs(const numerics::DrivenDesigns& designs, Eigen::Index d, double from,
                                              double to) {
  const Eigen::Index n = numerics::coordinates_of(designs.A.cols());
  numerics::DynamicMatrices m{
      numerics::unpacked(designs.A, d), numerics::unpacked(designs.B, d), numerics::unpacked(designs.K, d), {}};
  if (designs.D.size() > 0) m.K_loss = numerics::unpacked(designs.D, d);
  numerics::Load load(n), given(Eigen::Index{1});
  for (const numerics::DesignTerm& term : designs.loads[0]) load.add({term.power, 0, row_of(term, d)});
  given.add({0, 0, Eigen::VectorXcd::Ones(1)});
  std::vector<numerics::ObservedCurve> curves;
  for (const numerics::DesignCurve& curve : designs.curves) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(n), no_motion = Eigen::VectorXd::Zero(1);
    const Eigen::Index row = curve.constant_re.rows() > 1 ? d : 0;
    numerics::ObservedCurve observed{{row_of(curve.rows[0], d), none, none}, {}, curve.rows[0].power};
    const Complex constant(curve.constant_re(row, 0), curve.constant_im(row, 0));
    if (constant != 0.0) observed.of_given = {Eigen::VectorXcd::Constant(1, constant), no_motion, no_motion};
    curves.push_back(observed);
  }
  return numerics::search_by_discs({m, load, given}, curves, numerics::poles(numerics::system_roots(m)), {from, to})
      .curves;
}

void expect_agreement(const Kind& kind, const numerics::DrivenPeakOptions& options, double tolerance = nine_digits,
                      Eigen::Index count = 48, double share = most_are_proven) {
  const numerics::DrivenDesigns designs = driven_designs(count, kind);
  const numerics::DesignPeaks found = numerics::driven_peaks(designs, options);
  double proven = 0;
  for (Eigen::Index d = 0; d < count; ++d) {
    if (found.status[d] != numerics::DesignStatus::proven) continue;
    ++proven;
    const std::vector<numerics::SearchedCurve> curves = by_discs(designs, d, options.from, options.to);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const std::string where = "design " + std::to_string(d) + ", curve " + std::to_string(c);
      const numerics::CurveHeights heights = numerics::heights_of(curves[c], options.from, options.to);
      EXPECT_NEAR(found.highest(d, to_index(c)), heights.highest, tolerance * heights.highest) << where;
      if (!options.count_peaks) continue;
      const numerics::PeakCount expected = numerics::prominent_peaks(heights.along, 1e-6 * heights.highest);
      const double rise = expected.largest_rise;
      EXPECT_EQ(found.peaks(d, to_index(c)), expected.peaks) << where;
      EXPECT_NEAR(found.largest_rise(d, to_index(c)), rise, (tolerance + base_in_doubt) * (1 + rise) * (1 + rise))
          << where;
    }
  }
  EXPECT_GE(proven, share * static_cast<double>(count)) << kind.n << " coordinates, seed " << kind.seed;
}

const numerics::DrivenPeakOptions whole_axis, highest_only{.count_peaks = false}, in_band{.from = 3, .to = 40},
    highest_in_band{.from = 3, .to = 40, .count_peaks = false};

TEST(DrivenPeaks, WithLossFactorsAgreeWithTheSearchOnDiscs) {
  for (const numerics::DrivenPeakOptions& options : {whole_axis, highest_only, in_band, highest_in_band})
    expect_agreement({}, options);
}

TEST(DrivenPeaks, WithLossFactorsAloneAgreeWithTheSearchOnDiscs) {
  for (const double loss : {1e-4, 0.02, 1.0})
    expect_agreement({.damping = 1e-6, .loss = loss, .seed = 2}, whole_axis, lightly_damped);
}

/// Strongly coupled modes. (Roots found twice do not occur in these designs; driven_maps_test has machines where they
/// do.)
TEST(DrivenPeaks, WithHeavyLossFactorsAgreeWithTheSearchOnDiscs) {
  for (unsigned seed = 20; seed < 26; ++seed)
    for (const double loss : {0.5, 2.0})
      expect_agreement({.n = 12, .loss = loss, .seed = seed}, highest_only, lightly_damped, 96, few_are_proven);
}

TEST(DrivenPeaks, WithComplexLoadsAgreeWithTheSearchOnDiscs) {
  for (const numerics::DrivenPeakOptions& options : {whole_axis, highest_only, in_band, highest_in_band})
    expect_agreement({.loss = 0, .seed = 3}, options);
  expect_agreement({.damping = 1e-6, .loss = 0, .seed = 4}, whole_axis, lightly_damped);
}

TEST(DrivenPeaks, WithPowersOfFrequencyAgreeWithTheSearchOnDiscs) {
  for (const numerics::DrivenPeakOptions& options : {whole_axis, highest_only, in_band, highest_in_band})
    expect_agreement({.load_powers = {2}, .seed = 5}, options);                                 // an unbalance
  expect_agreement({.loss = 0, .load_powers = {0, 1}, .seed = 6}, whole_axis);                  // a ground that moves
  expect_agreement({.loss = 0, .load_powers = {0}, .row_powers = {2}, .seed = 7}, whole_axis);  // accelerations
  expect_agreement({.load_powers = {-2, -1}, .row_powers = {2}, .seed = 8}, highest_in_band);   // ground acceleration
  expect_agreement({.load_powers = {0, 1}, .moving_ground = true, .seed = 9}, whole_axis);      // relative motions
}

/// Curves that grow towards high frequencies: velocities and accelerations under an unbalance.
TEST(DrivenPeaks, ThatGrowBeyondTheBandAgreeWithTheSearchOnDiscs) {
  const numerics::DrivenPeakOptions from_rest{.from = 0, .to = 12, .count_peaks = false},
      above{.from = 25, .to = 400, .count_peaks = false};  // above most poles the growth decides
  // Far below the highest poles their fractions cancel the growth, and digits are lost: such designs stay undecided.
  const auto expect = [](const Kind& kind, const numerics::DrivenPeakOptions& options, Eigen::Index count = 48) {
    expect_agreement(kind, options, nine_digits, count, few_are_proven);
  };
  for (const numerics::DrivenPeakOptions& options : {highest_in_band, from_rest, above}) {
    expect({.load_powers = {2}, .row_powers = {1}, .seed = 31}, options);
    expect({.loss = 0, .load_powers = {2}, .row_powers = {1}, .seed = 32}, options);
    expect({.load_powers = {2}, .row_powers = {2}, .seed = 33}, options);
    expect({.load_powers = {0, 1, 2}, .row_powers = {2}, .seed = 34}, options);
  }
  for (const int n : {1, 2, 12})
    for (const int power : {1, 2})
      expect({.n = n, .load_powers = {2}, .row_powers = {power}, .seed = 35}, highest_in_band, 16);
}

TEST(DrivenPeaks, OfOtherNumbersOfCoordinatesAgreeWithTheSearchOnDiscs) {
  for (const int n : {1, 2, 3, 9, 12})
    for (const numerics::DrivenPeakOptions& options : {whole_axis, highest_only})
      expect_agreement({.n = n, .seed = 10}, options, nine_digits, 16);
}

/// Designs of the plain kernel: conjugate residues, the variable ω².
TEST(DrivenPeaks, OfPlainDesignsAgreeWithThePlainKernel) {
  constexpr Eigen::Index count = 200;
  const numerics::Designs plain = test::random_designs(count, 6, 1e-2, 11);
  numerics::DrivenDesigns designs{plain.A, plain.B, plain.K, {}, {}, {}};
  designs.loads = {{{0, plain.load, Eigen::ArrayXXd::Zero(1, 6)}}};
  for (int j = 0; j < 6; ++j) {
    Eigen::ArrayXXd row = Eigen::ArrayXXd::Zero(1, 6);
    row(0, j) = 1;
    designs.curves.push_back(
        {0, {{0, row, Eigen::ArrayXXd::Zero(1, 6)}}, Eigen::ArrayXXd::Zero(1, 1), Eigen::ArrayXXd::Zero(1, 1)});
  }
  const numerics::DesignPeaks driven = numerics::driven_peaks(designs), expected = numerics::design_peaks(plain);
  int compared = 0;
  for (Eigen::Index d = 0; d < count; ++d) {
    if (driven.status[d] != numerics::DesignStatus::proven) continue;
    ++compared;
    for (Eigen::Index j = 0; j < 6; ++j) {
      EXPECT_NEAR(driven.highest(d, j), expected.highest(d, j), nine_digits * expected.highest(d, j)) << d << " " << j;
      EXPECT_EQ(driven.peaks(d, j), expected.peaks(d, j)) << d << " " << j;
    }
  }
  EXPECT_GE(compared, most_are_proven * static_cast<double>(count));
}

TEST(DrivenPeaks, AreTheSameOnEveryInstructionSetToNineDigits) {
  const numerics::DrivenDesigns designs = driven_designs(21, {.seed = 12});
  const numerics::DesignPeaks expected = numerics::driven_peaks(designs);
  for (const std::string& name : numerics::instruction_sets()) {
    numerics::use_instruction_set(name);
    const numerics::DesignPeaks found = numerics::driven_peaks(designs);
    EXPECT_EQ(found.status, expected.status) << name;
    EXPECT_TRUE(((found.highest - expected.highest).abs() <= nine_digits * expected.highest).all()) << name;
    EXPECT_TRUE((found.peaks == expected.peaks).all()) << name;
  }
  numerics::use_instruction_set("");
}

TEST(DrivenPeaks, LeaveDesignsWithUndampedPolesUndecided) {
  numerics::DrivenDesigns designs = driven_designs(3, {.loss = 0, .seed = 13});
  designs.B.row(1) = 0;
  const numerics::DesignPeaks found = numerics::driven_peaks(designs);
  EXPECT_EQ(found.status[0], numerics::DesignStatus::proven);
  EXPECT_EQ(found.status[1], numerics::DesignStatus::undecided);
  EXPECT_EQ(found.status[2], numerics::DesignStatus::proven);
}

/// Two oscillators with k = 100 and 100 (1 + apart), without coupling, and the difference of their motions.
numerics::DrivenDesigns two_oscillators(double apart) {
  const auto row = [](std::initializer_list<double> numbers) {
    Eigen::ArrayXXd result(1, std::ssize(numbers));
    std::ranges::copy(numbers, result.data());
    return result;
  };
  numerics::DrivenDesigns designs{row({1, 0, 1}), row({0.8, 0, 0.8}), row({100, 0, 100 * (1 + apart)}), {}, {}, {}};
  designs.loads = {{{0, row({1, 1}), row({0.5, 0.5})}}};
  designs.curves = {{0, {{0, row({1, -1}), row({0, 0})}}, row({0}), row({0})}};
  return designs;
}

/// Residues of both poles cancel in every term. Heights have nine digits, or the design is left undecided.
TEST(DrivenPeaks, OfADifferenceOfNearlyEqualMotionsHaveTheirDigits) {
  int proven = 0;
  for (int power = 1; power <= 16; ++power) {
    const numerics::DrivenDesigns designs = two_oscillators(std::pow(10.0, -power));
    const numerics::DesignPeaks found = numerics::driven_peaks(designs);
    if (found.status[0] != numerics::DesignStatus::proven) continue;
    ++proven;
    const double k_2 = designs.K(0, 2);
    const auto exact = [&](double omega) {
      const std::complex<long double> damping(0, 0.8L * omega);
      const long double square = static_cast<long double>(omega) * omega;
      return static_cast<double>(std::abs(std::complex<long double>(1, 0.5L) * (k_2 - 100.0L) /
                                          ((100 - square + damping) * (k_2 - square + damping))));
    };
    const double there = exact(found.highest_at(0, 0));
    EXPECT_NEAR(found.highest(0, 0), there, nine_digits * there) << power;
    EXPECT_GE(found.highest(0, 0), (1 - nine_digits) * exact(std::sqrt(100 - 0.32))) << power;
  }
  EXPECT_GE(proven, 2);
}

TEST(DrivenPeaks, OfAConstantAreThatConstant) {
  numerics::DrivenDesigns designs = two_oscillators(0.5);
  designs.curves[0].rows.clear();
  designs.curves[0].constant_re(0, 0) = 3;
  designs.curves[0].constant_im(0, 0) = -4;
  const numerics::DesignPeaks found = numerics::driven_peaks(designs);
  EXPECT_EQ(found.status[0], numerics::DesignStatus::proven);
  EXPECT_DOUBLE_EQ(found.highest(0, 0), 5);
  EXPECT_EQ(found.peaks(0, 0), 0);
}

TEST(DrivenPeaks, WithoutALoadAreZero) {
  numerics::DrivenDesigns designs = two_oscillators(0.5);
  designs.loads[0].clear();
  const numerics::DesignPeaks found = numerics::driven_peaks(designs);
  EXPECT_EQ(found.status[0], numerics::DesignStatus::proven);
  EXPECT_EQ(found.highest(0, 0), 0);
  EXPECT_EQ(found.peaks(0, 0), 0);
}

TEST(DrivenPeaks, OfWrongNumbersAreUndecided) {
  numerics::DrivenDesigns growing = two_oscillators(0.5), undefined = growing;
  growing.D = Eigen::ArrayXXd::Zero(1, 3);
  growing.D(0, 0) = -20;  // feeds more energy than the damper takes
  undefined.loads[0][0].re(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(numerics::driven_peaks(growing).status[0], numerics::DesignStatus::undecided);
  EXPECT_EQ(numerics::driven_peaks(undefined).status[0], numerics::DesignStatus::undecided);
}

TEST(DrivenPeaks, RejectPowersThatGrowWithoutBound) {
  for (const int power : {-1, 3}) {
    const numerics::DrivenDesigns designs = driven_designs(1, {.row_powers = {power}});
    EXPECT_THROW(static_cast<void>(numerics::driven_peaks(designs)), foundation::InvalidInput) << power;
    EXPECT_THROW(static_cast<void>(numerics::driven_peaks(designs, in_band)), foundation::InvalidInput) << power;
  }
  const numerics::DrivenDesigns faster = driven_designs(1, {.load_powers = {2}, .row_powers = {3}});
  EXPECT_THROW(static_cast<void>(numerics::driven_peaks(faster, highest_in_band)), foundation::InvalidInput);
}

}  // namespace driven_peaks_test
}  // namespace trivet
