// SPDX-License-Identifier: BSD-3-Clause
// Machines on the measured mobility of several ground points, compared with the ground modelled by bodies and nodes.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>

#include "support/projects.h"
#include "trivet/assembly/loads.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/response/machinery/power.h"

namespace mobility_of_points_test {

using namespace trivet;
using Complex = std::complex<double>;
using exchange::UniversalFunction;
using exchange::UniversalQuantity;

/// Inverses of mobilities of nine directions, with condition numbers up to 1e4.
constexpr double round_off = 1e-9;
constexpr double first_hz = 5, step_hz = 2.5;
constexpr int lines = 39;

double frequency(int line) { return foundation::two_pi * (first_hz + step_hz * line); }

/// One driven direction of a node: x, y, z, or a rotation about them.
struct Direction {
  int node = 0, axis = 0;
};

/// Mobility [(m/s)/N] of two directions at an angular frequency.
using Mobility = std::function<Complex(const Direction&, const Direction&, double)>;

/// A file with one function per pair, in turn as receptance, mobility and accelerance, and along positive and negative
/// directions; the couplings between different nodes both ways.
/// @param lines_before  further lines, which are not to be used: down to 0 Hz, where a mobility is not known
std::filesystem::path written(const std::string& name, const std::vector<Direction>& directions, const Mobility& y,
                              int lines_before = 0) {
  exchange::UniversalFile file;
  int form = 0;
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = 0; j < directions.size(); ++j) {
      if (j > i && directions[i].node == directions[j].node) continue;
      const int power = form++ % 3 - 1;  // of iω in motion over velocity
      const int sign = form % 2 == 0 ? 1 : -1;
      UniversalFunction function;
      function.type = exchange::UniversalFunctionType::frequency_response;
      function.response = {"", directions[i].node, sign * (directions[i].axis + 1)};
      function.reference = {"", directions[j].node, directions[j].axis + 1};
      function.abscissa_axis.quantity = UniversalQuantity::frequency;
      function.numerator.quantity = power < 0 ? UniversalQuantity::displacement
          : power == 0                        ? UniversalQuantity::velocity
                                              : UniversalQuantity::acceleration;
      function.denominator.quantity = UniversalQuantity::excitation_force;
      function.abscissa = exchange::EvenAbscissa{first_hz - lines_before * step_hz, step_hz};
      for (int line = -lines_before; line < lines; ++line) {
        const double w = frequency(line);
        if (w == 0) {
          function.values.emplace_back(7, -7);
          continue;
        }
        function.values.push_back(double(sign) * std::pow(Complex(0, w), power) * y(directions[i], directions[j], w));
      }
      file.functions.push_back(function);
    }
  static const foundation::TemporaryFolder folder;  // until the process ends
  const std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary) << exchange::universal_text(file, exchange::FunctionForm::binary);
  return path;
}

struct Foot {
  std::string name;
  Eigen::Vector3d at;
};
const std::vector<Foot> feet = {{"a", {0.5, 0.4, -0.2}}, {"b", {-0.5, -0.4, -0.2}}, {"c", {0.5, -0.4, -0.2}}};

std::vector<Direction> directions(const std::vector<int>& axes) {
  std::vector<Direction> result;
  for (std::size_t foot = 0; foot < feet.size(); ++foot)
    for (const int axis : axes) result.push_back({11 + static_cast<int>(foot), axis});
  return result;
}

std::string machine(const std::string& excitation) {
  return R"(trivet = 1
[bodies.machine]
mass = 400
inertia = {about = "center_of_mass", xx = 30, yy = 50, zz = 60, xy = 3}
center_of_mass = [0.02, 0.01, 0.3]
)" + excitation +
      R"([analyses]
response = {at = ["5 Hz", "12.5 Hz", "40 Hz", "77.5 Hz", "100 Hz"], of = ["machine", "a", "b"]}
)";
}

const std::string push =
    "[excitations.push]\ntype = \"harmonic\"\non = \"machine\"\nat = [0.1, 0.2, 0.3]\nforce = [10, 20, 100]\n";

const std::string three_springs = "type = \"three_springs\"\ntranslation = [2e6, 2.5e6, 4e6]\n";
const std::string bushing = "type = \"bushing\"\ntranslation = [2e6, 2.5e6, 4e6]\nrotation = [4e4, 5e4, 6e4]\n";

