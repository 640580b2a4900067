// SPDX-License-Identifier: BSD-3-Clause
// Chains of masses against published numbers. Sources: EDF code_aster test cases sdld02a (SFM VPCS SDLD02), sdld21a
// (SDLD21), sdld313a; numbers from their reference values. The second pair of columns is a separate solution of the
// same matrices with all digits. ISO 7626-1 / ISO 2041 for the names of frequency response functions.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/index.h"

namespace reference_chains_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double turn = 2 * std::numbers::pi;
constexpr double all_digits = 1e-10;  // the tolerance stated with the full-digit columns

std::string force_on(const std::string& body, double amplitude) {
  return fmt::format("[excitations.f]\ntype = \"harmonic\"\non = \"{}\"\nat = [0, 0, 0]\nforce = [{}, 0, 0]\n", body,
                     amplitude);
}

std::string response_at(const std::vector<double>& hertz) {
  std::string list;
  for (const double f : hertz) list += (list.empty() ? "\"" : ", \"") + fmt::format("{} Hz\"", f);
  return "[analyses]\nresponse = {at = [" + list + "]}\n";
}

TEST(Sdld02, EightMassesBetweenWallsInAnyDirection) {
  constexpr double published_digits = 1e-4, shape_digits = 5e-5;  // at least five, and four decimals
  const double published[] = {5.5274, 10.8868, 15.9155, 20.4606, 24.384, 27.5664, 29.9113, 31.3474};
  const double first_shape[] = {0.3473, 0.6527, 0.8794, 1, 1, 0.8794, 0.6527, 0.3473};
  for (const char* orientation : {"", "{axis = \"z\", angle = \"53.13010235415598 deg\"}"}) {
    const auto project =
        test::project(test::chain(std::vector<double>(8, 10), std::vector<double>(9, 1e5), {}, {}, orientation));
    const modal::Modes modes = modal::modes(project.base().system);
    ASSERT_EQ(modes.list.size(), 8u);
    for (int j = 0; j < 8; ++j) {
      const double hertz = *modes.list[j].angular_frequency / turn;
      EXPECT_THAT(hertz, RelativelyNear(published[j], published_digits));
      EXPECT_THAT(
          hertz,
          RelativelyNear(std::sqrt(4 * 1e5 / 10) * std::sin((j + 1) * std::numbers::pi / 18) / turn, all_digits));
    }
    const Eigen::VectorXd shape = modes.list[0].shape / modes.list[0].shape.cwiseAbs().maxCoeff();
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(std::abs(shape(6 * i)), first_shape[i], shape_digits);
  }
}

