// SPDX-License-Identifier: BSD-3-Clause
// Every element that computes its 12×12, from a project file: no energy in a rigid motion, and the same vibration for
// any position and rotation of the whole model.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/elements/checks.h"
#include "trivet/modal/modes.h"

namespace real_elements_test {

using namespace trivet;
using test::RelativelyNear;

/// Turning the model changes sums of numbers of 1e5 by round-off, with the largest effect on the lowest ω².
constexpr double turned_round_off = 1e-8;
constexpr double solve_round_off = 1e-9;  // of a condensed stiffness, in one axis or another

struct Named {
  const char* name;
  std::string keys;
};

const std::vector<Named>& laws() {
  static const std::string steel = "material = \"spring_steel\"\n", rubber = "material = {G = \"0.8 MPa\"}\n";
  static const std::string coil =
      "type = \"coil_spring\"\nwire_diameter = \"8 mm\"\nmean_diameter = \"70 mm\"\nactive_coils = 5.3\nfree_length = "
      "\"120 mm\"\n" +
      steel;
  static const std::vector<Named> all = {
      {"coil", coil},
      {"coil_with_mass", coil + "level = \"with_mass\"\n"},
      {"coil_pivoted", coil + "ends = \"pivoted\"\nhand = \"left\"\n"},
      {"rectangular_coil",
       "type = \"coil_spring\"\nwire_width = \"10 mm\"\nwire_height = \"7 mm\"\nmean_diameter = \"80 "
       "mm\"\nactive_coils = 4\nfree_length = \"110 mm\"\ndead_coils = 1\n" +
           steel},
      {"coil_preloaded", coil + "preload = {force = \"300 N\"}\n"},
      {"disc", "type = \"rubber_disc\"\ndiameter = \"60 mm\"\nthickness = \"25 mm\"\n" + rubber},
      {"block", "type = \"rubber_block\"\nwidth_x = \"60 mm\"\nwidth_y = \"40 mm\"\nthickness = \"25 mm\"\n" + rubber},
      {"bush",
       "type = \"rubber_bush\"\ninner_diameter = \"20 mm\"\nouter_diameter = \"50 mm\"\nlength = \"60 mm\"\n" + rubber},
      {"sandwich",
       "type = \"sandwich\"\ndiameter = \"100 mm\"\nthickness = \"12 mm\"\nlayers = 3\nplate_thickness = \"2 mm\"\n" +
           rubber},
      {"solid_disc",
       "type = \"solid_mount\"\nshape = \"disc\"\ndiameter = \"60 mm\"\nthickness = \"25 mm\"\nmesh_level = 1\n" +
           rubber},
      {"solid_disc_preloaded",
       "type = \"solid_mount\"\nshape = \"disc\"\ndiameter = \"60 mm\"\nthickness = \"25 mm\"\nmesh_level = 1\npreload "
       "= {compression = \"2 mm\"}\n" +
           rubber},
      {"beam", "type = \"beam\"\nlength = 0.4\nsection = {tube = [\"40 mm\", \"34 mm\"]}\n" + steel},
      {"link", "type = \"link\"\nlength = 0.3\nstiffness = 2e6\ntension = 50\n"},
      {"catalogue", "type = \"catalogue:disc 50x25 40 ShA\"\n"},
  };
  return all;
}

/// A body at a random position, its element at a random position and rotation on it; `world` moves everything. To first
/// order of its weight: on a single element it may fall over.
std::string model(const Named& law, unsigned seed, const Eigen::Isometry3d& world) {
  test::RandomSystem random(seed);
  const Eigen::Vector3d at = random.vector(0.2), place = world * random.vector(1.0);
  const Eigen::AngleAxisd own(random.rotation()), stands(world.linear() * random.rotation());
  const auto turn = [](const Eigen::AngleAxisd& r) {
    return fmt::format("{{axis = [{:.17g}, {:.17g}, {:.17g}], angle = \"{:.17g} rad\"}}", r.axis().x(), r.axis().y(),
                       r.axis().z(), r.angle());
  };
  const Eigen::Vector3d gravity = world.linear() * Eigen::Vector3d(0.5, 1, -9.7);
  return fmt::format(
      "trivet = 1\nsecond_order = false\ngravity = [{:.17g}, {:.17g}, {:.17g}]\n[bodies.body]\nmass = "
      "30\ncenter_of_mass = [0.02, 0.03, "
      "-0.01]\n"
      "inertia = {{about = \"center_of_mass\", xx = 0.5, yy = 0.6, zz = 0.7}}\nposition = [{:.17g}, {:.17g}, "
      "{:.17g}]\norientation = {}\n"
      "[elements.one]\non = \"body\"\nat = [{:.17g}, {:.17g}, {:.17g}]\norientation = {}\n{}",
      gravity.x(), gravity.y(), gravity.z(), place.x(), place.y(), place.z(), turn(stands), at.x(), at.y(), at.z(),
      turn(own), law.keys);
}

class EveryLaw : public testing::TestWithParam<Named> {};

TEST_P(EveryLaw, ResistsNoRigidMotionInAnyAttitude) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto project = test::project(model(GetParam(), seed, Eigen::Isometry3d::Identity()));
    const auto& system = project.base().system;
    const model::Element& element = system.elements()[0];
    const model::Span span = model::span(system.bodies(), element.n, element.k);
    const Eigen::Matrix<double, 12, 6> turned = element.law.preload
        ? elements::turned_preload(*element.law.preload, span.n_from_k)
        : Eigen::Matrix<double, 12, 6>(Eigen::Matrix<double, 12, 6>::Zero());
    const elements::MatrixVerdict verdict =
        elements::examine(element.law.nominal_stiffness, elements::rigid_motions(span.arm, span.n_from_k), turned);
    EXPECT_LE(verdict.rigid_residual, elements::silent_residual);
    EXPECT_EQ(verdict.asymmetry, 0);
    if (!element.law.preload) {
      EXPECT_TRUE(elements::is_semidefinite(verdict)) << verdict.lowest_eigenvalue;
    }
  }
}

