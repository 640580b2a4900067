// SPDX-License-Identifier: BSD-3-Clause
// Elements with mass, relaxation and frequency dependence: internal coordinates against the condensed dynamic
// stiffness, series from circles against series from poles, exact springs against reduced ones.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/roots.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/exact_response.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace element_dynamics_test {

using namespace trivet;
using test::RelativelyNear;
using Complex = std::complex<double>;

/// Two solutions of well-conditioned systems of some 30 unknowns.
constexpr double solved_twice = 1e-9;
/// Series from circles are truncated at 1e-11 of their largest term; peaks come from them.
constexpr double from_circles = 1e-8;
/// The place of a maximum, whose height is known so well, is known less well.
constexpr double flat_maximum = 1e-6;

/// One skew body on two random elements of the given damping.
model::System skew(unsigned seed, const elements::Viscoelastic& law) {
  test::RandomSystem random(seed);
  model::Description description = random.description(1, test::RandomDamping::none);
  for (model::Element& element : description.elements) element.law.damping = law;
  return test::checked(description);
}

/// The same amplitudes from Z(ω) = Σ T D(ω) Tᵀ − ω²A, without internal coordinates.
Eigen::VectorXcd condensed_response(const model::System& system, const assembly::Assembled& assembled, double omega) {
  const Eigen::Index n = assembled.layout.of_bodies();
  const numerics::DynamicMatrices& m = assembled.matrices;
  Eigen::MatrixXcd z = -omega * omega * m.A.topLeftCorner(n, n).cast<Complex>();
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const assembly::ElementMap& map = assembled.elements[e];
    const Eigen::MatrixXcd ends = map.ends.topLeftCorner(12, map.end_columns).cast<Complex>();
    const Eigen::MatrixXcd local =
        ends.transpose() * elements::dynamic_stiffness(system.elements()[e].law, omega) * ends;
    for (Eigen::Index i = 0; i < map.end_columns; ++i)
      for (Eigen::Index j = 0; j < map.end_columns; ++j) z(map.rows[i], map.rows[j]) += local(i, j);
  }
  const Eigen::VectorXcd load = assembly::harmonic_loading(system, assembled).force.at(0).head(n);
  return numerics::lu_solution(z, load);
}

TEST(RelaxingElements, InternalCoordinatesGiveTheComplexStiffness) {
  const elements::Viscoelastic laws[] = {elements::KelvinVoigt{0.002}, elements::Zener{0.8, 0.01},
                                         elements::GeneralizedMaxwell{{0.4, 0.25, 0.15}, {1e-3, 1e-2, 0.1}}};
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const auto& law : laws) {
      const model::System system = skew(seed, law);
      const assembly::Assembled assembled = assembly::assemble(system);
      for (const double omega : {0.0, 3.0, 40.0, 400.0, 4000.0}) {
        const auto channels =
            assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement);
        const auto fast =
            response::frequency_response(assembled, channels, assembly::harmonic_loading(system, assembled), {omega});
        const Eigen::VectorXcd direct = condensed_response(system, assembled, omega);
        const double size = direct.cwiseAbs().maxCoeff();
        for (Eigen::Index i = 0; i < direct.size(); ++i)
          EXPECT_LE(std::abs(fast.curves[i].value(0) - direct(i)), solved_twice * size)
              << elements::law_description(law) << " at " << omega;
      }
    }
}

