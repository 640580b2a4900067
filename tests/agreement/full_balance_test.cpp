// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/LU>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/branch/steady_branch.h"

/// Condensed harmonic balance against the whole machine: all coordinates with the exact dynamic stiffness, forces of
/// the laws by dense sampling; power; and machines that are turned and moved.
namespace full_balance_test {

using namespace trivet;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// Skew elements of every kind, `more` for what stands on the ground or moves.
std::string machine(const std::string& body, const std::string& laws) {
  return R"(trivet = 1
[bodies.machine]
mass = 40
center_of_mass = [0.03, -0.02, 0.06]
inertia = {about = "center_of_mass", xx = 1.5, yy = 2.2, zz = 2.6, xy = 0.1, xz = -0.07}
)" + body +
      R"(
[elements.skew]
type = "matrix"
on = "machine"
at = [0.3, 0.2, -0.1]
orientation = {axis = [1, 2, 3], angle = 0.5}
stiffness = [[5e4, 2e3, -1e3, 10, -40, 5], [2e3, 6e4, 3e3, 60, 10, -8], [-1e3, 3e3, 9e4, -5, 12, 20], [10, 60, -5, 400, 3, -2], [-40, 10, 12, 3, 350, 6], [5, -8, 20, -2, 6, 300]]
damping = {proportional = 2e-3}
[elements.maxwell]
type = "bushing"
on = "machine"
at = [-0.3, 0.2, -0.1]
orientation = {axis = [0, 1, 1], angle = -0.3}
translation = [4e4, 5e4, 8e4]
rotation = [100, 200, 300]
damping = {maxwell = {ratios = [0.5, 0.3], times = [2e-3, 2e-2]}}
[elements.plain]
type = "bushing"
on = "machine"
at = [0.1, -0.3, -0.1]
translation = [4e4, 5e4, 9e4]
damping = {proportional = 3e-3}
)" + laws +
      R"([excitations.force]
type = "harmonic"
on = "machine"
at = [0.1, 0.05, 0.2]
force = [40, -30, 90]
moment = [2, 0, 5]
)";
}

constexpr const char* laws = R"(laws.z = {cubic = 3e10, quadratic = 2e6}
laws.x = {gap_stop = {gaps = [1e-4, 3e-4], stiffness = 4e4}}
laws.rx = {damping_curve = {quadratic = 30}}
)";
constexpr const char* coil = R"([elements.coil]
type = "coil_spring"
on = "machine"
at = [0, 0, -0.15]
wire_diameter = 6e-3
mean_diameter = 50e-3
active_coils = 6
free_length = 0.12
material = "spring_steel"
level = "exact"
)";

/// Complex amplitudes of the force of a law over sampled courses, harmonics 0 … H.
VectorXcd sampled_force(const elements::ScalarLaws& law, double at_rest, const Eigen::VectorXd& deflection,
                        double omega, Index harmonics) {
  constexpr int samples = 1 << 16;
  VectorXcd force = VectorXcd::Zero(harmonics + 1);
  for (int n = 0; n < samples; ++n) {
    const double phase = 2 * pi * n / samples;
    double x = deflection(0) + at_rest, v = 0;
    for (Index k = 1; 2 * k < deflection.size(); ++k) {
      const double a = deflection(2 * k - 1), b = deflection(2 * k), c = std::cos(static_cast<double>(k) * phase),
                   s = std::sin(static_cast<double>(k) * phase);
      x += a * c + b * s;
      v += static_cast<double>(k) * omega * (b * c - a * s);
    }
    double f = 0;
    for (const elements::ElasticForce& one : elements::only<elements::ElasticForce>(law))
      f += elements::force_and_tangent(one, x).force - elements::force_and_tangent(one, at_rest).force;
    for (const elements::DampingForce& one : elements::only<elements::DampingForce>(law))
      f += elements::force_of_rate(one, v).force;
    for (Index k = 0; k <= harmonics; ++k)
      force(k) += std::polar((k == 0 ? 1.0 : 2.0) * f / samples, -static_cast<double>(k) * phase);
  }
  return force;
}

struct Checked {
  double worst = 0;  ///< share of the largest deflection that full and condensed balance differ by
  double power_in = 0, power_lost = 0;
};