TEST_P(EveryLaw, VibratesAlikeInEveryPlaceAndAttitude) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    test::RandomSystem random(100 + seed);
    Eigen::Isometry3d world = Eigen::Isometry3d::Identity();
    world.linear() = random.rotation();
    world.translation() = random.vector(3.0);
    const auto here = test::project(model(GetParam(), seed, Eigen::Isometry3d::Identity())),
               there = test::project(model(GetParam(), seed, world));
    const auto a = modal::modes(here.base().system), b = modal::modes(there.base().system);
    ASSERT_EQ(a.list.size(), b.list.size());
    const double highest = std::abs(a.list[5].eigenvalue_squared);
    for (std::size_t i = 0; i < a.list.size(); ++i)
      EXPECT_NEAR(a.list[i].eigenvalue_squared, b.list[i].eigenvalue_squared,
                  turned_round_off * std::max(highest, std::abs(a.list[i].eigenvalue_squared)))
          << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::ValuesIn(laws()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(CoilSpring, LeftAndRightHandsAreMirrorImages) {
  const std::string right = laws()[0].keys, left = right + "hand = \"left\"\n";
  const auto stiffness = [](const std::string& keys) {
    return test::project(model({"", keys}, 1, Eigen::Isometry3d::Identity()))
        .base()
        .system.elements()[0]
        .law.nominal_stiffness;
  };
  // Mirrored in the plane of e1 and e3: y, rx and rz change their sign.
  elements::Vector12 mirror;
  mirror << 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1;
  const elements::Matrix12 mirrored = mirror.asDiagonal() * stiffness(right) * mirror.asDiagonal();
  EXPECT_LE((mirrored - stiffness(left)).cwiseAbs().maxCoeff(), solve_round_off * mirrored.cwiseAbs().maxCoeff());
}

/// Axial and torsional stiffness between the ends, from motions without a rigid part.
std::pair<double, double> between_ends(const elements::Matrix12& k) {
  elements::Vector12 stretch = elements::Vector12::Zero(), twist = elements::Vector12::Zero();
  stretch(2) = twist(5) = -0.5;
  stretch(8) = twist(11) = 0.5;
  return {stretch.dot(k * stretch), twist.dot(k * twist)};
}

TEST(RubberElement, StiffensInVibrationAndKeepsItsStaticPreload) {
  const std::string base =
      "type = \"rubber_disc\"\ndiameter = \"60 mm\"\nthickness = \"25 mm\"\nmethod = \"finite_elements\"\nmesh_level = "
      "1\n";
  for (const char* preload : {"", "preload = {force = \"250 N\"}\n"}) {
    const auto law = [&](const char* material) {
      return test::project(model({"", base + preload + material}, 1, Eigen::Isometry3d::Identity()))
          .base()
          .system.elements()[0]
          .law;
    };
    const elements::Law at_rest = law("material = {G = \"0.8 MPa\"}\n"),
                        moving = law("material = {G = \"0.8 MPa\", stiffening = 1.4}\n");
    const auto [axial, torsion] = between_ends(at_rest.nominal_stiffness);
    const auto [axial_moving, torsion_moving] = between_ends(moving.nominal_stiffness);
    EXPECT_THAT(axial_moving, RelativelyNear(1.4 * axial, solve_round_off));
    EXPECT_THAT(torsion_moving, RelativelyNear(1.4 * torsion, solve_round_off));
    ASSERT_EQ(at_rest.preload.has_value(), moving.preload.has_value());
    if (at_rest.preload) {
      EXPECT_EQ(*at_rest.preload, *moving.preload);  // the reader has checked that it turns with a rigid motion
    }
  }
}

TEST(RubberElement, ComputesTheBulkModulusFromPoissonsRatio) {
  constexpr double round_off = 1e-12;  // of two moduli given with all digits
  const auto stiffness = [&](const char* material) {
    const std::string keys =
        std::string("type = \"rubber_disc\"\ndiameter = \"60 mm\"\nthickness = \"5 mm\"\nmaterial = ") + material +
        "\n";
    return test::project(model({"", keys}, 1, Eigen::Isometry3d::Identity()))
        .base()
        .system.elements()[0]
        .law.nominal_stiffness;
  };
  // E = 3 MPa and ν = 0.495: G = E/(2 · 1.495), bulk modulus E/(3 · 0.01).
  const elements::Matrix12 given = stiffness("{G = 1003344.4816053512, bulk_modulus = 1e8}");
  EXPECT_LE((stiffness("{E = 3e6, nu = 0.495}") - given).cwiseAbs().maxCoeff(),
            round_off * given.cwiseAbs().maxCoeff());
  EXPECT_LE((stiffness("{G = 1003344.4816053512, nu = 0.495}") - given).cwiseAbs().maxCoeff(),
            round_off * given.cwiseAbs().maxCoeff());
}

TEST(Preload, IsBalancedAboutTheCentreOfMassToo) {
  const auto warned = [](double offset) {
    std::string text = fmt::format(
        "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.b]\nmass = 60\ncenter_of_mass = [{}, 0, 0]\n"
        "inertia = {{about = \"center_of_mass\", xx = 1, yy = 1, zz = 1}}\n",
        offset);
    for (const char* side : {"-0.2", "0.2"})
      text += fmt::format(
          "[elements.\"at {0}\"]\non = \"b\"\nat = [{0}, 0, 0]\naxis = \"z\"\n{1}preload = {{force = {2:.17g}}}\n",
          side[0] == '-' ? "-0.2" : "0.2", laws()[0].keys, 30 * 9.80665);
    // Names must not contain dots.
    for (std::size_t at; (at = text.find("at -0.2\"")) != std::string::npos;) text.replace(at, 7, "left");
    for (std::size_t at; (at = text.find("at 0.2\"")) != std::string::npos;) text.replace(at, 6, "right");
    const auto project = test::project(text);
    for (const auto& problem : project.base().warnings.list())
      if (problem.finding.find("about its centre of mass remains") != std::string::npos) return true;
    return false;
  };
  EXPECT_FALSE(warned(0));
  EXPECT_TRUE(warned(0.1));
}

TEST(RubberElement, IsPartOfTheModelAlthoughItWarns) {
  // Hardness 25 is outside the range of its formula: a warning, but still a valid mount.
  const Named soft{"",
                   "type = \"rubber_disc\"\ndiameter = \"60 mm\"\nthickness = \"25 mm\"\nmaterial = {hardness = 25}\n"};
  const auto project = test::project(model(soft, 1, Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(project.base().warnings.list().empty());
  ASSERT_EQ(project.base().system.elements().size(), 1u);
}

TEST(SolidMount, IsReadFromTheCacheTheSecondTime) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / fmt::format("trivet-cache-test-{}", ::getpid());
  const char* before = std::getenv("TRIVET_CACHE");
  const std::string old = before ? before : "";
  ::setenv("TRIVET_CACHE", folder.c_str(), 1);
  const auto computed = test::project(model(laws()[9], 1, Eigen::Isometry3d::Identity()));
  ASSERT_TRUE(fs::exists(folder));
  ASSERT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  const auto remembered = test::project(model(laws()[9], 1, Eigen::Isometry3d::Identity()));
  EXPECT_EQ(computed.base().system.elements()[0].law.nominal_stiffness,
            remembered.base().system.elements()[0].law.nominal_stiffness);
  // A damaged cache entry counts as absent.
  std::ofstream(fs::directory_iterator(folder)->path(), std::ios::binary | std::ios::app) << "12345678";
  const auto again = test::project(model(laws()[9], 1, Eigen::Isometry3d::Identity()));
  EXPECT_EQ(computed.base().system.elements()[0].law.nominal_stiffness,
            again.base().system.elements()[0].law.nominal_stiffness);
  if (before) ::setenv("TRIVET_CACHE", old.c_str(), 1);
  else ::unsetenv("TRIVET_CACHE");
  fs::remove_all(folder);
}

}  // namespace real_elements_test
