// SPDX-License-Identifier: BSD-3-Clause
// A flexible foundation moves rigidly with the ground in the directions in which it does not flex.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "support/machine_on_deck.h"
#include "support/projects.h"
#include "trivet/assembly/assembled.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/response/machinery/power.h"
#include "trivet/response/sensitivity/model_parameters.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/analyses/analysis_results.h"

namespace fixed_directions_test {

using namespace trivet;
using Complex = std::complex<double>;

constexpr double stiff = 1e13;  // [N/m, N m/rad]; the mounts have 4e6
/// Stiffness of the mounts over `stiff`, times 100 for resonances with 2 % damping and for the sum over three mounts.
constexpr double nearly_rigid = 1e-4;

const std::string along_z =
    "[foundations.deck]\ntype = \"impedance\"\nmass = 60\nfree = [\"z\"]\ntranslation = [5e6, 6e6, 3e6]\n"
    "damping = {matrix = [[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,900,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]}\n";
/// The same deck in all six directions, five of them nearly rigid.
std::string all_directions(double stiff) {
  return fmt::format(
      "[foundations.deck]\ntype = \"impedance\"\nmass = 60\ntranslation = [{0}, {0}, 3e6]\nrotation = [{0}, {0}, {0}]\n"
      "damping = {{matrix = "
      "[[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,900,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]}}\n",
      stiff);
}
/// The first moves in x, y, z but does not turn; the rotational springs of the second are nearly rigid.
const std::string without_rotation =
    "[foundations.deck]\ntype = \"impedance\"\ntranslation = [5e6, 6e6, 3e6]\ndamping = {proportional = 0.001}\n";
const std::string stiff_rotation = fmt::format(
    "[foundations.deck]\ntype = \"impedance\"\ntranslation = [5e6, 6e6, 3e6]\nrotation = [{0}, {0}, {0}]\ndamping = "
    "{{proportional = 0.001}}\n",
    stiff);

study::CaseResults results_of(const std::string& text) {
  const project::Project project = test::project(text);
  study::CaseResults result = study::case_results(project.base(), project.base().analyses);
  EXPECT_THAT(result.failures, testing::IsEmpty()) << text;
  return result;
}

/// Numbers of one result, with their unit.
struct Numbers {
  std::string name, unit;
  Eigen::VectorXcd values;
};

std::vector<Numbers> all_numbers(const study::CaseResults& a) {
  std::vector<Numbers> all;
  const auto one = [](double value) -> Eigen::VectorXcd { return Eigen::VectorXcd::Constant(1, value); };
  if (a.response)
    for (const auto& curve : a.response->curves.curves)
      all.push_back({"response " + curve.name, curve.unit, curve.value});
  if (const auto& passed = a.transmissibility)
    for (const auto& peak : passed->peaks.list)
      if (peak.angular_frequency < 400)  // the poles of a stiff deck are beyond
        all.push_back({"transmissibility of " + passed->peaks.curves[peak.curve].name, "1", one(peak.amplitude)});
  if (const auto& random = a.random)
    for (const auto& result : random->response.channels)
      all.push_back({"random " + result.name, result.unit, one(result.rms.value_or(-1))});
  if (const auto& in_time = a.transient)
    for (const auto& curve : in_time->response.curves)
      all.push_back({"transient " + curve.name, curve.unit, curve.values.cast<Complex>()});
  if (const auto& shaken = a.earthquake)
    for (const auto& result : shaken->channels)
      all.push_back({"earthquake " + result.name, result.unit, one(result.complete_quadratic)});
  return all;
}

/// Compares all numbers of two models, relative to the largest of the same analysis and unit.
void expect_same(const std::string& a, const std::string& b, double tolerance) {
  const std::vector<Numbers> first = all_numbers(results_of(a)), second = all_numbers(results_of(b));
  ASSERT_EQ(first.size(), second.size());
  ASSERT_FALSE(first.empty());
  for (std::size_t i = 0; i < first.size(); ++i) {
    double largest = 0;
    for (const Numbers& other : second)
      if (other.unit == second[i].unit && other.name.substr(0, 6) == second[i].name.substr(0, 6))
        largest = std::max(largest, other.values.cwiseAbs().maxCoeff());
    ASSERT_EQ(first[i].values.size(), second[i].values.size()) << second[i].name;
    EXPECT_GT(largest, 0) << second[i].name;
    EXPECT_LT((first[i].values - second[i].values).cwiseAbs().maxCoeff(), tolerance * largest) << first[i].name;
  }
}

std::string base(const std::string& name, const std::string& motion) {
  return "[excitations." + name + "]\ntype = \"base\"\n" + motion + "\n";
}

const std::string of_all = "of = [\"machine\", \"ground\", \"m1\", \"m2.deflection\", \"m3.foot\"]";
const std::string response = "[analyses]\nresponse = {at = [3, 20, 60, 95, 150, 400], " + of_all + "}\n";

TEST(FixedDirections, AreThoseOfAVeryStiffDeckWhenTheFloorMoves) {
  for (const char* motion :
       {"translation = [1e-3, 0, 0]", "translation = [0, 1e-3, 0]", "translation = [0, 0, 1e-3]",
        "rotation = [1e-3, 0, 0]", "rotation = [0, 2e-3, 1e-3]", "translation = [1, 2, 3]\nquantity = \"velocity\"",
        "translation = [3, 2, 1]\nquantity = \"acceleration\""})
    expect_same(test::machine_on_deck(along_z, base("floor", motion) + response),
                test::machine_on_deck(all_directions(stiff), base("floor", motion) + response), nearly_rigid);
}

TEST(FixedDirections, DeckWithoutRotationFollowsATurningFloor) {
  for (const char* motion :
       {"rotation = [1e-3, 0, 0]", "rotation = [0, 1e-3, 0]", "rotation = [0, 0, 1e-3]\nat = [0.4, 0.3, 0]"})
    expect_same(test::machine_on_deck(without_rotation, base("floor", motion) + response),
                test::machine_on_deck(stiff_rotation, base("floor", motion) + response), nearly_rigid);
}

TEST(FixedDirections, FollowWavesAndSingleSupports) {
  for (const char* motion : {"translation = [1e-3, 0, 2e-3]\nwave = {direction = \"x\", speed = 40}",
                             "translation = [1e-3, 2e-3, 0]\nelements = [\"m2\"]"})
    expect_same(test::machine_on_deck(along_z, base("floor", motion) + response),
                test::machine_on_deck(all_directions(stiff), base("floor", motion) + response), nearly_rigid);
}

TEST(FixedDirections, AreFollowedInEveryAnalysis) {
  const std::string rest = base("floor", "translation = [1e-3, 5e-4, 0]\nrotation = [0, 0, 1e-4]") +
      "[excitations.shake]\ntype = \"random\"\nbase = true\nquantity = \"acceleration\"\ntranslation = [1, 0.5, "
      "0]\npsd = [[1, 0.1], [40, 0.1]]\n"
      "[excitations.shock]\ntype = \"time\"\nbase = true\nquantity = \"acceleration\"\ntranslation = [1, 0, "
      "0.2]\nhistory = {half_sine = {amplitude = \"5 g\", duration = \"11 ms\"}}\n"
      "[analyses]\nrandom = {" +
      of_all + "}\ntransient = {" + of_all +
      ", to = \"0.2 s\", step = \"2 ms\"}\n"
      "transmissibility = {base = \"x\", of = [\"machine\"]}\nearthquake = {of = [\"machine\", \"m1.deflection\"], "
      "direction = \"x\", rows = [[0.01, 3.0], [0.5, 3.0], [2, 0.75]], damping = 0.05}\n";
  // Integrals over the poles lose digits by the ratio of the stiffest pole to the motion. So the stiffness is 1e10 N/m,
  // and the tolerance 4e6 over it, times 10.
  constexpr double less_stiff = 1e10, less_rigid = 4e-3;
  expect_same(test::machine_on_deck(along_z, rest), test::machine_on_deck(all_directions(less_stiff), rest),
              less_rigid);
}

TEST(FixedDirections, MobilityAgreesWithTheImpedanceAtItsRows) {
  const foundation::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "mobility_along_z.csv";
  std::string rows = "response = {at = [";
  {
    std::ofstream csv(file);
    csv.precision(17);
    csv << "frequency_hz,y_z_z,y_z_z_im\n";
    for (int i = 0; i <= 60; ++i) {
      const double f = 0.5 * std::pow(1.1, i), w = 2 * std::numbers::pi * f;
      const Complex y = Complex(0, w) / Complex(3e6, 900 * w);
      csv << f << "," << y.real() << "," << y.imag() << "\n";
      if (i % 6 == 0) rows += fmt::format("{}{:.17g}", i ? ", " : "", w);
    }
  }
  constexpr double rounded_rows =
      1e-7;  // frequencies in Hz and rad/s, 17 digits; the table is interpolated within one rounding of a row
  const std::string measured = "[foundations.deck]\ntype = \"mobility\"\nfile = \"" + file.string() + "\"\n";
  std::string massless = along_z;  // a mobility acts relative to the rigid ground, a mass relative to space
  massless.replace(massless.find("mass = 60\n"), 10, "");
  for (const char* motion :
       {"translation = [1e-3, 2e-3, 0]", "translation = [0, 0, 1e-3]", "rotation = [1e-3, 1e-3, 2e-3]"}) {
    const std::string rest = base("floor", motion) + "[analyses]\n" + rows + "], " + of_all + "}\n";
    expect_same(test::machine_on_deck(measured, rest), test::machine_on_deck(massless, rest), rounded_rows);
  }
  std::filesystem::remove(file);
}

/// A random foundation: kind, directions, rotation, damping.
std::string random_foundation(std::mt19937& draw) {
  std::uniform_real_distribution<double> uniform(0, 1);
  if (uniform(draw) < 0.1) return "";
  const bool turns = uniform(draw) < 0.5;
  std::string free;
  for (const char* name : {"x", "y", "z", "rx", "ry", "rz"})
    if ((turns || name[0] != 'r') && uniform(draw) < 0.5)
      free += fmt::format("{}\"{}\"", free.empty() ? "" : ", ", name);
  if (free.empty()) free = "\"z\"";
  std::string text = fmt::format(
      "[foundations.deck]\ntype = \"impedance\"\nmass = {:.3f}\nfree = [{}]\ntranslation = [5e6, 6e6, 3e6]\n",
      80 * uniform(draw), free);
  if (turns) text += "rotation = [1e5, 2e5, 3e5]\ninertia = [1, 2, 3]\n";
  return text + (uniform(draw) < 0.5 ? "damping = {loss_factor = 0.1}\n" : "damping = {proportional = 0.002}\n");
}

TEST(FixedDirections, LetASlowGroundCarryEveryMachineWithIt) {
  std::mt19937 draw(20);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double slow = 0.05;  // rad/s; the lowest natural frequencies are above 20 rad/s
  constexpr double square_ratio =
      1e-4;  // (slow / 20)², times levers of about a metre and damping: what remains between ground and machine
  for (int i = 0; i < 60; ++i) {
    const auto three = [&] {
      return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", uniform(draw), uniform(draw), uniform(draw));
    };
    const std::string place = three(), translation = three(), rotation = three();
    const std::string raft = i % 2
        ? "[bodies.raft]\nmass = 90\ninertia = {about = \"center_of_mass\", xx = 5, yy = 6, zz = 8}\nposition = [0.3, "
          "0, 2]\n[elements.top]\ntype = \"bushing\"\non = \"raft\"\n"
          "from = \"machine\"\nat = [0, 0, 0]\ntranslation = [3e5, 4e5, 5e5]\nrotation = [2e4, 3e4, 4e4]\n"
        : "";
    const std::string system_damping = i % 3 == 0 ? "[damping]\nmodal = 0.03\n"
        : i % 3 == 1                              ? "[damping]\nrayleigh = {mass = 0.5, stiffness = 1e-4}\n"
                                                  : "";
    const std::string text = test::machine_on_deck(
        random_foundation(draw),
        raft + system_damping +
            base("floor", "at = " + place + "\ntranslation = " + translation + "\nrotation = " + rotation) +
            fmt::format("[analyses]\nresponse = {{at = [{}], of = [\"coordinates\"]}}\n", slow));
    const project::Project project = test::project(text);
    const model::System& system = project.base().system;
    const study::CaseResults found = study::case_results(project.base(), project.base().analyses);
    const model::Action& action = system.description().excitations.at(0).action;
    for (std::size_t b = 0; b < system.bodies().size(); ++b) {
      const spatial::Pose& pose = system.bodies()[b].pose;
      const spatial::Vector6 rigid = spatial::both_blocks(pose.rotation).transpose() *
          spatial::rigid_motion(pose.position - action.at) * action.amplitude.real();
      for (std::size_t j = 0; j < 6; ++j)
        EXPECT_NEAR(std::abs(found.response->curves.curves[6 * b + j].value(0) - rigid(to_index(j))), 0, square_ratio)
            << text;
    }
    EXPECT_TRUE(found.response->deep.passed) << text;
  }
}

TEST(FixedDirections, AreIncludedInTheBalanceOfPower) {
  constexpr double round_off =
      1e-9;  // of the largest part; sums over 12 ends and 4 kinds of dissipation, condition up to 1e4
  for (const std::string& deck : {along_z, without_rotation}) {
    const std::string text = test::machine_on_deck(
        deck,
        "[damping]\nmodal = 0.02\n" + base("floor", "translation = [1e-3, 5e-4, 2e-4]\nrotation = [1e-4, 2e-4, 3e-4]") +
            "[analyses]\npower = {band = [5, 300]}\n");
    const auto all = results_of(text);
    const response::PowerFlow& flow = *all.power;
    for (Eigen::Index i = 0; i < flow.by_ground.size(); ++i) {
      const double lost =
          flow.dissipated.col(i).sum() + flow.dissipated_by_foundations(i) + flow.dissipated_by_system(i);
      EXPECT_GT(flow.by_ground(i), 0);
      EXPECT_NEAR(flow.by_ground(i), lost, round_off * flow.dissipated.col(i).cwiseAbs().maxCoeff())
          << flow.angular_frequency[i];
    }
  }
}

TEST(FixedDirections, MoveWithTheElementAboveThem) {
  const project::Project project =
      test::project(test::machine_on_deck(along_z, base("floor", "rotation = [1e-3, 0, 2e-3]") + response));
  const model::System& system = project.base().system;
  for (const response::Parameter& parameter : response::model_parameters(system)) {
    if (parameter.name != "elements.m2.moved.x") continue;
    const model::System moved = response::changed(system, parameter, 0.1);
    const auto named = [&](const std::string& name) {
      return *std::ranges::find(moved.elements(), name, &model::Element::name);
    };
    EXPECT_EQ(named("m2").n.at, named("m2.foundation").n.at);
    EXPECT_EQ(named("m2").n.at, named("m2.foundation").k.at);
    EXPECT_EQ(named("m1").n.at, named("m1.foundation").n.at);
    EXPECT_NE(named("m2").n.at, system.elements()[1].n.at);
    return;
  }
  FAIL() << "no parameter moves m2";
}

TEST(FixedDirections, AreFoundByTheSecondSolverIfTheFastAssemblyLosesThem) {
  const project::Project project =
      test::project(test::machine_on_deck(along_z, base("floor", "translation = [1e-3, 0, 0]") + response));
  const model::System& system = project.base().system;
  const assembly::Assembled whole = assembly::assemble(system);
  assembly::Assembled lost = whole;
  for (assembly::ElementMap& map : lost.elements) {
    const std::string& name = system.elements()[&map - lost.elements.data()].name;
    if (!name.ends_with(".foundation")) map.ground_ends.setZero();
  }
  lost.ground.K.setZero();
  lost.ground.B.setZero();
  for (const assembly::ElementMap& map : lost.elements) {
    lost.ground.K(map.rows, map.ground_rows) += map.ends.transpose() * map.matrices.stiffness * map.ground_ends;
    lost.ground.B(map.rows, map.ground_rows) += map.ends.transpose() * map.matrices.damping * map.ground_ends;
  }
  const std::vector<double> frequencies = {1, 20, 60};
  EXPECT_TRUE(response::deep_check(system, whole, assembly::harmonic_loading(system, whole), frequencies).passed);
  EXPECT_FALSE(response::deep_check(system, lost, assembly::harmonic_loading(system, lost), frequencies).passed);
}

}  // namespace fixed_directions_test
