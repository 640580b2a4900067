// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/mapped_machine.h"
#include "support/projects.h"
#include "trivet/foundation/version.h"
#include "trivet/project/text/embedded_text.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/figures.h"
#include "trivet/report/page/report_page.h"
#include "trivet/results/model/project_json.h"

namespace report_test {

using namespace trivet;

TEST(Ticks, AreAtLeastThreeOnALogarithmicAxis) {
  const auto labels = [](double from, double to) {
    std::string text;
    for (const report::Tick& tick : report::decade_ticks(from, to)) text += tick.label + " ";
    return text;
  };
  EXPECT_EQ(labels(0.01, 100), "0.01 0.1 1 10 100 ");
  EXPECT_EQ(labels(0.5, 4), "0.5 1 2 ");
  EXPECT_EQ(labels(0.6, 0.9), "0.6 0.65 0.7 0.75 0.8 0.85 0.9 ");
  EXPECT_EQ(labels(3, 4.9), "3 3.5 4 4.5 ");
  EXPECT_EQ(labels(2, 300), "2 5 10 20 50 100 200 ");
  for (double from = 0.011; from < 0.11; from *= 1.05)
    for (double ratio = 1.01; ratio < 2000; ratio *= 1.07) {
      const std::size_t count = report::decade_ticks(from, ratio * from).size();
      EXPECT_TRUE(count >= 3 && count <= 9) << from << " to " << ratio * from << ": " << count;
    }
}

TEST(Ticks, AreRoundAndInside) {
  const auto ticks = report::linear_ticks(0, 0.553, 5);
  ASSERT_EQ(ticks.size(), 6u);
  EXPECT_EQ(ticks[3].label, "0.3");
  EXPECT_TRUE(report::linear_ticks(1, 1, 5).empty());
  EXPECT_EQ(report::angle_ticks(-180, 180).front().label, "-180");
  EXPECT_EQ(report::unit_prefix(0.0123, "m").unit, "mm");
  constexpr double round_off = 1e-12;  // a product near 12
  EXPECT_NEAR(report::unit_prefix(0.0123, "m").factor * 0.0123, 12.3, round_off);
  EXPECT_EQ(report::unit_prefix(0, "N").unit, "N");
}

TEST(Report, ContainsItsDataAndNoExternalLinks) {
  const auto project = test::project(project::starter_text());
  std::vector<study::CaseResults> all;
  for (const auto& variant : project.cases) all.push_back(study::case_results(variant, variant.analyses));
  const std::string page = report::report_page(project, all, results::page_json(project, all));
  EXPECT_THAT(page, testing::HasSubstr(project.sha256));
  EXPECT_THAT(page, testing::HasSubstr(std::string("trivet ") + foundation::version()));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("{{")));
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(outside)));
}

TEST(Report, CarriesModelsOfItsCurvesInsteadOfTheirPoints) {
  const auto project = test::project(project::starter_text());
  std::vector<study::CaseResults> all;
  for (const auto& variant : project.cases) all.push_back(study::case_results(variant, variant.analyses));
  const std::string full = results::results_json(project, all), drawn = results::page_json(project, all);
  EXPECT_LT(3 * drawn.size(), full.size());
  EXPECT_THAT(drawn, testing::HasSubstr("\"pieces\""));
  EXPECT_THAT(full, testing::Not(testing::HasSubstr("\"pieces\"")));
}

TEST(Report, NamesCannotBreakThePage) {
  const auto project = test::project(R"(
trivet = 1
title = "</script><b>&"
[bodies."<i>&\"x"]
mass = 1
free = ["x"]
[excitations.f]
type = "harmonic"
on = "<i>&\"x"
at = [0, 0, 0]
force = [1, 0, 0]
[analyses]
response = {band = [1, 2]}
)");
  std::vector<study::CaseResults> all = {study::case_results(project.base(), project.base().analyses)};
  const std::string page = report::report_page(project, all, results::page_json(project, all));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("</script><b>")));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("<i>")));
}

TEST(Figures, OnePerGroupOfCurves) {
  const auto project = test::project(project::starter_text());
  const auto figures = report::characteristics(study::case_results(project.base(), project.base().analyses));
  ASSERT_EQ(figures.size(), 3u);  // machine, machine.seat, ground
  for (const auto& figure : figures) {
    EXPECT_THAT(figure.svg, testing::StartsWith("<svg"));
    EXPECT_THAT(figure.svg, testing::Not(testing::HasSubstr("nan")));
  }
}

/// Overview of a block with forces along x and z: a case with another stiffness along z has the same first curve as the
/// base model, but is a different case.
std::string overview_with(const std::string& the_case) {
  const std::string block = test::mapped_block("{parameter = \"elements.spring.scale\", from = 0.5, to = 2}",
                                               "{parameter = \"bodies.block.mass\", from = 5, to = 20}");
  const project::Project project =
      test::project(block + "[analyses.response]\nband = [0, 40]\n" + the_case, {"excitations.force.force=[1, 0, 1]"});
  std::vector<study::CaseResults> results;
  for (const project::Case& variant : project.cases) {
    project::Analyses request;
    request.response = variant.analyses.response;
    results.push_back(study::case_results(variant, request));
  }
  return report::overview("Block", results).svg;
}

TEST(Overview, NamesTheCaseThatEqualsTheBaseModel) {
  const std::string svg = overview_with("[cases.same]\nelements.spring.scale = 1\n");
  EXPECT_THAT(svg, testing::HasSubstr(">same = base model: block<"));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr(">Base model")));
}

TEST(Overview, ShowsTheBaseModelNextToACaseThatDiffersInALaterCurve) {
  const std::string svg = overview_with("[cases.stiffer]\nelements.spring.translation = [900, 1100, 2600]\n");
  EXPECT_THAT(svg, testing::HasSubstr(">Base model: block<"));
  EXPECT_THAT(svg, testing::HasSubstr(">stiffer: block<"));
}

}  // namespace report_test
