// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/projects.h"
#include "trivet/assembly/loads.h"
#include "trivet/judging/changed_case.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/study/map/map_curves.h"

namespace map_curves_test {

using namespace trivet;

constexpr double plenty = 1e6;  // bytes

/// A body on three mounts; the damping of the third couples the modes.
/// @param damping  of the other two  @param course  of the excitation  @param response  keys of its table
std::string machine(const std::string& damping, const std::string& course, const std::string& response) {
  std::string text = R"(trivet = 1
[bodies.machine]
mass = 40
inertia = {about = "pole", xx = 2, yy = 3, zz = 4}
)";
  for (const char* name : {"a", "b", "c"})
    text += std::string("[elements.") + name + "]\ntype = \"bushing\"\non = \"machine\"\nat = " +
        (name[0] == 'a'       ? "[0.4, 0.1, -0.3]"
             : name[0] == 'b' ? "[-0.3, 0.3, -0.2]"
                              : "[-0.2, -0.4, -0.3]") +
        "\ntranslation = [3e4, 4e4, 6e4]\ndamping = " + (name[0] == 'c' ? "{proportional = 0.005}" : damping) + "\n";
  return text + "[excitations.drive]\non = \"machine\"\nat = [0.1, 0, 0.2]\n" + course + "\n[analyses]\nresponse = {" +
      response +
      "}\nmap = {x = {parameter = \"elements.a.scale\", from = 0.5, to = 4, points = 9, spacing = "
      "\"logarithmic\"}, y = {parameter = \"bodies.machine.mass\", from = 30, to = 60, points = 5}, limits = "
      "{\"machine.z\" = \"5 mm\"}}\n";
}

study::MapCurves curves_of(const project::Project& project, double bytes = plenty,
                           const study::MapOptions& options = {}) {
  const project::Case& base = project.base();
  const study::DesignMap map = study::design_map(project, base, *base.analyses.map, options);
  return study::map_curves(base, map, bytes);
}

/// Largest relative difference of the stored curves from direct solutions of the changed model, over all designs.
double difference(const project::Project& project, const study::MapCurves& curves) {
  const project::Case& base = project.base();
  const project::MapRequest& request = *base.analyses.map;
  const std::vector<double> omega = {3, 17.3, 31, 44.4, 58, 71, 86, 99};
  double worst = 0;
  for (std::size_t node = 0; node < curves.count(); ++node) {
    const double x = request.x.at(curves.columns[node % curves.columns.size()] / 8.0),
                 y = request.y.at(curves.rows[node / curves.columns.size()] / 4.0);
    const auto system =
        judging::changed_system(base, {{project::ModelNumber(request.x), x}, {project::ModelNumber(request.y), y}});
    const assembly::Assembled assembled = assembly::assemble(*system);
    const auto& selection = base.analyses.response->selection;
    const response::FrequencyResponse truth = response::frequency_response(
        assembled, assembly::channels(*system, assembled, selection.of, selection.quantity),
        assembly::harmonic_loading(*system, assembled), omega);
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(node);
      const Eigen::VectorXcd found =
          curves.form.at(curves.denominators.row(row).transpose(), curves.numerators.row(row).transpose(), omega[i]);
      for (std::size_t c = 0; c < truth.curves.size(); ++c) {
        const auto value = truth.curves[c].value(static_cast<Eigen::Index>(i));
        worst = std::max(worst, std::abs(found(static_cast<Eigen::Index>(c)) - value) / std::abs(value));
      }
    }
  }
  return worst;
}

constexpr double of_floats = 1e-5;  // 24 bits, and some digits that cancel between poles

TEST(MapCurves, AreThoseOfEachDesignSolvedDirectly) {
  const project::Project project =
      test::project(machine("{proportional = 0.002}", "type = \"harmonic\"\nforce = [10, 4, 7]", "band = [0, 100]"));
  const study::MapCurves curves = curves_of(project);
  EXPECT_EQ(curves.reason, "");
  EXPECT_EQ(curves.count(), 45u);
  EXPECT_TRUE(curves.real);
  EXPECT_TRUE(curves.rounded);
  EXPECT_EQ(curves.form.pairs, 6);
  EXPECT_EQ(std::ranges::count(curves.drawn, 1), 45);
  EXPECT_LE(curves.worst_error, of_floats);
  EXPECT_LE(difference(project, curves), of_floats);
}

TEST(MapCurves, OfLossFactorsAndALaggingForceHaveComplexNumbers) {
  const project::Project project =
      test::project(machine("{loss_factor = 0.1}", "type = \"harmonic\"\nforce = [10, 4, 7]\nphase = \"30 deg\"",
                            "band = [0, 100], quantity = \"acceleration\", of = [\"coordinates\", \"ground\"]"));
  const study::MapCurves curves = curves_of(project);
  EXPECT_FALSE(curves.real);
  EXPECT_EQ(std::ranges::count(curves.drawn, 1), 45);
  EXPECT_LE(curves.worst_error, study::curves_within);
  EXPECT_LE(difference(project, curves), study::curves_within);
}

TEST(MapCurves, OfOverdampedDesignsHaveRealPoles) {
  const project::Project project =
      test::project(machine("{proportional = 0.2}", "type = \"harmonic\"\nforce = [10, 4, 7]", "band = [0, 100]"));
  const study::MapCurves curves = curves_of(project);
  EXPECT_EQ(std::ranges::count(curves.drawn, 1), 45);
  EXPECT_LE(difference(project, curves), study::curves_within);
}

TEST(MapCurves, FitTheirBytesOnACoarserGridWithItsEndsAndTheBestDesign) {
  const project::Project project =
      test::project(machine("{proportional = 0.002}", "type = \"harmonic\"\nforce = [10, 4, 7]", "band = [0, 100]"));
  const study::MapCurves curves = curves_of(project, 6000);
  const double bytes = static_cast<double>(8 * curves.denominators.size() + 4 * curves.numerators.size());
  EXPECT_LE(bytes, 6000);
  EXPECT_EQ(curves.columns.front(), 0);
  EXPECT_EQ(curves.columns.back(), 8);
  EXPECT_EQ(curves.rows.back(), 4);
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  bool has_best = false;
  for (std::size_t node = 0; node < curves.count(); ++node)
    has_best = has_best || curves.design(node, map.grid) == *map.best;
  EXPECT_TRUE(has_best);
  EXPECT_LE(difference(project, curves), of_floats);
}

TEST(MapCurves, HaveABandThatReachesTheStiffestDesignUnlessTheFileGivesOne) {
  const std::string force = "type = \"harmonic\"\nforce = [10, 4, 7]";
  const project::Project given = test::project(machine("{proportional = 0.002}", force, "band = [5, 90]"));
  EXPECT_EQ(curves_of(given).band.from, 5);
  EXPECT_EQ(curves_of(given).band.to, 90);
  EXPECT_GT(curves_of(test::project(machine("{proportional = 0.002}", force, ""))).band.to, 100);
}

TEST(MapCurves, AreNotThereForElementsThatDependOnFrequency) {
  const project::Project project =
      test::project(machine("{fractional_zener = {ratio = 2, time = \"10 ms\", order = 0.5}}",
                            "type = \"harmonic\"\nforce = [10, 4, 7]", "band = [0, 100]"));
  const study::MapCurves curves = curves_of(project, plenty, {.nx = 2, .ny = 2});
  EXPECT_NE(curves.reason.find("depends on frequency"), std::string::npos) << curves.reason;
  EXPECT_EQ(curves.count(), 0u);
}

}  // namespace map_curves_test