TEST(RelaxingElements, ForcesOnTheGroundBalanceTheBody) {
  const model::System system = skew(7, elements::Zener{1.5, 0.02});
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto channels = assembly::channels(system, assembled, {"ground"}, assembly::MotionQuantity::displacement);
  const Eigen::VectorXcd load = assembly::harmonic_loading(system, assembled).force.at(0);
  // Momentum of the body: force on it from its elements + excitation = −ω² m u_C, in ground axes.
  const double omega = 25;
  const auto response = response::frequency_response(assembled, channels, load, {omega});
  const auto q = response::frequency_response(
      assembled, assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement), load,
      {omega});
  Eigen::VectorXcd motion(6);
  for (std::size_t j = 0; j < 6; ++j) motion(to_index(j)) = q.curves[j].value(0);
  const Eigen::VectorXcd inertia = -omega * omega * (assembled.matrices.A.topLeftCorner(6, 6) * motion);
  const Eigen::Matrix3d turn = system.bodies()[0].pose.rotation;
  const Eigen::Vector3cd transmitted = turn * (load.head<3>() - inertia.head<3>());
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_LE(std::abs(response.curves[j].value(0) - transmitted(to_index(j))), solved_twice * transmitted.norm());
}

TEST(RelaxingElements, EveryRootSolvesTheCondensedSystem) {
  const model::System system = skew(3, elements::GeneralizedMaxwell{{0.6, 0.3}, {0.004, 0.05}});
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Roots roots = modal::roots(system, assembled, modal::modes(system, assembled));
  // 12 of the body, and one for each of 2 branches × 6 strains × 2 elements.
  EXPECT_EQ(roots.list.size(), 12u + 24u);
  for (const modal::Root& root : roots.list) {
    if (root.kind != modal::RootKind::oscillating) continue;
    Eigen::MatrixXcd z = root.eigenvalue * root.eigenvalue * assembled.matrices.A.topLeftCorner(6, 6).cast<Complex>();
    for (std::size_t e = 0; e < system.elements().size(); ++e) {
      const assembly::ElementMap& map = assembled.elements[e];
      const Eigen::MatrixXcd ends = map.ends.topLeftCorner(12, 6).cast<Complex>();
      const Eigen::MatrixXcd local = ends.transpose() *
          elements::dynamic_stiffness(system.elements()[e].law, Complex(0, -1) * root.eigenvalue, 0) * ends;
      z += local;
    }
    const Eigen::VectorXd scale = numerics::unit_scale(assembled.matrices).head(6);
    const Eigen::MatrixXcd scaled = scale.asDiagonal() * z * scale.asDiagonal();
    const Eigen::VectorXcd v = root.shape.cwiseQuotient(scale.cast<Complex>()).normalized();
    EXPECT_LE((scaled * v).norm(), solved_twice * scaled.norm())
        << root.eigenvalue.real() << " " << root.eigenvalue.imag();
  }
}

response::Peaks peaks_of(const model::System& system, double to = 0) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  return response::peaks(
      assembled,
      assembly::channels(system, assembled, {"coordinates", "ground"}, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(system, assembled), modes, modal::roots(system, assembled, modes), {1e-6, to});
}

TEST(PeaksFromCircles, AreThoseFromPoles) {
  // A fractional law of order 1 is Zener's, but is computed as a frequency-dependent element.
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const elements::Zener zener{0.7, 0.01 * seed};
    const response::Peaks by_poles = peaks_of(skew(seed, zener));
    const response::Peaks by_circles = peaks_of(skew(seed, elements::FractionalZener{zener.ratio, zener.time, 1}), 1e4);
    EXPECT_TRUE(std::isinf(by_poles.searched_to));
    EXPECT_EQ(by_circles.searched_to, std::max(1e4, by_circles.searched_to));
    ASSERT_EQ(by_circles.list.size(), by_poles.list.size()) << seed;
    for (std::size_t i = 0; i < by_poles.list.size(); ++i) {
      EXPECT_EQ(by_circles.list[i].curve, by_poles.list[i].curve);
      EXPECT_THAT(by_circles.list[i].angular_frequency,
                  RelativelyNear(by_poles.list[i].angular_frequency, flat_maximum))
          << seed;
      EXPECT_THAT(by_circles.list[i].amplitude, RelativelyNear(by_poles.list[i].amplitude, from_circles)) << seed;
    }
  }
}