std::string mounts(const std::function<std::string(const Foot&)>& stands, const std::string& kind = three_springs) {
  std::string text;
  for (const Foot& foot : feet)
    text += fmt::format("[elements.{}]\n{}on = \"machine\"\nat = [{}, {}, {}]\ndamping = {{proportional = 0.002}}\n{}",
                        foot.name, kind, foot.at.x(), foot.at.y(), foot.at.z(), stands(foot));
  return text;
}

std::string on_node(const Foot& foot) { return "from = \"under_" + foot.name + "\"\nfrom_at = [0, 0, 0]\n"; }

std::string on_measured_points(const std::string& excitation, const std::filesystem::path& file,
                               const std::string& kind = three_springs) {
  return machine(excitation) + mounts([](const Foot&) { return "foundation = \"deck\"\n"; }, kind) +
      "[foundations.deck]\ntype = \"mobility\"\nnodes = {\"11\" = \"a\", \"12\" = \"b\", \"13\" = \"c\"}\nfile = \"" +
      file.string() + "\"\n";
}

void expect_same(const std::string& measured, const std::string& modelled) {
  const project::Project one = test::project(measured), other = test::project(modelled);
  const study::CaseResults found = study::case_results(one.base(), one.base().analyses),
                           expected = study::case_results(other.base(), other.base().analyses);
  ASSERT_TRUE(found.response && expected.response);
  ASSERT_EQ(found.response->curves.curves.size(), expected.response->curves.curves.size());
  for (std::size_t i = 0; i < found.response->curves.curves.size(); ++i) {
    const auto &curve = found.response->curves.curves[i], &wanted = expected.response->curves.curves[i];
    ASSERT_EQ(curve.name, wanted.name);
    const double size = wanted.value.cwiseAbs().maxCoeff();
    EXPECT_LT((curve.value - wanted.value).cwiseAbs().maxCoeff(), round_off * (size > 0 ? size : 1)) << curve.name;
  }
  EXPECT_TRUE(found.response->deep.passed);
}

/// A rigid deck on one bushing, with a soft place under each mount.
struct Deck {
  double mass = 1500, place = 2e7, place_loss = 0.1, loss = 0.04;
  double turning = 0;  ///< stiffness of a place in rotation [N m/rad]; 0: it is a ball joint
  Eigen::Vector3d inertia{200, 300, 400}, centre{0.1, -0.05, -0.6};
  Eigen::Vector<double, 6> stiffness{2e6, 3e6, 5e6, 1e6, 8e5, 6e5};

  [[nodiscard]] Complex mobility(const Direction& one, const Direction& other, double w) const {
    Eigen::Vector<double, 6> masses;
    masses << Eigen::Vector3d::Constant(mass), inertia;
    Complex receptance = 0;
    const auto motion = [&](const Direction& direction) {
      Eigen::Vector<double, 6> t;
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(direction.axis % 3);
      if (direction.axis < 3) t << axis, (feet[direction.node - 11].at - centre).cross(axis);
      else t << Eigen::Vector3d::Zero(), axis;
      return t;
    };
    const Eigen::Vector<double, 6> t = motion(one), u = motion(other);
    for (int j = 0; j < 6; ++j) receptance += t(j) * u(j) / (stiffness(j) * Complex(1, loss) - w * w * masses(j));
    if (one.node == other.node && one.axis == other.axis)
      receptance += 1.0 / ((one.axis < 3 ? place : turning) * Complex(1, place_loss));
    return Complex(0, w) * receptance;
  }