TEST(Sdld21, HarmonicResponseOfTheDampedChain) {
  constexpr double published_digits = 1e-3;  // five are printed, the fifth is not always right
  const double table[][5] = {{5.0, 0.00010237, -8.5187e-06, 0.00010236955849989415, -8.518743998377353e-06},
                             {5.5, 0.00045066, -0.00077914, 0.0004506615611661645, -0.000779143533608017},
                             {6.0, -9.4101e-05, -1.0585e-05, -9.410096437827899e-05, -1.0585181923057974e-05},
                             {6.5, -4.139e-05, -2.6083e-06, -4.139045746522362e-05, -2.608285025594079e-06},
                             {7.0, -2.4232e-05, -1.2233e-06, -2.4232158605910125e-05, -1.2232557196559595e-06},
                             {7.5, -1.5691e-05, -7.6742e-07, -1.5691407766221355e-05, -7.674215344698697e-07},
                             {8.0, -1.0509e-05, -5.8171e-07, -1.050879498176634e-05, -5.817113477704934e-07},
                             {8.5, -6.9343e-06, -5.1279e-07, -6.934304780466494e-06, -5.12793206953995e-07},
                             {9.0, -4.1841e-06, -5.2213e-07, -4.184146832477805e-06, -5.221348887690452e-07},
                             {9.5, -1.7756e-06, -6.3356e-07, -1.7756121703676634e-06, -6.33556275197276e-07},
                             {10.0, 8.4143e-07, -1.0335e-06, 8.414278892359875e-07, -1.0334675916654596e-06},
                             {10.5, 5.188e-06, -3.4375e-06, 5.1879834268774795e-06, -3.4374522624420995e-06},
                             {11.0, -7.3293e-06, -1.2167e-05, -7.329269355916961e-06, -1.2167122223379843e-05},
                             {11.5, -3.5611e-06, -1.81e-06, -3.5611103291340203e-06, -1.8099689912692933e-06},
                             {12.0, -7.0575e-07, -9.6206e-07, -7.057515496623617e-07, -9.620632906661845e-07},
                             {12.5, 1.1006e-06, -8.4775e-07, 1.100571046887809e-06, -8.477502905251606e-07},
                             {13.0, 2.6424e-06, -9.3448e-07, 2.64239572653513e-06, -9.344789296341002e-07},
                             {13.5, 4.2248e-06, -1.1788e-06, 4.224753034744224e-06, -1.1788419800024796e-06},
                             {14.0, 6.104e-06, -1.6754e-06, 6.103951619395178e-06, -1.675365714914684e-06},
                             {14.5, 8.6698e-06, -2.756e-06, 8.669794054792142e-06, -2.7560393163059295e-06},
                             {15.0, 1.2656e-05, -5.6652e-06, 1.2655559924250183e-05, -5.665169536086701e-06},
                             {15.5, 1.7523e-05, -1.6501e-05, 1.7522857413985984e-05, -1.6501442138051055e-05},
                             {16.0, -5.8499e-06, -3.2134e-05, -5.849863631571667e-06, -3.2133965986209634e-05},
                             {16.5, -1.3739e-05, -1.0894e-05, -1.3739435046146108e-05, -1.0894332060743847e-05},
                             {17.0, -8.5635e-06, -4.4699e-06, -8.563548065424738e-06, -4.469873517964607e-06},
                             {17.5, -5.1696e-06, -2.6411e-06, -5.169556363516671e-06, -2.6410644458054026e-06},
                             {18.0, -2.8605e-06, -2.0415e-06, -2.8605309528485754e-06, -2.041478626182059e-06},
                             {18.5, -1.0326e-06, -1.9803e-06, -1.0326305471004334e-06, -1.9803309314308187e-06},
                             {19.0, 6.3986e-07, -2.3905e-06, 6.398552730076832e-07, -2.3904931870512516e-06},
                             {19.5, 2.274e-06, -3.6314e-06, 2.2739870583942634e-06, -3.6314064364728635e-06},
                             {20.0, 2.9784e-06, -6.697e-06, 2.978443811666368e-06, -6.697001445843255e-06},
                             {20.5, -1.0531e-06, -9.4323e-06, -1.0530756148019161e-06, -9.432269107305959e-06},
                             {21.0, -4.0342e-06, -5.9997e-06, -4.034203092465184e-06, -5.999696379281055e-06},
                             {21.5, -3.0492e-06, -3.4873e-06, -3.0491664028501943e-06, -3.487325369638751e-06},
                             {22.0, -1.6224e-06, -2.6025e-06, -1.622353570530548e-06, -2.602539552197326e-06},
                             {22.5, -3.3364e-07, -2.4806e-06, -3.336406706022546e-07, -2.4805656398046745e-06},
                             {23.0, 8.2095e-07, -2.8986e-06, 8.209522335264853e-07, -2.898558010644515e-06},
                             {23.5, 1.7038e-06, -3.9788e-06, 1.70375062818611e-06, -3.978820476190457e-06},
                             {24.0, 1.5551e-06, -5.7273e-06, 1.555099921243727e-06, -5.727270818492757e-06},
                             {24.5, -2.5261e-07, -6.4755e-06, -2.5261264966437914e-07, -6.47548524772458e-06},
                             {25.0, -1.2536e-06, -5.2703e-06, -1.2536277863725238e-06, -5.270336394340656e-06},
                             {25.5, -7.1495e-07, -4.3407e-06, -7.149489770772672e-07, -4.340685535368131e-06},
                             {26.0, 2.3372e-07, -4.3608e-06, 2.3371958167738836e-07, -4.36083545587667e-06},
                             {26.5, 9.5923e-07, -5.252e-06, 9.592344019940127e-07, -5.251953209026933e-06},
                             {27.0, 7.9298e-07, -6.8122e-06, 7.929813096998641e-07, -6.812212829505217e-06},
                             {27.5, -8.4714e-07, -7.9347e-06, -8.47140316577267e-07, -7.934678236458492e-06},
                             {28.0, -2.6974e-06, -7.2919e-06, -2.69737850992105e-06, -7.291921724562835e-06},
                             {28.5, -3.1996e-06, -5.9399e-06, -3.1995619287104906e-06, -5.939947345316345e-06},
                             {29.0, -2.8147e-06, -5.1537e-06, -2.8147376335327794e-06, -5.15372333138858e-06},
                             {29.5, -2.3147e-06, -5.0768e-06, -2.3146506552233248e-06, -5.076789565868594e-06},
                             {30.0, -2.0904e-06, -5.4821e-06, -2.090422249218071e-06, -5.482051523698107e-06},
                             {30.5, -2.3394e-06, -6.1528e-06, -2.339433275604245e-06, -6.1527594882399545e-06},
                             {31.0, -3.2913e-06, -6.7391e-06, -3.2913298812931687e-06, -6.739149133851446e-06},
                             {31.5, -4.7525e-06, -6.564e-06, -4.7524812093604334e-06, -6.564040561245338e-06},
                             {32.0, -5.8693e-06, -5.4894e-06, -5.869326702392781e-06, -5.489363401787054e-06},
                             {32.5, -6.223e-06, -4.1705e-06, -6.222997493866643e-06, -4.1704624150620476e-06},
                             {33.0, -6.0632e-06, -3.0851e-06, -6.063175044480321e-06, -3.085078773296645e-06},
                             {33.5, -5.698e-06, -2.3075e-06, -5.6979523811592755e-06, -2.3074560666880423e-06},
                             {34.0, -5.2887e-06, -1.7678e-06, -5.288679516401609e-06, -1.7678252642522443e-06},
                             {34.5, -4.898e-06, -1.3899e-06, -4.897965911675615e-06, -1.3898870297680855e-06},
                             {35.0, -4.5447e-06, -1.119e-06, -4.544735342487638e-06, -1.1190376252626088e-06},
                             {35.5, -4.2313e-06, -9.1982e-07, -4.2313004729435105e-06, -9.198189327671621e-07},
                             {36.0, -3.9544e-06, -7.6957e-07, -3.954384225812324e-06, -7.695744218843029e-07},
                             {36.5, -3.7093e-06, -6.5366e-07, -3.709301671395005e-06, -6.536609729342757e-07},
                             {37.0, -3.4915e-06, -5.6241e-07, -3.491451761278416e-06, -5.624127089959832e-07},
                             {37.5, -3.2968e-06, -4.893e-07, -3.2967802357285427e-06, -4.892953727436315e-07},
                             {38.0, -3.1219e-06, -4.2979e-07, -3.1218606393531646e-06, -4.297858707414129e-07},
                             {38.5, -2.9638e-06, -3.8068e-07, -2.963843899052551e-06, -3.806824038563431e-07},
                             {39.0, -2.8204e-06, -3.3967e-07, -2.8203722787821686e-06, -3.396711522892596e-07},
                             {39.5, -2.6895e-06, -3.0505e-07, -2.6894928407611943e-06, -3.050481219300354e-07},
                             {40.0, -2.5696e-06, -2.7554e-07, -2.569581759000028e-06, -2.755366730965716e-07}};
  std::vector<double> hertz;
  for (const auto& row : table) hertz.push_back(row[0]);
  const auto project =
      test::project(test::chain(std::vector<double>(8, 10), std::vector<double>(9, 1e5), std::vector<double>(9, 50)) +
                    force_on("m4", 1) + response_at(hertz));
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    const auto found = test::value(*results.response, "m4.x", to_index(i));
    const std::complex<double> published(table[i][1], table[i][2]), exact(table[i][3], table[i][4]);
    EXPECT_LE(std::abs(found - published), published_digits * std::abs(published)) << hertz[i] << " Hz";
    EXPECT_LE(std::abs(found - exact), all_digits * std::abs(exact)) << hertz[i] << " Hz";
  }
  EXPECT_TRUE(results.response->deep.passed);
}