TEST(FractionalElements, HaveTheRootsOfZenerAtOrderOne) {
  const modal::Roots zener = modal::roots(skew(2, elements::Zener{0.7, 0.02})),
                     fractional = modal::roots(skew(2, elements::FractionalZener{0.7, 0.02, 1}));
  std::vector<Complex> wanted, found;
  for (const auto& root : zener.list)
    if (root.kind == modal::RootKind::oscillating) wanted.push_back(root.eigenvalue);
  for (const auto& root : fractional.list)
    if (root.kind == modal::RootKind::oscillating && root.exact) found.push_back(root.eigenvalue);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_LE(std::abs(found[i] - wanted[i]), solved_twice * std::abs(wanted[i]));
}

/// A heavy machine on three perpendicular coil springs.
std::string on_three_springs(const std::string& level, double mass = 200) {
  std::string text = fmt::format(
      "trivet = 1\n[bodies.machine]\nmass = {}\ncenter_of_mass = [0.01, 0.02, 0.05]\n"
      "inertia = {{about = \"center_of_mass\", xx = {}, yy = {}, zz = {}}}\n",
      mass, 0.06 * mass, 0.07 * mass, 0.08 * mass);
  const char* axes[] = {"-x", "-y", "z"};
  const char* places[] = {"[0.3, 0, 0]", "[0, 0.3, 0]", "[0, 0, -0.3]"};
  for (int i = 0; i < 3; ++i)
    text += fmt::format(
        "[elements.s{}]\ntype = \"coil_spring\"\non = \"machine\"\nat = {}\naxis = \"{}\"\nwire_diameter = \"12 "
        "mm\"\nmean_diameter = \"120 mm\"\n"
        "active_coils = 7.6\nfree_length = \"394 mm\"\nmaterial = \"spring_steel\"\n{}\ndamping = {{loss_factor = "
        "0.02}}\n",
        i, places[i], axes[i], level);
  return text + "[excitations.f]\ntype = \"harmonic\"\non = \"machine\"\nat = [0.1, 0, 0]\nforce = [10, 20, 30]\n";
}

