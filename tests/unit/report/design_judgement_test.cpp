// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/design_judgement.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/results/design/judgements.h"

namespace design_judgement_test {

using namespace trivet;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Outcome = results::Judgement::Outcome;

// ω0 = 15 rad/s, ζ = 45/(2·60) = 0.375: the largest amplitude is (18/900)/(2ζ√(1 − ζ²)) = 28.766 mm at 12.7 rad/s.
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
[analyses]
modes = {}
response = {band = ["0 Hz", "6 Hz"]}
)";

struct Box {
  std::vector<results::Judgement> list;
  std::string html, table;
};

Box box_of(const std::string& text) {
  const project::Project project = test::project(text);
  const std::vector<study::CaseResults> results = study::run(project);
  std::vector<const study::CaseResults*> pointers;
  for (const study::CaseResults& one : results) pointers.push_back(&one);
  const std::vector<report::ShownCase> cases = report::shown_cases(project, results);
  return {results::judgements(pointers), report::judgement_box(cases, true),
          report::judgements_table(cases, project.base().display)};
}

double peak() { return 0.02 / (2 * 0.375 * std::sqrt(1 - 0.375 * 0.375)); }

TEST(JudgementBox, IsRedOverAViolatedRequirementAndNamesTheWorstItsPlaceAndItsCase) {
  const Box box =
      box_of(std::string(machine) +
             "[requirements]\nlimits = {\"mass.z\" = \"12 mm\"}\ndamping_ratio = 0.1\nhold_in = [\"\", \"soft\"]\n"
             "[cases.soft]\nelements.spring.scale = 0.25\n");
  EXPECT_THAT(box.html, StartsWith("<div class=\"alert\" role=\"note\"><h2>✗ VIOLATED: 2 of 4 requirements</h2>"));
  EXPECT_THAT(box.html,
              HasSubstr("The base model violates <a href=\"#case=0\" data-select=\"0\"><strong>mass.z</strong></a>: "
                        "28.77 mm 0-p at 2.024 Hz, allowed ≤ 12 mm 0-p"));
  // A quarter of the stiffness: ω0 and ζ are halved. The softer case is worse, so it is named first.
  EXPECT_LT(box.html.find("Case soft violates"), box.html.find("The base model violates"));
  EXPECT_THAT(box.html, HasSubstr("Case soft violates"));
  // One row for each requirement, with its worst case.
  EXPECT_THAT(box.table, AllOf(HasSubstr("≤ 12 mm"), HasSubstr(">soft<"), HasSubstr(">VIOLATED<")));
  EXPECT_THAT(box.table, Not(HasSubstr("28.77 mm")));
  EXPECT_THAT(box.html, Not(HasSubstr("✓")));
  constexpr double round_off = 1e-9;
  EXPECT_NEAR(box.list.front().margin, 0.012 / peak(), round_off);
}

TEST(JudgementBox, IsGreenOnlyIfEverythingIsMetAndNamesWhatGoverns) {
  const Box box =
      box_of(std::string(machine) + "[requirements]\nlimits = {\"mass.z\" = \"1 m\"}\ndamping_ratio = 0.1\n");
  EXPECT_THAT(box.html, StartsWith("<div class=\"calm\" role=\"note\"><h2>✓ MET: 2 of 2 requirements</h2>"));
  EXPECT_THAT(box.html, HasSubstr("margin 3.75"));  // of the damping ratio, 0.375 / 0.1
}

TEST(JudgementBox, IsAmberIfARequirementCouldNotBeJudged) {
  // The limit line begins above the band of the response.
  const Box box = box_of(std::string(machine) +
                         "[limit_lines.high]\nof = \"mass.z\"\nlevel = \"zero_to_peak\"\n"
                         "rows = [[\"20 Hz\", 1], [\"30 Hz\", 1]]\n"
                         "[requirements]\nlimit_lines = [\"high\"]\ndamping_ratio = 0.1\n");
  EXPECT_THAT(box.html, StartsWith("<div class=\"doubt\" role=\"note\"><h2>? NOT JUDGED: 1 of 2 requirements"));
  EXPECT_THAT(box.html, AllOf(Not(HasSubstr("✓")), Not(HasSubstr("VIOLATED"))));
}