  [[nodiscard]] std::string parts() const {
    std::string text = fmt::format(
        "[bodies.deck]\nmass = {}\ninertia = {{about = \"center_of_mass\", xx = {}, yy = {}, zz = {}}}\n"
        "center_of_mass = [0, 0, 0]\nposition = [{}, {}, {}]\n"
        "[elements.under]\ntype = \"bushing\"\non = \"deck\"\nat = [0, 0, 0]\ntranslation = [{}, {}, {}]\n"
        "rotation = [{}, {}, {}]\ndamping = {{loss_factor = {}}}\n",
        mass, inertia.x(), inertia.y(), inertia.z(), centre.x(), centre.y(), centre.z(), stiffness(0), stiffness(1),
        stiffness(2), stiffness(3), stiffness(4), stiffness(5), loss);
    for (const Foot& foot : feet) {
      const Eigen::Vector3d on_deck = foot.at - centre;
      text += fmt::format(
          "[nodes.under_{0}]\nposition = [{1}, {2}, {3}]\n[elements.place_{0}]\n"
          "on = \"under_{0}\"\nat = [0, 0, 0]\nfrom = \"deck\"\nfrom_at = [{4}, {5}, {6}]\n"
          "translation = [{7}, {7}, {7}]\ndamping = {{loss_factor = {8}}}\n",
          foot.name, foot.at.x(), foot.at.y(), foot.at.z(), on_deck.x(), on_deck.y(), on_deck.z(), place, place_loss);
      if (turning == 0) text += "type = \"three_springs\"\n";
      else text += fmt::format("type = \"bushing\"\nrotation = [{0}, {0}, {0}]\n", turning);
    }
    return text;
  }
};

TEST(MobilityOfPoints, IsTheDeckUnderTheMounts) {
  const Deck deck;
  const std::filesystem::path file =
      written("trivet_deck.uff", directions({0, 1, 2}),
              [&](const Direction& i, const Direction& j, double w) { return deck.mobility(i, j, w); });
  expect_same(on_measured_points(push, file), machine(push) + mounts(on_node) + deck.parts());
}

Mobility mobility_of(const Deck& deck) {
  return [deck](const Direction& i, const Direction& j, double w) { return deck.mobility(i, j, w); };
}

TEST(MobilityOfPoints, TurnsWithTheDeck) {
  const Deck deck{.turning = 5e5};
  const auto file = written("trivet_turning.uff", directions({0, 1, 2, 3, 4, 5}), mobility_of(deck));
  expect_same(on_measured_points(push, file, bushing), machine(push) + mounts(on_node, bushing) + deck.parts());
}

TEST(MobilityOfPoints, IsReadFromTheFirstLineAbove0Hz) {
  const Deck deck;
  const auto file = written("trivet_zero.uff", directions({0, 1, 2}), mobility_of(deck), 2);
  expect_same(on_measured_points(push, file), machine(push) + mounts(on_node) + deck.parts());
}

TEST(MobilityOfPoints, IsThatOfTheNodeIfItsMountIsMoved) {
  const auto file = written("trivet_moved.uff", directions({0, 1, 2}), mobility_of(Deck{}));
  const std::string text = on_measured_points(push, file), at = "at = [0.5, 0.4, -0.2]\n";
  const auto with = [&](const std::string& place) {
    return std::string(text).replace(text.find(at), at.size(), place);
  };
  expect_same(with(at + "moved = {x = 0.05, y = -0.03, z = 0.02}\n"), with("at = [0.55, 0.37, -0.18]\n"));
}

TEST(MobilityOfPoints, MovesWithAWaveAsPointByPoint) {
  const auto file = written("trivet_wave.uff", directions({0, 1, 2}), mobility_of(Deck{}));
  const std::string motion = "type = \"base\"\ntranslation = [0.001, 0.002, -0.0005]\n";
  std::string points, together;
  for (const Foot& foot : feet) {
    const std::string head = fmt::format("[excitations.under_{0}]\n{1}elements = [\"{0}\"]\n", foot.name, motion);
    points += head + fmt::format("delay = {}\n", 0.03 + foot.at.x() / 20);
    together += head;
  }
  const auto measured = [&](const std::string& excitation) { return on_measured_points(excitation, file); };
  const std::string wave = "[excitations.wave]\n" + motion + "delay = 0.03\nwave = {direction = \"x\", speed = 20}\n";
  expect_same(measured(wave), measured(points));
  expect_same(measured("[excitations.floor]\n" + motion + "at = [0, 0, 0]\n"), measured(together));
}

/// Power flow at three frequencies of the file.
response::PowerFlow power(const std::string& text) {
  const project::Project project = test::project(text);
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  return response::power_flow(system, assembled, assembly::harmonic_loading(system, assembled),
                              {frequency(0), frequency(3), frequency(14)});
}

