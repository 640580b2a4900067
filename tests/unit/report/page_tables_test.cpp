// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/page/drawing_json.h"
#include "trivet/report/page/report_page.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/model/project_json.h"

namespace page_tables_test {

using namespace trivet;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* machine = R"(
trivet = 1
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 18]
[limits]
"mass.z" = "12 mm"
[analyses]
modes = {}
roots = {}
peaks = {}
response = {band = [0, 40]}
[cases.stiff]
elements.spring.scale = 4
)";

std::string page_of(const std::string& text) {
  const project::Project project = test::project(text);
  std::vector<study::CaseResults> all;
  for (const auto& variant : project.cases) all.push_back(study::case_results(variant, variant.analyses));
  return report::report_page(project, all, results::page_json(project, all));
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(AlignedNumber, HasTheGivenDigitsAndNoMore) {
  EXPECT_EQ(report::aligned_number(0.5, 4), "0.5000");
  EXPECT_EQ(report::aligned_number(1116.04, 4), "1116");
  EXPECT_EQ(report::aligned_number(1116.04, 5), "1116.0");
  EXPECT_EQ(report::aligned_number(-36.89561, 6), "-36.8956");
  EXPECT_EQ(report::aligned_number(41188.2, 5), "41188");
  EXPECT_EQ(report::aligned_number(2.5e-7, 3), "2.50e-07");
  EXPECT_EQ(report::aligned_number(1.5e7, 3), "1.50e+07");
  EXPECT_EQ(report::aligned_number(0), "0");
  EXPECT_EQ(report::aligned_number(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST(HtmlTable, KeepsUnitsOfHeadingsOnOneLineAndEscapesText) {
  const std::string html =
      report::html_table({report::right("moment [N m]"), {"name"}}, {{{report::right("1"), {"<b>"}}, "failed"}});
  EXPECT_THAT(html, HasSubstr("moment\u00a0[N\u00a0m]"));
  EXPECT_THAT(html, HasSubstr("<tr class=\"failed\"><td class=\"number\">1</td><td>&lt;b&gt;</td>"));
}

TEST(CurveGroups, KeepMotionsAndForcesOfTheSameNameApart) {
  const auto groups = report::curve_groups({{"front.z", "m"}, {"front.force.z", "N"}, {"front.moment.x", "N m"}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_FALSE(groups[0].forces);
  EXPECT_TRUE(groups[1].forces);
  EXPECT_EQ(groups[1].lower.front().label, "Mx");
}

TEST(Drawing, GivesTheChartsTheStrokesOfTheFigures) {
  const std::string drawing = report::drawing_json({});
  for (std::size_t series = 0; series < 6; ++series) EXPECT_THAT(drawing, HasSubstr(report::series_colour(series)));
  EXPECT_THAT(drawing, HasSubstr("{\"colour\":\"#D55E00\",\"dash\":[7,3]}"));
  EXPECT_THAT(report::series_stroke(1), AllOf(HasSubstr("#D55E00"), HasSubstr("stroke-dasharray=\"7,3\"")));
  EXPECT_THAT(report::series_stroke(0), Not(HasSubstr("dasharray")));
}

// f = √(900/4)/2π = 2.38732 Hz; with four times the stiffness twice that. λ = −ζω ± iω√(1 − ζ²) with ζ = 0.05 · 15/2.
TEST(PageTables, ShowTheResultsOfEachCase) {
  const std::string page = page_of(machine);
  EXPECT_EQ(count(page, "<div data-case=\"1\" hidden>"), 3);
  EXPECT_THAT(page, HasSubstr(" class=\"number\">2.38732</td>"));
  EXPECT_THAT(page, HasSubstr(" class=\"number\">4.77465</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">-5.625</td><td class=\"number\">2.213109</td>"));
  EXPECT_THAT(page, Not(HasSubstr("-2.213109")));  // of two conjugate roots only one
  EXPECT_THAT(page, HasSubstr("<code>elements.spring.scale = 4</code>"));
  EXPECT_THAT(page, HasSubstr("<h2>✗ VIOLATED: 1 of 2 limits</h2>"));
  EXPECT_THAT(page, HasSubstr("B = 0.05 s × scaled K"));
  EXPECT_THAT(page, HasSubstr("Fz 18 N"));
}

TEST(PageTables, ListEqualWarningsOnceWithTheirCases) {
  const std::string page = page_of(std::string(machine) + "[cases.heavy]\nbodies.mass.mass = 9\n");
  const std::string notices =
      page.substr(page.find("id=\"notices\""), page.find("id=\"overview\"") - page.find("id=\"notices\""));
  EXPECT_LE(count(notices, "<h2>⚠"), 1);
  EXPECT_THAT(notices, HasSubstr("data-select=\"2\">heavy</button>"));
}

TEST(ReportPage, HasItsColoursInItsDataAndNotInItsScripts) {
  const std::string page = page_of(machine);
  const std::string scripts = page.substr(page.rfind("<script>"));
  EXPECT_THAT(page, HasSubstr("#D55E00"));
  EXPECT_THAT(scripts, AllOf(HasSubstr("uPlot"), Not(HasSubstr("#D55E00")), Not(HasSubstr("7, 3"))));
}

TEST(ReportPage, CarriesTheLicenceOfTheChartLibrary) {
  EXPECT_THAT(page_of(machine), AllOf(HasSubstr("Copyright (c) 2022 Leon Sorokin"), HasSubstr("/* uPlot 1.6")));
}

}  // namespace page_tables_test
