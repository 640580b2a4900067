// SPDX-License-Identifier: BSD-3-Clause
// Models with nodes, compared with the same models in which the node is condensed into one 12×12 element, and with
// models in which it is a body whose mass tends to zero.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/suspension.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/explain/explanation.h"

namespace nodes_test {

using namespace trivet;
using test::NearVector;
using test::RelativelyNear;

constexpr double round_off = 1e-9;      // solves of up to 24 coordinates with skew stiffnesses
constexpr double of_integrals = 1e-6;   // relative error that the random response aims at, and of the time steps
constexpr double of_small_mass = 1e-7;  // remainder of second order after extrapolation from 1e-3 and 5e-4 kg

constexpr double own_peaks = 1000;  // [rad/s] below those of a dummy body

study::CaseResults results_of(const std::string& text) {
  const project::Project project = test::project(text);
  study::CaseResults found = study::case_results(project.base(), project.base().analyses);
  EXPECT_TRUE(found.failures.empty()) << found.failures.front();
  return found;
}

const std::string machines = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.machine]
mass = 90
center_of_mass = [0.02, -0.03, 0.1]
inertia = {about = "center_of_mass", xx = 4, yy = 6, zz = 5, xy = 0.3}
position = [0.1, 0.2, 0.9]
[bodies.raft]
mass = 60
inertia = {about = "center_of_mass", xx = 3, yy = 4, zz = 6}
position = [0, 0, 0.3]
)";

/// The same without what forces at rest add to the stiffness: a condensed element has no node that turns them.
const std::string first_order = "second_order = false\n" + machines;

/// A raft on the ground, and loads of every kind.
std::string rest(const std::string& damping) {
  return R"([elements.foot]
type = "bushing"
on = "raft"
at = [0.1, 0, -0.1]
translation = [4e5, 5e5, 7e5]
rotation = [3e4, 4e4, 2e4]
damping = )" +
      damping + R"(
[excitations.push]
type = "harmonic"
on = "machine"
at = [0.1, 0.2, 0.1]
force = [3, -4, 10]
moment = [0, 1, 0]
[excitations.shake]
type = "base"
quantity = "acceleration"
translation = [0.2, 0, 0.5]
[excitations.noise]
type = "random"
on = "raft"
at = [0.2, 0.1, 0]
force = [0.3, 0, 1]
psd = {flat = 2, band = ["1 Hz", "60 Hz"]}
[excitations.blow]
type = "time"
on = "machine"
at = [0, 0, 0.1]
force = [0, 0, 1]
history = {half_sine = {amplitude = "800 N", duration = "20 ms", start = "5 ms"}}
)";
}

std::string analyses(bool in_time) {
  return std::string(
             "[analyses]\nmodes = {}\nroots = {}\nstatic = {of = [\"machine\", \"raft\", \"ground\"]}\n"
             "response = {at = [0.5, 20, 60, 150, 700], of = [\"machine\", \"raft\", \"ground\", "
             "\"machine.relative\"]}\n"
             "peaks = {of = [\"machine.z\", \"raft.x\"]}\n"
             "random = {of = [\"machine.z\", \"raft.rx\"]}\n") +
      (in_time ? "transient = {of = [\"machine.z\", \"raft.rx\"], to = 0.2, step = 1e-3}\n" : "");
}

/// Between the raft and the node, and between the node and the machine.
std::string skew_pair(const std::string& from, const std::string& on, const std::string& damping) {
  const std::string more = "rotation = [3e3, 5e3, 2e3]\ndamping = " + damping + "\n";
  return "[elements.below]\ntype = \"bushing\"\non = \"" + on + "\"\nat = [0.01, 0.02, 0]\nfrom = \"" + from +
      "\"\nfrom_at = [0.05, 0, 0.1]\naxis = [1, 2, 3]\ntranslation = [2e5, 3e5, 6e5]\n" + more +
      "[elements.above]\ntype = \"bushing\"\non = \"machine\"\nat = [0, 0.1, -0.1]\nfrom = \"" + on +
      "\"\nfrom_at = [0, 0, 0.03]\naxis = [-1, 0.4, 1]\ntranslation = [5e5, 2e5, 4e5]\n" + more;
}

const std::string node =
    "[nodes.joint]\nposition = [0.05, 0.1, 0.6]\norientation = {axis = [1, 1, 0], angle = \"20 "
    "deg\"}\n";

std::string dummy(double mass) {
  return fmt::format(
      "[bodies.joint]\nmass = {0}\ninertia = {{about = \"pole\", xx = {1}, yy = {1}, zz = {1}}}\n"
      "position = [0.05, 0.1, 0.6]\norientation = {{axis = [1, 1, 0], angle = \"20 deg\"}}\n",
      mass, 0.01 * mass);
}

