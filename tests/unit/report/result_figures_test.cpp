// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/result_figures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/excited_machine.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/report/drawing/curve_panel.h"
#include "trivet/report/page/result_sections.h"

namespace result_figures_test {

using namespace trivet;
using testing::HasSubstr;
using testing::Not;

constexpr double round_off = 1e-12;  // a few operations on places up to 100

const study::CaseResults& everything() {
  static const study::CaseResults results = test::results_of_everything();
  return results;
}

/// The machine without requested analyses.
const project::Case& variant() {
  static const project::Case machine{.system = model::System::checked(test::machine_on_four_mounts()).value()};
  return machine;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// First violation of: every element closed in order, every attribute quoted, no bare & or <; "" if there is none.
std::string xml_fault(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      const std::string entity = text.substr(i, text.find(';', i) - i + 1);
      if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;")
        return "bare & at " + std::to_string(i);
    }
    if (text[i] != '<') continue;
    const std::size_t end = text.find('>', i);
    if (end == std::string::npos) return "no > at " + std::to_string(i);
    const std::string tag = text.substr(i + 1, end - i - 1);
    if (tag.find('<') != std::string::npos) return "< inside a tag: " + tag;
    if (count(tag, "\"") % 2) return "open quote: " + tag;
    const std::string name = tag.substr(0, tag.find_first_of(" />", 1));
    if (tag[0] == '/') {
      if (open.empty() || "/" + open.back() != tag) return "unexpected <" + tag + ">";
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    i = end;
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

/// The figure with a file name that begins with `file`.
const report::Figure& figure(const std::vector<report::Figure>& figures, const std::string& file) {
  const auto found =
      std::ranges::find_if(figures, [&](const report::Figure& f) { return f.file_name.starts_with(file); });
  if (found == figures.end()) throw std::out_of_range(file);
  return *found;
}

TEST(ResultFigures, AreWellFormedWithFiniteNumbersAndDifferentNames) {
  std::vector<std::string> names;
  for (const report::Figure& f : report::result_figures(variant(), everything())) {
    EXPECT_EQ(xml_fault(f.svg), "") << f.file_name;
    EXPECT_THAT(f.svg, Not(HasSubstr("nan"))) << f.file_name;
    EXPECT_THAT(f.svg, Not(HasSubstr("inf"))) << f.file_name;
    names.push_back(f.file_name);
  }
  EXPECT_EQ(
      names.size(),
      3u * 2 + 1 + 2 + 2 + 3);  // random and transient of machine, seat and ground; run-up, Campbell, waterfall; …
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(ResultFigures, NameQuantityAndUnitOnTheirAxes) {
  const auto all = report::result_figures(variant(), everything());
  const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
      {"random-01", {"f [Hz]", "displacement density [mm²/Hz]", "rotation density [mrad²/Hz]"}},
      {"random-03", {"force density [kN²/Hz]", "moment density [(kN m)²/Hz]"}},
      {"transient-01", {"t [ms]", "displacement [mm]", "rotation [mrad]"}},
      {"orders-01", {"shaft speed [rpm]", "displacement [µm rms]", "rotation [µrad rms]"}},
      {"campbell", {"shaft speed [rpm]", "frequency [Hz]"}},
      {"waterfall", {"shaft speed [rpm]", "frequency [Hz]", "displacement amplitude [µm rms]"}},
      {"transmissibility", {"f [Hz]", "transmissibility [dB]"}},
      {"power", {"f [Hz]", "mean power ["}},
      {"shock", {"natural frequency [Hz]", "absolute acceleration [m/s²]"}},
      {"limit", {"f [Hz]", "velocity, rms [mm/s]"}},
      {"shape", {"front<", "isometric<", "Grey: at rest."}}};
  for (const auto& [file, labels] : expected)
    for (const std::string& label : labels)
      EXPECT_NE(figure(all, file).svg.find(">" + label), std::string::npos) << file << ": " << label;
}

TEST(ResultFigures, DrawOneLinePerCurve) {
  const auto all = report::result_figures(variant(), everything());
  for (const char* six_curves : {"random-01", "random-03", "transient-01", "transient-02", "transient-03"})
    EXPECT_EQ(count(figure(all, six_curves).svg, "<polyline"), 6) << six_curves;
  constexpr int leaves_its_panel = 1;  // a weak order, below its logarithmic axis for a while
  EXPECT_EQ(
      count(figure(all, "orders-01").svg, "<polyline"),
      (6 + 3 + 6) * (1 + 4) + leaves_its_panel);  // all orders, and each of the four; the seat turns as the machine
  EXPECT_EQ(count(figure(all, "transmissibility").svg, "<polyline"), 5);  // in total and by four mounts
  EXPECT_EQ(count(figure(all, "shock").svg, "<polyline"), 3);
  EXPECT_EQ(count(figure(all, "limit").svg, "<polyline"), 2);
}

TEST(ResultFigures, AreMissingWithoutResults) {
  EXPECT_TRUE(report::result_figures(variant(), {}).empty());
  EXPECT_EQ(report::result_sections(variant(), {}), "");
}

TEST(ResultFigures, RigidGroundAbsorbsNoPowerAndHasNoFigure) {
  study::CaseResults results;
  response::PowerFlow power = *everything().power;
  power.into_ground.setZero();
  power.into_ground_in_total.setZero();
  results.power = power;
  EXPECT_TRUE(report::power_figures(results).empty());
}

TEST(ResultFigures, UndefinedValuesInterruptTheCurve) {
  study::CaseResults results;
  study::RandomResult random = *everything().random;
  auto& density = random.curves.density.front();
  density[density.size() / 4] = std::numeric_limits<double>::quiet_NaN();
  results.random = random;
  EXPECT_EQ(count(report::random_figures(results).front().svg, "<polyline"), 7);
}

TEST(ResultSections, ContainTheFiguresAndTheKeyNumbers) {
  const std::string html = report::result_sections(variant(), everything());
  EXPECT_EQ(xml_fault(html), "");
  int pictures = 0;
  for (const report::Figure& figure : report::result_figures(variant(), everything()))
    pictures += count(figure.html(), "<svg");
  EXPECT_EQ(count(html, "<svg"), pictures);
  for (const char* title : {"Random response", "Time history", "Run-up", "Transmissibility", "Power into the ground",
                            "Shock response spectrum", "Limit lines", "Operating shapes"})
    EXPECT_THAT(html, HasSubstr("<h2>" + std::string(title) + "</h2>"));
  EXPECT_THAT(html, HasSubstr("upward zero crossings"));
  EXPECT_THAT(html, HasSubstr("speed\u00a0[rpm]"));
}

TEST(VisiblePieces, AreCutExactlyAtTheEdgesOfThePanel) {
  const report::PlotPanel panel{{0, 0}, 100, 100, {0, 10, false, ""}, {0, 1, false, ""}};
  const auto pieces = report::visible_pieces(panel, {0, 4, 8, 10}, {0, 2, 0, 0.5});
  ASSERT_EQ(pieces.size(), 2u);  // above the upper edge from 2 to 6
  EXPECT_NEAR(pieces[0].back().x, 20, round_off);
  EXPECT_NEAR(pieces[0].back().y, 0, round_off);
  EXPECT_NEAR(pieces[1].front().x, 60, round_off);
  EXPECT_NEAR(pieces[1].back().y, 50, round_off);
}

TEST(VisiblePieces, ThinManyPointsButKeepASingleHighOne) {
  const report::PlotPanel panel{{0, 0}, 100, 100, {0, 1, false, ""}, {0, 1, false, ""}};
  std::vector<double> x, y;
  for (int i = 0; i <= 100'000; ++i) {
    x.push_back(i / 1e5);
    y.push_back(i == 54'321 ? 0.9 : 0.1);
  }
  const auto pieces = report::visible_pieces(panel, x, y);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LT(pieces[0].size(), 10u);
  EXPECT_NEAR(std::ranges::min_element(pieces[0], [](const auto& a, const auto& b) { return a.y < b.y; })->y, 10,
              round_off);
}

/// A path that comes back on itself keeps its turning points.
TEST(VisiblePieces, KeepTheEndsOfAPathAlongALine) {
  const report::PlotPanel panel{{0, 0}, 100, 100, {-1, 1}, {-1, 1}};
  std::vector<double> x, y;
  for (int i = 0; i <= 100; ++i) {
    x.push_back(0.3 + 1e-6 * i);
    y.push_back(0.8 * std::sin(2 * std::numbers::pi * i / 100));
  }
  const auto pieces = report::visible_pieces(panel, x, y);
  ASSERT_EQ(pieces.size(), 1u);
  const auto [low, high] =
      std::minmax_element(pieces[0].begin(), pieces[0].end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  EXPECT_NEAR(high->y - low->y, 80, 0.1);
}

/// Only if it is of the same result in the same unit.
TEST(SteadyFigure, HasTheFreeMotionsOverTheForcedOnes) {
  const auto figure = [](const std::string& quantity) {
    const project::Project project = test::project(R"(trivet = 1
[bodies.m]
mass = 1.5
free = ["x"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [600, 0, 0]
damping = {translation = [1, 0, 0]}
laws.x = {cubic = 2e5}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [1, 0, 0]
[analyses]
steady = {of = ["m.x"], band = [10, 30], harmonics = 3}
backbone = {of = ["m.x"], up_to = "0.1 m", harmonics = 3, quantity = ")" +
                                                   quantity + "\"}\n");
    return report::steady_figures(study::case_results(project.base(), project.base().analyses)).at(0).svg;
  };
  EXPECT_EQ(count(figure("displacement"), "nonlinear mode, free"), 1);
  EXPECT_EQ(count(figure("velocity"), "nonlinear mode, free"), 0);
}

constexpr const char* whirling = R"(trivet = 1
[bodies.m]
mass = 2
free = ["x", "y"]
[elements.spring]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [800, 1000, 0]
damping = {translation = [2, 2, 0]}
laws.x = {cubic = 2e5, quadratic = 5e3}
[excitations.f]
type = "harmonic"
on = "m"
at = [0, 0, 0]
force = [1, 1, 0]
phase = [0, "-90 deg", 0, 0, 0, 0]
[analyses.steady]
band = [10, 30]
harmonics = 5
)";

/// Two coordinates: their plane; one: its velocity over it. Forces have none, nor has a body at rest.
TEST(OrbitFigure, HasThePathsOfTheLargestMotionAndOfJumps) {
  const auto figures = [](const std::string& keys) {
    const project::Project project = test::project(whirling + keys);
    return report::orbit_figures(study::case_results(project.base(), project.base().analyses));
  };
  const std::vector<report::Figure> both = figures("of = [\"m\"]\n");
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(count(both[0].svg, "largest stable motion"), 1);
  EXPECT_GE(count(both[0].svg, "before a jump"), 1);
  EXPECT_EQ(count(both[0].svg, "before a jump"), count(both[0].svg, "after it"));
  EXPECT_EQ(count(both[0].svg, ">y [mm]<"), 1);
  const std::vector<report::Figure> one = figures("of = [\"m.x\"]\n");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(count(one[0].svg, "velocity of x ["), 1);
  EXPECT_TRUE(figures("of = [\"spring.force.x\"]\n").empty());
  const std::string idle =
      "of = [\"m.x\", \"still\"]\n[bodies.still]\nmass = 1\nfree = [\"x\", \"y\"]\n"
      "[elements.foot]\ntype = \"three_springs\"\non = \"still\"\nat = [0, 0, 0]\n"
      "translation = [100, 100, 0]\n";
  EXPECT_EQ(figures(idle).size(), 1u);
}

TEST(ObservedMotion, HasTheExtremesOfItsCourse) {
  const project::Project project = test::project(std::string(whirling) + "of = [\"m.x\"]\n");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  const auto& branch = *results.steady;
  const nonlinear::ObservedMotion& motion = branch.points[branch.points.size() / 2].results[0];
  constexpr int samples = 4000;
  constexpr double step = 1e-4;
  double largest = -INFINITY, smallest = INFINITY;
  for (int s = 0; s < samples; ++s) {
    const double phase = 2 * std::numbers::pi * s / samples, value = motion.value_at(phase);
    largest = std::max(largest, value);
    smallest = std::min(smallest, value);
    EXPECT_NEAR(motion.slope_at(phase), (motion.value_at(phase + step) - motion.value_at(phase - step)) / (2 * step),
                1e-6 * motion.half_of_range());
  }
  EXPECT_NEAR(largest, motion.largest, 1e-5 * motion.half_of_range());
  EXPECT_NEAR(smallest, motion.smallest, 1e-5 * motion.half_of_range());
}

}  // namespace result_figures_test