TEST(Sdld313, HystereticDampingWithItsComplexStaticLimit) {
  constexpr double published_digits = 5e-3;  // up to 4e-4 from the full-digit columns, at the resonances
  const double table[][5] = {{0.0, 0.0071075, -0.0003536, 0.007107496463932108, -0.0003536067892503536},
                             {3.3687, 0.009388216, -0.000731196, 0.009388264989958294, -0.0007312061000107269},
                             {6.4848, -0.0050269, -0.0707103, -0.0050349198344059945, -0.07070858105241574},
                             {8.0006, -0.00954931, -0.0022154, -0.009549005352513726, -0.002215345828218972},
                             {11.8746, -4.23259e-05, -0.000357193, -4.226673440826753e-05, -0.0003571932544381706},
                             {13.4747, 0.00235524, -0.000501765, 0.0023552527130122508, -0.0005017668584653009},
                             {15.5802, -0.016395374, -0.06871471, -0.016420641488151342, -0.06870404785416065},
                             {21.0543, -0.00188977, -5.53314e-06, -0.0018897660707218574, -5.532862910904277e-06}};
  std::vector<double> hertz;
  for (const auto& row : table) hertz.push_back(row[0]);
  const auto project =
      test::project(test::chain({10, 5}, {28000, 28000}, {}, {0.1, 0}) + force_on("m2", 100) + response_at(hertz));
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    const auto found = test::value(*results.response, "m2.x", to_index(i));
    const std::complex<double> published(table[i][1], table[i][2]), exact(table[i][3], table[i][4]);
    EXPECT_LE(std::abs(found - published), published_digits * std::abs(published)) << hertz[i] << " Hz";
    EXPECT_LE(std::abs(found - exact), all_digits * std::abs(exact)) << hertz[i] << " Hz";
  }
}