TEST(JudgementBox, CountsALimitThatIsAlsoARequirementOnce) {
  const std::string limits = "[limits]\n\"mass.z\" = \"12 mm\"\n";
  EXPECT_THAT(box_of(machine + limits).html, HasSubstr("VIOLATED: 1 of 1 limit</h2>"));
  EXPECT_THAT(box_of(machine + limits + "[requirements]\ndamping_ratio = 0.1\n").html,
              HasSubstr("VIOLATED: 1 of 2 requirements</h2>"));
}

TEST(JudgementBox, IsNotRedByCasesInWhichTheDesignNeedNotHold) {
  const Box box = box_of(std::string(machine) +
                         "[requirements]\ndamping_ratio = 0.3\nhold_in = [\"\"]\n"
                         "[cases.soft]\nelements.spring.scale = 0.25\n");
  EXPECT_THAT(box.html, StartsWith("<div class=\"doubt\""));
  EXPECT_THAT(box.html, HasSubstr("MET: 1 of 1 requirement; violated in 1 case in which they are not binding"));
  EXPECT_THAT(box.html, HasSubstr("Violated in cases in which the requirements are not binding:"));
  EXPECT_THAT(box.html, HasSubstr("Case soft violates"));
  // The row of the requirement is that of the case that decides, and names the other one.
  EXPECT_THAT(box.table, AllOf(HasSubstr("also violated, not binding"), HasSubstr(">met<"), HasSubstr(">soft<")));
}

TEST(JudgementBox, DoesNotJudgeAFileWithoutRequirements) {
  const Box box = box_of(machine);
  EXPECT_THAT(box.list, IsEmpty());
  EXPECT_THAT(box.html, AllOf(HasSubstr("Not judged: the file has no requirements"), Not(HasSubstr("✓"))));
}

TEST(JudgementBox, IsRedIfOneOfTwoLimitsThatAreNoRequirementIsExceeded) {
  const Box box = box_of(std::string(machine) + "[limits]\n\"mass.z\" = \"12 mm\"\n" +
                         "[requirements]\ndamping_ratio = 0.1\n"
                         "[cases.stiff]\nelements.spring.scale = 100\n");
  EXPECT_THAT(box.html, StartsWith("<div class=\"alert\""));
  EXPECT_THAT(box.html, HasSubstr("The base model violates"));
  EXPECT_THAT(box.html, Not(HasSubstr("Case stiff violates")));
}

TEST(JudgementBox, IsRedOverAClearanceThatCloses) {
  // Under gravity the mass of 4 kg sinks by 4·9.80665/900 = 43.6 mm.
  const auto with = [](const std::string& gap) {
    std::string text = machine;
    text.replace(text.find("[bodies.mass]"), 0, "gravity = [0, 0, -9.80665]\n");
    text.replace(text.find("[elements.spring]"), 0, "points.foot = [0, 0, 0]\n");
    return box_of(text + "[clearances.floor]\nbetween = [\"mass.foot\", \"ground\"]\ndirection = [0, 0, -1]\ngap = \"" +
                  gap + "\"\n")
        .html;
  };
  EXPECT_THAT(with("40 mm"), AllOf(StartsWith("<div class=\"alert\""), HasSubstr("clearance"), HasSubstr("floor")));
  EXPECT_THAT(with("2 m"), StartsWith("<div class=\"calm\""));
}

TEST(JudgementBox, IsRedByTheRulesOfAMap) {
  const std::string map =
      "[analyses.map]\nlimits = {\"mass.z\" = \"LIMIT\"}\n"
      "x = {parameter = \"elements.spring.scale\", from = 0.5, to = 4, points = 5}\n"
      "y = {parameter = \"elements.spring.damping.proportional\", from = 0.01, to = 0.3, points = 5}\n";
  const auto with = [&](const std::string& limit) {
    std::string text = machine + map;
    return box_of(text.replace(text.find("LIMIT"), 5, limit)).html;
  };
  EXPECT_THAT(with("12 mm"), HasSubstr("VIOLATED: 1 of 1 verdict of a map"));
  EXPECT_THAT(with("1 m"), StartsWith("<div class=\"calm\""));
  EXPECT_THAT(with("0.1 mm"), HasSubstr("no design of the map meets every rule"));
}

}  // namespace design_judgement_test
