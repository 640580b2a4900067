// SPDX-License-Identifier: BSD-3-Clause
// Viscoelastic laws against a tabulated generalised Maxwell model, the causality relation and the three-parameter
// isolator.
#include <gmock/gmock.h>

#include <numbers>

#include "support/matchers.h"
#include "trivet/elements/viscoelastic.h"

namespace viscoelastic_reference_test {

using namespace trivet;
using namespace trivet::elements;
using Complex = std::complex<double>;

TEST(GeneralizedMaxwell, AgreesWithTheTableOfItsFourierQuadrature) {
  // k∞ = 1e6 N/m with branches 4e5, 2.5e5, 1.5e5 N/m of 1, 10, 100 ms; closed form confirmed by quadrature of the
  // relaxation kernel.
  constexpr double stiffness = 1e6, round_off = 1e-12;  // three branches, some ten operations each
  const double table[][3] = {{0.1, 1000599.8747673123, 11209.778370342487},
                             {1, 1043455.3500931204, 85730.95597960457},
                             {10, 1218628.0485011279, 160936.686570523},
                             {100, 1507003.1632901318, 221383.39096426277},
                             {1000, 1790054.5011305395, 66305.83623585789}};
  const GeneralizedMaxwell law{{0.4, 0.25, 0.15}, {0.001, 0.01, 0.1}};
  for (const auto& [hertz, storage, loss] : table) {
    const Complex k = stiffness * relative_modulus(law, 2 * std::numbers::pi * hertz);
    EXPECT_THAT(k.real(), test::RelativelyNear(storage, round_off));
    EXPECT_THAT(k.imag(), test::RelativelyNear(loss, round_off));
  }
}

/// m'(w) − m'(0) = (2w²/π) ⨍ m''(x)/(x(w² − x²)) dx, from the loss modulus alone. With x = w e^y the principal value at
/// y = 0 is a symmetric midpoint sum of −(2/π) m''(w e^y)/(e^{2y} − 1).
double storage_from_loss(const Viscoelastic& law, double w) {
  constexpr double step = 0.01, reach = 120;
  double sum = 0;
  for (double y = step / 2; y < reach; y += step)
    for (const double z : {y, -y}) sum += relative_modulus(law, w * std::exp(z)).imag() / std::expm1(2 * z);
  return -2 / std::numbers::pi * step * sum;
}

TEST(RelativeModulus, ObeysTheKramersKronigRelation) {
  constexpr double quadrature = 1e-6;  // steps and end of the sum above
  for (const Viscoelastic& law :
       {Viscoelastic(Zener{0.7, 0.02}), Viscoelastic(GeneralizedMaxwell{{0.4, 0.25}, {1e-3, 0.1}}),
        Viscoelastic(FractionalZener{1.5, 2e-3, 0.4})})
    for (const double w : {1.0, 60.0, 4000.0})
      EXPECT_NEAR(storage_from_loss(law, w), relative_modulus(law, w).real() - 1, quadrature)
          << law_description(law) << " at " << w;
}

TEST(Zener, IsTheThreeParameterIsolatorOfRuzicka) {
  // Ruzicka 1967: k parallel to N k in series with c, ζ = c/(2√(km)). The optimal peak transmissibility is 1 + 2/N.
  constexpr double all_digits = 1e-9;  // of the table, and some ten operations
  const double table[][4] = {{1, 0.30618621784789724, 1.1547005383792515, 3},
                             {3, 0.5929270612815711, 1.2649110640673518, 1.6666666666666665},
                             {5, 0.7795119555779044, 1.3093073414159542, 1.4}};
  for (const auto& [n, damping_ratio, at, height] : table) {
    const auto transmissibility = [n = n, damping_ratio = damping_ratio](double r) {
      const Complex k = relative_modulus(Zener{n, 2 * damping_ratio / n}, r);  // mass 1, stiffness 1
      return std::abs(k / (k - r * r));
    };
    EXPECT_THAT(transmissibility(at), test::RelativelyNear(height, all_digits));
    EXPECT_LT(transmissibility(at * 1.01), height);
    EXPECT_LT(transmissibility(at / 1.01), height);
  }
}

}  // namespace viscoelastic_reference_test