TEST(Iso7626, ReceptanceMobilityAndAccelerance) {
  constexpr double round_off = 1e-12;  // one division, and a unit of the frequency
  // f, receptance, mobility, accelerance (re, im each) of k = 4e5 N/m, c = 150 N s/m, m = 12 kg, e^{+iωt}.
  const double table[][7] = {{5.0, 2.575900948838204e-06, -3.127256154792939e-08, 9.82456496179096e-07,
                              8.092431497245079e-05, -0.0025423123341423793, 3.0864781108678174e-05},
                             {20.0, 4.712724563448724e-06, -4.220011776564761e-07, 5.303023198127306e-05,
                              0.000592218434676907, -0.07442036334805673, 0.0066639754884211975},
                             {29.0, 2.1130454036346348e-06, -3.6464897787898774e-05, 0.006644355590253198,
                              0.0003850230191720944, -0.0701559583326528, 1.210683805190308},
                             {60.0, -7.645744243658831e-07, -3.311890985513565e-08, 1.248553486749561e-05,
                              -0.00028823776736526036, 0.10866307829301908, 0.00470693575390361}};
  const char* quantity[] = {"displacement", "velocity", "acceleration"};
  for (int kind = 0; kind < 3; ++kind)
    for (const auto& row : table) {
      const auto project = test::project(
          test::chain({12}, {4e5}, {150}) + force_on("m1", 1) +
          fmt::format("[analyses]\nresponse = {{at = [\"{} Hz\"], quantity = \"{}\"}}\n", row[0], quantity[kind]));
      const auto found = test::value(*study::case_results(project.base(), project.base().analyses).response, "m1.x", 0);
      const std::complex<double> expected(row[1 + 2 * kind], row[2 + 2 * kind]);
      EXPECT_LE(std::abs(found - expected), round_off * std::abs(expected))
          << quantity[kind] << " at " << row[0] << " Hz";
    }
}

/// A cantilever of rigid bodies joined by bushings that bend: EI = rotational stiffness × pitch.
std::string cantilever(int bodies, double pitch, double mass, double rotational_stiffness) {
  std::string text = "trivet = 1\n[element_types.joint]\ntype = \"bushing\"\ntranslation = [2e5, 2e5, 2e5]\n" +
      fmt::format("rotation = [{0}, {0}, {0}]\n", rotational_stiffness);
  for (int i = 0; i < bodies; ++i)
    text += fmt::format(
        "[bodies.b{0}]\nmass = {1}\nfree = [\"y\", \"rz\"]\nposition = [{2}, 0, 0]\n"
        "inertia = {{about = \"center_of_mass\", xx = 1, yy = 1, zz = 1}}\n"
        "[elements.e{0}]\ntype = \"joint\"\non = \"b{0}\"\nfrom = \"{3}\"\nat = [{4}, 0, 0]\nfrom_at = [{5}, 0, 0]\n",
        i, mass, pitch * i, i == 0 ? "ground" : fmt::format("b{}", i - 1), -pitch / 2, (i == 0 ? -1 : 1) * pitch / 2);
  return text;
}

TEST(LongCantilever, HasNoRigidBodyModeHoweverSlow) {
  constexpr double continuous = 0.005;  // 300 bodies in the place of a beam
  const int bodies = 300;
  const double pitch = 0.5, mass = 20, rotational_stiffness = 2e2, length = bodies * pitch;
  const auto project = test::project(cantilever(bodies, pitch, mass, rotational_stiffness));
  const modal::Modes modes = modal::modes(project.base().system);
  const double bending = std::sqrt(rotational_stiffness * pitch / (mass / pitch)) / (length * length);
  const double roots[] = {1.875104, 4.694091, 7.854757};  // of cos β cosh β = −1
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_THAT(*modes.list[i].angular_frequency, RelativelyNear(roots[i] * roots[i] * bending, continuous));
}

}  // namespace reference_chains_test