Checked compared(const std::string& text, double omega, Index harmonics) {
  const project::Project project = test::project(text);
  const model::System& at_rest = project.base().system;
  nonlinear::SteadyOptions options{.from = 0.9 * omega, .to = 1.2 * omega, .harmonics = harmonics};
  options.at = {omega};
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(at_rest, options);
  const Eigen::MatrixXd deflections = branch.at.at(0).deflections;
  // The machine without its laws, and their rows, from the model alone.
  model::Description description = at_rest.description();
  for (model::Element& element : description.elements) element.law.nonlinear.reset();
  const model::System linear = *model::System::checked(std::move(description));
  const assembly::Assembled assembled = assembly::assemble(linear);
  const Index n = assembled.layout.before_last();
  std::vector<Eigen::VectorXd> rows;
  std::vector<VectorXcd> forces;
  for (std::size_t e = 0; e < linear.elements().size(); ++e)
    for (const model::NonlinearPart& part : linear.elements()[e].nonlinear_parts) {
      const model::Element& element = linear.elements()[e];
      const model::Span span = model::span(linear.bodies(), element.n, element.k);
      const Eigen::RowVectorXd local = elements::deflection_row(part.axis, span.arm, span.n_from_k, part.centre);
      Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
      for (Index j = 0; j < assembled.elements[e].end_columns; ++j)
        row(assembled.elements[e].rows[j]) += (local * assembled.elements[e].ends.col(j).head<12>()).value();
      rows.push_back(row);
      forces.push_back(
          sampled_force(part.laws, part.at_rest, deflections.col(to_index(forces.size())), omega, harmonics));
    }
  Checked result;
  const assembly::Loading loading = assembly::harmonic_loading(linear, assembled, {});
  for (Index k = 1; k <= harmonics; ++k) {
    const double here = static_cast<double>(k) * omega;
    const MatrixXcd z = assembled.dynamic_stiffness(here, here);
    VectorXcd right = VectorXcd::Zero(n);
    if (k == 1) right = loading.force.at(here).head(n);
    const VectorXcd given = right;
    for (std::size_t j = 0; j < rows.size(); ++j) right -= rows[j] * forces[j](k);
    const VectorXcd q = z.fullPivLu().solve(right);
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const Complex condensed(deflections(2 * k - 1, to_index(j)), -deflections(2 * k, to_index(j)));
      result.worst = std::max(result.worst, std::abs(rows[j].cast<Complex>().dot(q) - condensed));
      result.power_lost += 0.5 * (std::conj(Complex(0, here) * condensed) * forces[j](k)).real();
    }
    result.power_in += 0.5 * (Complex(0, here) * q).dot(given).real();
    result.power_lost += 0.5 * (Complex(0, here) * q).dot(z * q).real();
  }
  result.worst /= deflections.cwiseAbs().maxCoeff();
  return result;
}

TEST(FullBalance, AllCoordinatesWithConstantMatrices) {
  const Checked found = compared(machine("", laws), 45, 9);
  EXPECT_LT(found.worst, 1e-9);  // 65536 samples of a stop
  EXPECT_THAT(found.power_lost, RelativelyNear(found.power_in, 1e-9));
}

TEST(FullBalance, AllCoordinatesWithAnExactCoilSpring) {
  const Checked found = compared(machine("", std::string(laws) + coil), 45, 9);
  EXPECT_LT(found.worst, 1e-9);
  EXPECT_THAT(found.power_lost, RelativelyNear(found.power_in, 1e-9));
}

TEST(FullBalance, SmoothLawsToRoundOff) {
  const Checked found = compared(machine("", "laws.z = {cubic = 3e10, quadratic = 2e6}\n" + std::string(coil)), 45, 9);
  EXPECT_LT(found.worst, 1e-10);
  EXPECT_THAT(found.power_lost, RelativelyNear(found.power_in, 1e-10));
}

/// The whole machine elsewhere and in another orientation: results on the body are the same in its own axes.
TEST(FullBalance, TurnedAndMovedMachinesAgree) {
  const auto motion = [](const std::string& body) {
    const project::Project project = test::project(machine(body, laws));
    nonlinear::SteadyOptions options{.from = 40, .to = 55, .harmonics = 9, .of = {"machine", "plain.deflection"}};
    options.at = {45};
    return nonlinear::steady_branch(project.base().system, options).at.at(0);
  };
  const nonlinear::SteadyPoint here = motion("");
  const nonlinear::SteadyPoint there =
      motion("position = [3, -2, 5]\norientation = {axis = [2, -1, 1], angle = 1.1}\n");
  double largest = 0;
  for (const nonlinear::ObservedMotion& one : here.results) largest = std::max(largest, one.largest);
  for (std::size_t c = 0; c < here.results.size(); ++c)
    EXPECT_LT((here.results[c].harmonics - there.results[c].harmonics).norm(), 1e-8 * largest) << c;
}

}  // namespace full_balance_test