/// One matrix element in place of the two bushings: the stiffness after condensation of the node, about the poles of
/// raft and machine.
std::string condensed(const std::string& damping) {
  const project::Project project = test::project(machines + node + skew_pair("raft", "joint", "{proportional = 0}"));
  const Eigen::MatrixXd K = assembly::assemble(project.base().system).matrices.K;  // machine, raft, joint
  const Eigen::MatrixXd held = K.bottomRightCorner(6, 6), across = K.bottomLeftCorner(6, 12);
  const Eigen::MatrixXd ends = K.topLeftCorner(12, 12) - across.transpose() * held.fullPivLu().solve(across);
  const auto row_of = [](Eigen::Index i) { return (i + 6) % 12; };  // N is the raft
  std::string rows;
  for (Eigen::Index i = 0; i < 12; ++i) {
    rows += i ? ", [" : "[";
    for (Eigen::Index j = 0; j < 12; ++j)
      rows += fmt::format("{}{:.17g}", j ? ", " : "", 0.5 * (ends(row_of(i), row_of(j)) + ends(row_of(j), row_of(i))));
    rows += "]";
  }
  return "[elements.pair]\ntype = \"matrix\"\non = \"machine\"\nat = [0, 0, 0]\nfrom = \"raft\"\nfrom_at = [0, 0, "
         "0]\nstiffness = [" +
      rows + "]\ndamping = " + damping + "\n";
}

/// Results as one list of numbers per analysis.
struct Numbers {
  std::vector<std::pair<std::string, Eigen::VectorXcd>> lists;

  explicit Numbers(const study::CaseResults& found) {
    const auto add = [&](const std::string& name, const std::vector<std::complex<double>>& values) {
      lists.emplace_back(name, Eigen::Map<const Eigen::VectorXcd>(values.data(), to_index(values.size())));
    };
    std::vector<std::complex<double>> modes, roots, peaks;
    for (const modal::Mode& mode : found.modes.list) modes.emplace_back(mode.angular_frequency.value_or(-1));
    for (const modal::Root& root : found.roots.list) roots.push_back(root.eigenvalue);
    for (const response::Peak& peak : found.peaks->peaks.list)
      if (peak.angular_frequency < own_peaks)
        peaks.insert(peaks.end(), {peak.angular_frequency / 100, peak.amplitude * 1e4});
    add("modes", modes), add("roots", roots), add("peaks", peaks);
    for (const char* unit : {"m", "rad", "N", "N m"}) {  // the smallest of them are round-off of the largest
      std::vector<std::complex<double>> values;
      for (const response::StaticValue& value : found.statics->values)
        if (value.unit == unit) values.emplace_back(value.value);
      add(std::string("static [") + unit + "]", values);
    }
    for (const auto& curve : found.response->curves.curves) lists.emplace_back("response " + curve.name, curve.value);
    for (const auto& result : found.random->response.channels) add("rms " + result.name, {result.rms.value_or(-1)});
    if (const auto& transient = found.transient)
      for (const auto& curve : transient->response.curves)
        lists.emplace_back("transient " + curve.name, curve.values.cast<std::complex<double>>());
  }

  [[nodiscard]] Eigen::VectorXcd of(const std::string& name) const {
    for (const auto& [known, values] : lists)
      if (known == name) return values;
    return {};
  }
};

double tolerance_of(const std::string& name, double of_the_rest) {
  return name.starts_with("rms") || name.starts_with("transient") ? std::max(of_integrals, of_the_rest) : of_the_rest;
}

TEST(Nodes, AreCondensedExactlyIntoOneElement) {
  for (const bool lossy : {false, true}) {
    const std::string damping = lossy ? "{loss_factor = 0.08}" : "{proportional = 0}",
                      common = rest(lossy ? "{loss_factor = 0.1}" : "{proportional = 0.004}") + analyses(!lossy);
    const Numbers with_node(results_of(first_order + node + skew_pair("raft", "joint", damping) + common)),
        one_element(results_of(first_order + condensed(damping) + common));
    ASSERT_GT(one_element.lists.size(), 30u);
    for (const auto& [name, expected] : one_element.lists) {
      const Eigen::VectorXcd found = with_node.of(name);
      ASSERT_EQ(found.size(), expected.size()) << name;
      EXPECT_LT((found - expected).cwiseAbs().maxCoeff(),
                tolerance_of(name, round_off) * expected.cwiseAbs().maxCoeff())
          << name;
    }
  }
}