TEST(MobilityOfPoints, AbsorbsThePowerThatTheDeckAbsorbs) {
  const Deck deck;
  const auto file = written("trivet_power.uff", directions({0, 1, 2}), mobility_of(deck));
  const response::PowerFlow found = power(on_measured_points(push, file)),
                            expected = power(machine(push) + mounts(on_node) + deck.parts());
  const auto dissipated = [](const response::PowerFlow& flow, bool in_mounts) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(flow.by_forces.size());
    for (std::size_t e = 0; e < flow.elements.size(); ++e)
      if ((flow.elements[e].size() == 1) == in_mounts) sum += flow.dissipated.row(to_index(e));
    return sum;
  };
  for (Eigen::Index i = 0; i < found.by_forces.size(); ++i) {
    const double size = expected.by_forces(i);
    EXPECT_GT(size, 0);
    EXPECT_NEAR(found.by_forces(i), size, round_off * size);
    EXPECT_NEAR(dissipated(found, true)(i), dissipated(expected, true)(i), round_off * size);
    EXPECT_NEAR(dissipated(found, false)(i), dissipated(expected, false)(i), round_off * size);
    EXPECT_NEAR(found.into_ground_in_total(i), dissipated(found, false)(i), round_off * size);
    EXPECT_NEAR(dissipated(found, true)(i) + dissipated(found, false)(i), size, round_off * size);
  }
}

TEST(MobilityOfPoints, WithoutCouplingsIsAnotherDeck) {
  // The couplings matter here: without them the test above would pass by chance.
  const Deck deck;
  const auto file = [&](const std::string& name, bool coupled) {
    return written(name, directions({2}), [&, coupled](const Direction& i, const Direction& j, double w) {
      return coupled || i.node == j.node ? deck.mobility(i, j, w) : 0;
    });
  };
  const auto z = [](const std::filesystem::path& path) {
    const project::Project project = test::project(on_measured_points(push, path));
    return test::value(*study::case_results(project.base(), project.base().analyses).response, "machine.z", 1);
  };
  const Complex with = z(file("trivet_coupled.uff", true)), without = z(file("trivet_uncoupled.uff", false));
  EXPECT_GT(std::abs(with - without), 0.05 * std::abs(with));
}

TEST(MobilityOfPoints, MovesWithTheGround) {
  // Three nodes on springs to the ground; a spring along y joins two of them, which are apart along y.
  const double k = 3e6, loss = 0.05, between = 4e6;
  const std::filesystem::path file =
      written("trivet_nodes.uff", directions({0, 1, 2}), [&](const Direction& i, const Direction& j, double w) {
        Eigen::Matrix2d joined;  // of a and c along y
        joined << k + between, -between, -between, k + between;
        const Eigen::Matrix2d compliance = joined.inverse();
        const bool i_is_joined = i.axis == 1 && i.node != 12, j_is_joined = j.axis == 1 && j.node != 12;
        double receptance = i.node == j.node && i.axis == j.axis ? 1 / k : 0;
        if (i_is_joined && j_is_joined) receptance = compliance(i.node == 11 ? 0 : 1, j.node == 11 ? 0 : 1);
        return Complex(0, w) * receptance / Complex(1, loss);
      });
  std::string nodes;
  for (const Foot& foot : feet)
    nodes += fmt::format(
        "[nodes.under_{0}]\nposition = [{1}, {2}, {3}]\n[elements.place_{0}]\ntype = \"three_springs\"\n"
        "on = \"under_{0}\"\nat = [0, 0, 0]\ntranslation = [{4}, {4}, {4}]\ndamping = {{loss_factor = {5}}}\n",
        foot.name, foot.at.x(), foot.at.y(), foot.at.z(), k, loss);
  nodes += fmt::format(
      "[elements.between]\ntype = \"three_springs\"\non = \"under_a\"\nat = [0, 0, 0]\nfrom = \"under_c\"\n"
      "from_at = [0, 0, 0]\ntranslation = [0, {}, 0]\ndamping = {{loss_factor = {}}}\n",
      between, loss);
  const std::string shake =
      "[excitations.shake]\ntype = \"base\"\ntranslation = [0.001, 0.002, -0.0005]\nrotation = [0.0001, 0, 0.0002]\n"
      "at = [0.2, 0.1, 0]\n";
  expect_same(on_measured_points(shake, file), machine(shake) + mounts(on_node) + nodes);
}

}  // namespace mobility_of_points_test