response::FrequencyResponse response_of(const project::Project& project, const std::vector<double>& omega) {
  const auto& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  return response::frequency_response(
      assembled,
      assembly::channels(system, assembled, {"coordinates", "ground"}, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(system, assembled), omega);
}

/// Largest difference of translations, rotations, forces and moments at point i, each over the largest of its three.
double difference(const response::FrequencyResponse& a, const response::FrequencyResponse& b, Eigen::Index i) {
  double worst = 0;
  for (std::size_t first = 0; first < 12; first += 3) {
    double size = 0, apart = 0;
    for (std::size_t c = first; c < first + 3; ++c) {
      size = std::max(size, std::abs(a.curves[c].value(i)));
      apart = std::max(apart, std::abs(a.curves[c].value(i) - b.curves[c].value(i)));
    }
    worst = std::max(worst, apart / size);
  }
  return worst;
}

TEST(ExactSprings, AreTheLimitOfReducedOnes) {
  const double hertz = 2 * std::numbers::pi;
  const std::vector<double> omega = {0, 1 * hertz, 3 * hertz, 8 * hertz, 35 * hertz, 60 * hertz};
  const auto exact = response_of(test::project(on_three_springs("level = \"exact\"")), omega);
  const auto coarse = response_of(test::project(on_three_springs("level = \"with_mass\"\ninternal_modes = 10")), omega);
  const auto fine = response_of(test::project(on_three_springs("level = \"with_mass\"\ninternal_modes = 40")), omega);
  EXPECT_LE(difference(exact, fine, 0), solved_twice);
  constexpr double visible = 1e-8;  // above round-off
  // The truncation error is Σ (ω/ω_k)⁴ over the omitted modes: four times as many modes divide it by more than eight.
  for (Eigen::Index i = 1; i < 6; ++i) {
    EXPECT_LE(difference(exact, fine, i), difference(exact, coarse, i) / 8 + solved_twice) << i;
    EXPECT_GT(difference(exact, coarse, i), visible) << i;
  }
}

TEST(ExactSprings, RootsAreThoseOfTheExactSystem) {
  const auto project = test::project(on_three_springs("level = \"exact\""));
  const auto& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Roots roots = modal::roots(system, assembled, modal::modes(system, assembled));
  constexpr double of_the_loss = 1e-6;  // roots are settled to 1e-12: 1e-10 of this small ratio, with room
  int exact = 0;
  for (const modal::Root& root : roots.list) {
    if (!root.exact) continue;
    ++exact;
    // Every modulus is a real number times (1 + 0.02i), and the masses are real: λ² = −ω²(1 + 0.02 i).
    const Complex square = root.eigenvalue * root.eigenvalue;
    EXPECT_THAT(square.imag() / square.real(), RelativelyNear(0.02, of_the_loss));
  }
  EXPECT_GE(exact, 20);
}

TEST(ExactSprings, PassTheSecondSolver) {
  for (const char* level : {"level = \"exact\"", "level = \"with_mass\""}) {
    const auto project = test::project(on_three_springs(level));
    const response::DeepCheck check = study::deep_check(project.base());
    EXPECT_TRUE(check.passed) << level << " " << check.worst_difference;
    EXPECT_GT(check.frequencies, 40);
  }
}

TEST(ElementMass, WeighsOnTheGround) {
  std::string text = on_three_springs("level = \"with_mass\"");
  text.insert(text.find("[bodies"), "gravity = [0, 0, -9.80665]\n");
  const auto project = test::project(text);
  const auto& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto statics = response::static_response(system, assembled, {"ground"});
  double mass = system.bodies()[0].mass.mass;
  for (const auto& element : system.elements()) {
    Eigen::Matrix<double, 12, 1> rigid = Eigen::Matrix<double, 12, 1>::Zero();
    rigid(2) = rigid(8) = 1;
    mass += rigid.dot(element.law.inertia->mass * rigid);
  }
  EXPECT_THAT(statics.values[2].value, RelativelyNear(-9.80665 * mass, solved_twice));
}

TEST(Preload, ABodyHungOnALinkSwingsAsADoublePendulum) {
  // Point-like body (inertia 0.02 kg m² about its centre) 0.3 m below the joint of a stay of 0.5 m that carries its
  // weight.
  const double m = 4, l = 0.5, c = 0.3, j = 0.02, g = 9.80665;
  const auto project =
      test::project(fmt::format("trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.bob]\nmass = {}\ncenter_of_mass = [0, "
                                "0, {}]\ninertia = {{about = \"center_of_mass\", xx = {}, yy = {}, zz = 0.01}}\n"
                                "free = [\"x\", \"z\", \"ry\"]\n[elements.stay]\ntype = \"link\"\non = \"bob\"\nat = "
                                "[0, 0, 0]\naxis = \"-z\"\nlength = {}\nstiffness = 1e9\ntension = {:.17g}\n",
                                m, -c, j, j, l, m * g));
  const modal::Modes modes = modal::modes(project.base().system);
  // Angles of stay and body: [m l², m l c; m l c, j + m c²] and g diag(m l, m c).
  Eigen::Matrix2d mass, stiffness;
  mass << m * l * l, m * l * c, m * l * c, j + m * c * c;
  stiffness << m * g * l, 0, 0, m * g * c;
  const Eigen::Matrix2d a = mass.inverse() * stiffness;
  const double mean = 0.5 * a.trace(), root = std::sqrt(mean * mean - a.determinant());
  constexpr double extension = 1e-7;  // the stay extends by 4e-8 m
  EXPECT_THAT(modes.list[0].eigenvalue_squared, RelativelyNear(mean - root, extension));
  EXPECT_THAT(modes.list[1].eigenvalue_squared, RelativelyNear(mean + root, extension));
}

}  // namespace element_dynamics_test
