// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/projects.h"
#include "support/quad_model.h"
#include "trivet/study/family/frequency_slopes.h"
#include "trivet/study/optimize/design_objective.h"
#include "trivet/study/optimize/optimization.h"

/// A body on four equal corner springs, with equal natural frequencies along x and y: its one-sided slopes in a
/// direction of the parameters against models solved again in quadruple precision, and searches that start there.
namespace repeated_frequencies_test {

using namespace trivet;
using test::Quad;
using test::QuadMatrix;

/// Demanded of a slope, as a share of the largest.
constexpr double exact = 1e-9;

/// Mount a may be stiffer, or turned: that couples x and y.
std::string square_machine(const std::string& requirements) {
  std::string text =
      "trivet = 1\n[bodies.m]\nmass = 100\nfree = [\"x\", \"y\", \"z\"]\ninertia = {about = \"pole\", xx = 5, yy = 5, "
      "zz = 5}\n";
  for (const auto& [name, x, y] : {std::tuple{"a", 0.3, 0.3}, {"b", -0.3, 0.3}, {"c", 0.3, -0.3}, {"d", -0.3, -0.3}})
    text += fmt::format(
        "[elements.{}]\ntype = \"bushing\"\non = \"m\"\nat = [{}, {}, 0]\ntranslation = [6e4, 6e4, 2e5]\n"
        "damping = {{loss_factor = 0.1}}\n",
        name, x, y);
  text +=
      "[elements.skew]\ntype = \"bushing\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [1e4, 1e4, 1e4]\norientation = "
      "{axis = [0, 0, 1], angle = \"45 deg\"}\n"
      "[parameters.diagonal]\npath = \"elements.skew.stiffness_factor.x\"\nfrom = 0.5\nto = 2.5\n"
      "[parameters.along]\npath = \"elements.a.stiffness_factor.x\"\nfrom = 0.9\nto = 1.1\n"
      "[parameters.mass]\npath = \"bodies.m.mass\"\nfrom = 50\nto = 150\n";
  return text + requirements;
}

struct Square {
  project::Project project = test::project(square_machine(""));
  study::DesignSpace space{project, {}};
  Eigen::VectorXd values = Eigen::Vector3d(1, 1, 100);
  model::System system = space.system(project.base(), values);
  assembly::Assembled assembled = assembly::assemble(system);
  modal::Modes modes = modal::modes(system, assembled);
  study::DesignNeighbours neighbours{space, project.base(), values};

  [[nodiscard]] study::FrequencySlopes slopes() const {
    std::vector<response::MatrixRates> rates;
    for (std::size_t j = 0; j < space.size(); ++j)
      rates.push_back(response::matrix_rates(neighbours.along(j), assembled));
    return {modes, assembled.matrices, rates, space.towards(values)};
  }

  /// ln ω of the first two modes, `step` away in a direction: all numbers are linear in the parameters.
  [[nodiscard]] std::array<Quad, 2> frequencies(const Eigen::Vector3d& direction, const Quad& step) const {
    QuadMatrix K = assembled.matrices.K.cast<Quad>(), A = assembled.matrices.A.cast<Quad>();
    for (Eigen::Index j = 0; j < 3; ++j) {
      Eigen::VectorXd moved = values;
      moved(j) *= 1.5;
      const numerics::DynamicMatrices there = assembly::assemble(space.system(project.base(), moved)).matrices;
      const Quad share = step * Quad(direction(j)) / Quad(0.5 * values(j));
      K += share * (there.K.cast<Quad>() - assembled.matrices.K.cast<Quad>());
      A += share * (there.A.cast<Quad>() - assembled.matrices.A.cast<Quad>());
    }
    const test::QuadModes found = test::quad_modes(K, A);
    return {log(found.lambda(0)) / 2, log(found.lambda(1)) / 2};
  }
};

TEST(RepeatedFrequencies, HaveOneSidedSlopesInEveryDirection) {
  const Square square;
  ASSERT_NEAR(square.modes.list[0].eigenvalue_squared, square.modes.list[1].eigenvalue_squared, 1e-9);
  const study::FrequencySlopes slopes = square.slopes();
  // The matrices of the given design are equal only to round-off: far below the step, above the noise of its square.
  const Quad step = 1e-6;
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, -0.7, 20),
        Eigen::Vector3d(0.2, 0.5, -3), Eigen::Vector3d(0, 0, 1)}) {
    const Eigen::VectorXd found = slopes.slopes_along(1, direction);
    const auto here = square.frequencies(direction, 0), one = square.frequencies(direction, step),
               two = square.frequencies(direction, 2 * step), three = square.frequencies(direction, 3 * step),
               four = square.frequencies(direction, 4 * step);
    for (std::size_t k = 0; k < 2; ++k) {  // one-sided, of the fourth order
      const Quad expected = (-25 * here[k] + 48 * one[k] - 36 * two[k] + 16 * three[k] - 3 * four[k]) / (12 * step);
      EXPECT_NEAR(found(to_index(k)), static_cast<double>(expected), exact * found.cwiseAbs().maxCoeff())
          << "frequency " << k << " along " << direction.transpose();
    }
  }
}

/// In the given axes x and y the skew element has equal slopes in both frequencies: their difference would be zero.
TEST(RepeatedFrequencies, ArePartedBySearch) {
  const project::Project project = test::project(square_machine(
      "[requirements]\nnatural_frequencies = {separation = 1.02}\n[analyses.optimize]\nparameters = [\"diagonal\"]\n"
      "starts = 1\n"));
  const study::DesignObjective objective(project, *project.base().analyses.optimize);
  Eigen::VectorXd values;
  Eigen::MatrixXd slopes;
  objective.evaluate(Eigen::VectorXd::Constant(1, 0.25), values, &slopes);
  Eigen::Index least = 0;
  EXPECT_NEAR(values.minCoeff(&least), -std::log(1.02), exact);
  // ω² of the diagonal is (2.5e5 + 1e4 (factor − 1)) / m: over the range of 2, ln ω grows by 1e4 / 2.5e5.
  EXPECT_NEAR(slopes(least, 0), 1e4 / 2.5e5, exact);
}

}  // namespace repeated_frequencies_test