/// Without a constant matrix: (1) dampers in all directions of the node, (2) one skew damper, (3) a fractional law in
/// all elements on the node.
TEST(Nodes, AreTheLimitOfBodiesWhoseMassTendsToZero) {
  const std::string skew_damper =
      "[elements.dashpot]\ntype = \"damper\"\non = \"joint\"\nat = [0.02, 0, 0]\nfrom_at = [0.3, 0.2, "
      "0.1]\ncoefficient = 900\n";
  for (const int kind : {1, 2, 3}) {
    const std::string pair = kind == 1 ? "{proportional = 0.003}"
        : kind == 2                    ? "{proportional = 0}"
                                       : "{fractional_zener = {ratio = 2, time = \"1 ms\", order = 0.5}}",
                      common = (kind == 2 ? skew_damper : "") + rest("{proportional = 0.004}") + analyses(kind != 3);
    const Numbers with_node(results_of(machines + node + skew_pair("raft", "joint", pair) + common)),
        small(results_of(machines + dummy(1e-3) + skew_pair("raft", "joint", pair) + common)),
        smaller(results_of(machines + dummy(5e-4) + skew_pair("raft", "joint", pair) + common));
    int compared = 0;
    for (const auto& [name, found] : with_node.lists) {
      if (name == "modes" || name == "roots") continue;  // a dummy body has modes of its own
      ASSERT_EQ(small.of(name).size(), found.size()) << name;
      const Eigen::VectorXcd limit = 2 * smaller.of(name) - small.of(name);
      EXPECT_LT((found - limit).cwiseAbs().maxCoeff(), tolerance_of(name, of_small_mass) * limit.cwiseAbs().maxCoeff())
          << name << " " << kind;
      ++compared;
    }
    EXPECT_GT(compared, 30);
    const Eigen::VectorXcd modes = with_node.of("modes");
    ASSERT_EQ(modes.size(), 12);
    const Eigen::VectorXcd limit = 2 * smaller.of("modes").head(12) - small.of("modes").head(12);
    EXPECT_LT((modes - limit).cwiseAbs().maxCoeff(), of_small_mass * limit.cwiseAbs().maxCoeff());
  }
}

/// A force on the node, its own motion, and a node directly on the moving ground.
TEST(Nodes, CarryForcesAndMoveWithTheGround) {
  const auto model = [](const std::string& joint) {
    return machines + joint + skew_pair("raft", "joint", "{loss_factor = 0.05}") + R"([elements.foot]
type = "bushing"
on = "raft"
at = [0.1, 0, -0.1]
translation = [4e5, 5e5, 7e5]
rotation = [3e4, 4e4, 2e4]
[elements.prop]
type = "bushing"
on = "joint"
at = [0, 0, 0]
translation = [1e5, 1e5, 2e5]
damping = {translation = [20, 20, 30]}
[excitations.push]
type = "harmonic"
on = "joint"
at = [0.1, 0, 0]
force = [3, -4, 10]
[excitations.shake]
type = "base"
quantity = "acceleration"
translation = [0.2, 0, 0.5]
[analyses]
response = {at = [0.01, 20, 60, 150], of = ["machine", "joint", "joint.relative", "prop", "ground", "above"]}
)";
  };
  const study::CaseResults found = results_of(model(node)), small = results_of(model(dummy(1e-3))),
                           smaller = results_of(model(dummy(5e-4)));
  for (const auto& curve : found.response->curves.curves)
    for (Eigen::Index i = 0; i < 4; ++i) {
      const std::complex<double> a = test::value(*small.response, curve.name, i),
                                 b = test::value(*smaller.response, curve.name, i);
      EXPECT_LT(std::abs(curve.value(i) - (2.0 * b - a)), of_small_mass * curve.value.cwiseAbs().maxCoeff() + 1e-300)
          << curve.name << " " << i;
    }
}

/// The suspension of a machine on nodes contains the elements behind them.
TEST(Nodes, SuspensionSeesThroughThem) {
  const std::string damping = "{proportional = 0}";
  const auto suspension = [](const std::string& text) {
    const project::Project project = test::project(text);
    const model::System& system = project.base().system;
    return modal::body_suspension(system, assembly::assemble(system), 0, modal::body_axes());
  };
  const modal::BodySuspension with_node =
                                  suspension(first_order + node + skew_pair("raft", "joint", damping) + rest(damping)),
                              one_element = suspension(first_order + condensed(damping) + rest(damping));
  const Eigen::VectorXd scale = one_element.stiffness.diagonal().cwiseSqrt();
  EXPECT_THAT(with_node.stiffness, test::NearInUnits(one_element.stiffness, scale, round_off));
  ASSERT_EQ(with_node.modes.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_THAT(*with_node.modes[i].angular_frequency,
                RelativelyNear(*one_element.modes[i].angular_frequency, round_off));
}

}  // namespace nodes_test
