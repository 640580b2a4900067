// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/passive_sections.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace mobility_causality_test {

using namespace trivet::identification;
using Complex = std::complex<double>;
using Ground = std::function<Complex(Complex)>;

MobilityVerdict causality_verdict(const Ground& mobility, const std::function<Complex(Complex, double)>& measured,
                                  int rows = 80) {
  std::vector<double> frequencies;
  Eigen::VectorXcd values(rows);
  for (int i = 0; i < rows; ++i) {
    const double w = 2 * std::numbers::pi * 5 * std::pow(40.0, static_cast<double>(i) / (rows - 1));
    frequencies.push_back(w);
    values(i) = measured(mobility(Complex(0, w)), w);
  }
  return mobility_causality(frequencies, values);
}

Complex as_it_is(Complex y, double) { return y; }

/// Passive grounds of every kind; the last is damped at one place only, so its modes are complex.
const std::pair<const char*, Ground> grounds[] = {
    {"spring and dashpot", [](Complex s) { return s / (1e8 + 2e5 * s); }},
    {"soil with mass", [](Complex s) { return s / (1e8 + 3e5 * s + 2e3 * s * s); }},
    {"wide plate", [](Complex) { return Complex(1e-4); }},
    {"long beam", [](Complex s) { return 1e-3 / std::sqrt(s); }},
    {"spring and dashpot in series", [](Complex s) { return s / 1e7 + 1 / 2e4; }},
    {"one mode", [](Complex s) { return s / (50.0 * (s * s + 0.2 * 200.0 * s + 200.0 * 200.0)); }},
    {"two modes and a dashpot between", [](Complex s) {
       const Complex inner = 80.0 * s * s + 5e6, link = 2e6 + 1.5e4 * s;
       return s / (60.0 * s * s + 3e3 * s + 4e6 + link * inner / (inner + link));
     }}};

TEST(MobilityCausality, EveryPassiveGroundPasses) {
  for (const auto& [name, ground] : grounds) {
    const MobilityVerdict verdict = causality_verdict(ground, as_it_is);
    EXPECT_TRUE(verdict.passes) << name << ": " << verdict.relative_rms;
  }
}

TEST(MobilityCausality, AConjugateOrReversedMobilityIsDetected) {
  for (const auto& [name, ground] : grounds) {
    if (std::string(name) == "wide plate") continue;  // real, so it equals its conjugate
    EXPECT_FALSE(causality_verdict(ground, [](Complex y, double) { return std::conj(y); }).passes) << name;
  }
  for (const auto& [name, ground] : grounds)
    EXPECT_TRUE(causality_verdict(ground, [](Complex y, double) { return -y; }).refused) << name;
}

TEST(MobilityCausality, ADelayIsDetected) {
  for (const auto& [name, ground] : grounds)
    EXPECT_FALSE(causality_verdict(ground, [](Complex y, double w) { return y * std::polar(1.0, -0.004 * w); }).passes)
        << name;
}

}  // namespace mobility_causality_test
