// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/response/design_family.h"
#include "trivet/study/design_map.h"
#include "trivet/study/map_json.h"

namespace {

using namespace trivet;

/// A machine on one spring, free along z; the map is added by each test.
std::string machine(const std::string& map, const std::string& further = "") {
  return R"(
trivet = 1
[bodies.machine]
mass = 10
free = ["z"]
points.seat = [0, 0, 0.1]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1000, 1000, 1000]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 10]
)" + further + "[analyses]\n" + map;
}

const std::string two_axes = "x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 5}, "
                             "y = {parameter = \"elements.spring.damping.proportional\", from = 0.01, to = 0.3, points = 4}";

TEST(MapReader, TakesTheLimitsAndTheQuantityOfTheFileWhereTheMapIsSilent) {
  const study::Project project = test::project(machine("response = {quantity = \"velocity\", band = [0, 30]}\nmap = {" + two_axes + "}\n", "[limits]\n\"machine.z\" = \"20 mm/s\"\n"));
  const study::MapRequest& map = *project.base().analyses.map;
  ASSERT_EQ(map.limits.size(), 1u);
  EXPECT_EQ(map.limits[0].name, "machine.z");
  EXPECT_EQ(map.limits[0].quantity, assembly::Quantity::velocity);
  EXPECT_DOUBLE_EQ(map.limits[0].amplitude, 0.02);
  EXPECT_DOUBLE_EQ(map.band->to, 30);
}

TEST(MapReader, TellsDisplacementVelocityAndAccelerationByTheUnit) {
  const study::Project project = test::project(machine("map = {" + two_axes + ", limits = {\"machine.z\" = [\"3 mm\", \"0.2 m/s2\"], \"machine.seat.z\" = \"1 cm/s\"}}\n"));
  const auto& limits = project.base().analyses.map->limits;
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[0].quantity, assembly::Quantity::displacement);
  EXPECT_EQ(limits[1].quantity, assembly::Quantity::acceleration);
  EXPECT_EQ(limits[2].quantity, assembly::Quantity::velocity);
}

TEST(MapAxis, MeetsItsEndsExactlyOnBothSpacings) {
  for (const bool logarithmic : {false, true}) {
    const study::MapAxis axis{"", "", 0.3, 10, "", logarithmic, 101};
    EXPECT_EQ(axis.at(0), 0.3);
    EXPECT_EQ(axis.at(1), 10);
    EXPECT_NEAR(axis.share(axis.at(0.37)), 0.37, 1e-14);
  }
}

TEST(DesignMap, GivesEveryDesignItsGoverningRuleAndMargin) {
  const study::Project project = test::project(machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"15 mm\"}, no_peak = \"coordinates\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.outcomes.size(), 20u);
  EXPECT_EQ(map.unknown, 0u);
  std::size_t shares = 0;
  for (const study::RuleShare& share : map.shares) shares += share.kept + share.broken;
  EXPECT_EQ(shares, 20u);
  ASSERT_TRUE(map.best);
  for (const study::DesignOutcome& outcome : map.outcomes) EXPECT_LE(outcome.margin, map.outcomes[*map.best].margin);
}

TEST(DesignMap, TakesOneNumberEachOfTwoElements) {
  const std::string second = "[elements.pad]\ntype = \"bushing\"\non = \"machine\"\nat = [0, 0, 0]\ntranslation = [500, 500, 500]\n";
  const study::Project project = test::project(machine("map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 3}, y = {parameter = \"elements.pad.scale\", from = 1, to = 2, "
                                                       "points = 3}, limits = {\"machine.z\" = \"15 mm\"}}\n", second));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.unknown, 0u);
  EXPECT_EQ(map.outcomes.size(), 9u);
}

TEST(DesignMap, SaysWhyADesignHasNoModelAndGoesOn) {
  const study::Project project = test::project(machine("map = {x = {parameter = \"bodies.machine.mass\", from = -5, to = 15, points = 5}, y = {parameter = \"elements.spring.scale\", from = 1, to = 2, "
                                                       "points = 2}, no_peak = \"coordinates\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.unknown, 4u);  // −5 and 0 kg
  ASSERT_FALSE(map.report.missing.empty());
  EXPECT_THAT(map.report.missing.front().words, testing::HasSubstr("mass = -5 kg; a mass must be > 0"));
  EXPECT_FALSE(map.outcomes[0].kept());
}

TEST(DesignMap, RefusesAParameterThatMakesEveryDesignImpossible) {
  const study::Project project = test::project(machine("map = {x = {parameter = \"bodies.machine.mass\", from = -5, to = -1, points = 3}, y = {parameter = \"elements.spring.scale\", from = 1, to = 2, "
                                                       "points = 2}, no_peak = \"coordinates\"}\n"));
  EXPECT_THAT([&] { static_cast<void>(study::design_map(project, project.base(), *project.base().analyses.map)); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("none of the 6 designs")));
}

TEST(DesignMap, JudgesElementsWithLossFactorsOneByOneAndSaysSo) {
  const std::string text = machine("map = {x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 3}, y = {parameter = \"bodies.machine.mass\", from = 5, to = 20, points = 3}, "
                                   "no_peak = \"coordinates\"}\n");
  const study::Project project = test::project(text, {"elements.spring.damping={loss_factor=0.1}"});
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.report.proven + map.report.redone, 0u);
  EXPECT_EQ(map.report.one_by_one, 9u);
  EXPECT_THAT(map.report.words(), testing::HasSubstr("loss factors"));
}

TEST(DesignMap, JudgesDesignsAndCasesOneByOneOnAnyNumberOfThreadsAlikeAndTellsHowFarItIs) {
  std::string cases;
  for (int k = 0; k < 12; ++k) cases += fmt::format("[cases.c{}]\nelements.spring.scale = {}\n", k, 0.6 + 0.1 * k);
  const study::Project project = test::project(machine("map = {" + two_axes + ", limits = {\"spring.force.z\" = 25}}\n", cases));
  std::vector<std::string> tasks, texts;
  const foundation::Progress progress = [&](std::string_view task, double) { tasks.emplace_back(task); };
  for (const int threads : {1, 4}) {
    const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map, {0, 0, {threads, true}}, progress);
    EXPECT_EQ(map.report.one_by_one, 20u);
    std::string text;
    study::write_map_json(project, map, [&](std::string_view piece) { text += piece; });
    texts.push_back(text);
  }
  EXPECT_EQ(texts[0], texts[1]);
  for (const char* task : {"designs", "boundary", "cases"}) EXPECT_THAT(tasks, testing::Contains(task));
  EXPECT_GE(std::count(tasks.begin(), tasks.end(), "designs"), 20);  // with one thread after each
}

TEST(DesignMap, MarksCasesThatAreDesignsOfTheMap) {
  const study::Project project = test::project(machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n",
                                                       "[cases.stiff]\nelements.spring.scale = 1.5\nelements.spring.damping.proportional = 0.1\n"
                                                       "[cases.nominal]\nelements.spring.scale = 1.5\nelements.spring.damping = {proportional = 0.1, of = \"nominal\"}\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.marks.size(), 3u);
  EXPECT_EQ(map.marks[0].name, "");  // no scale is written: it is 1
  EXPECT_DOUBLE_EQ(*map.marks[0].x, 1);
  EXPECT_TRUE(map.marks[0].of_this_model);
  EXPECT_TRUE(map.marks[1].of_this_model);
  EXPECT_FALSE(map.marks[2].of_this_model);  // its damping is another
}

/// A pad measured from 5 to 100 Hz, as rigs do.
std::string measured_pad(const foundation::TemporaryFolder& folder) {
  const std::string file = (folder.path() / "pad.csv").string();
  std::ofstream(file) << "frequency_hz,k_z,k_z_loss\n5,800,80\n20,900,150\n100,1200,300\n";
  return "[elements.pad]\ntype = \"table\"\non = \"machine\"\nat = [0, 0, 0]\naxis = \"z\"\nfile = '" + file + "'\n";
}

TEST(DesignMap, JudgesAndPlacesCasesWithATableThatStartsAboveOneRadianPerSecond) {
  const foundation::TemporaryFolder folder;
  const study::Project project = test::project(machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"1 mm\"}, band = [\"6 Hz\", \"50 Hz\"]}\n",
                                                       measured_pad(folder) + "[cases.stiff]\nelements.spring.scale = 1.5\n[cases.heavy]\nelements.spring.scale = 1.2\nbodies.machine.mass = 20\n"));
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  ASSERT_EQ(map.marks.size(), 3u);
  for (const study::MapMark& mark : map.marks) EXPECT_TRUE(mark.judged) << mark.name << ": " << mark.failure;
  EXPECT_TRUE(map.marks[0].of_this_model);
  EXPECT_TRUE(map.marks[1].of_this_model);
  EXPECT_FALSE(map.marks[2].of_this_model);
}

/// Natural frequencies of 10⁷ and 10⁻⁶ rad/s.
TEST(DesignMap, TellsModelsApartWhereTheirOwnMassAndStiffnessMatter) {
  for (const double stiffness : {1e15, 1e-11}) {
    const study::Project project = test::project(machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n", fmt::format(R"(
[cases.same]
elements.spring.scale = 1.5
[cases.heavier]
elements.spring.scale = 1.4
bodies.machine.mass = 10.001
[cases.stiffer]
elements.spring.scale = 1.3
elements.spring.translation = [{0}, {0}, {1}]
)", stiffness, 1.001 * stiffness)), {fmt::format("elements.spring.translation=[{0}, {0}, {0}]", stiffness)});
    const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
    for (const study::MapMark& mark : map.marks) EXPECT_EQ(mark.of_this_model, mark.name.empty() || mark.name == "same") << mark.name << " " << stiffness;
  }
}

TEST(DesignMap, PlacesCasesWhoseTableStartsAboveAllNaturalFrequencies) {
  const foundation::TemporaryFolder folder;
  const study::Project project = test::project(machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"1 mm\"}}\n", measured_pad(folder) + "[cases.stiff]\nelements.spring.scale = 1.5\n"));
  for (const study::MapMark& mark : study::design_map(project, project.base(), *project.base().analyses.map).marks) EXPECT_TRUE(mark.of_this_model) << mark.name;
}

/// ζ = 0.25 at 10 rad/s: the peak stands at 10 √(1 − 2ζ²), the static deflection is 10 mm, and the acceleration tends to F/m = 1 m/s².
TEST(DesignMap, TellsWhereACaseGoesBeyondItsLimits) {
  const auto words = [&](const std::vector<std::string>& settings) {
    const study::Project changed = test::project(machine("map = {" + two_axes + ", limits = {\"machine.z\" = \"15 mm\"}}\n"), settings);
    const study::DesignMap map = study::design_map(changed, changed.base(), *changed.base().analyses.map);
    return study::verdict_words(map, map.marks.at(0)).at(0);
  };
  EXPECT_THAT(words({}), testing::MatchesRegex("machine.z reaches 0.02066 m at 9.354 rad/s, allowed 0.015"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"5 mm\"}", "analyses.map.band=[0, 1]"}), testing::HasSubstr(" at 1 rad/s, allowed 0.005"));
  EXPECT_THAT(words({"analyses.map.limits={\"machine.z\"=\"0.9 m/s2\"}", "elements.spring.damping.proportional=0.3"}), testing::HasSubstr(" m/s² towards ω = ∞, allowed 0.9"));
}

TEST(DesignMap, WritesOneCsvRowPerDesign) {
  const study::Project project = test::project(machine("map = {" + two_axes + ", no_peak = \"coordinates\"}\n"));
  const std::string csv = study::map_csv(study::design_map(project, project.base(), *project.base().analyses.map));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 21);
  EXPECT_THAT(csv, testing::StartsWith("elements.spring.scale,elements.spring.damping.proportional,margin,governing,kept\n0.5,0.01,"));
}

// Contours of regions that are known: a disc, its ring, two touching corners.

study::MapContours contours_of(const study::MapGrid& grid, const std::function<double(study::MapPlace)>& level, bool connected = false) {
  const std::function<bool(std::size_t)> inside = [&](std::size_t k) { return level(grid.place(static_cast<int>(k) % grid.nx, static_cast<int>(k) / grid.nx)) >= 0; };
  const auto edges = study::crossed_edges(grid, inside);
  std::vector<double> crossing;
  for (const study::CrossedEdge& e : edges) {
    const double a = level(grid.place(e.i, e.j)), b = level(e.upwards ? grid.place(e.i, e.j + 1) : grid.place(e.i + 1, e.j));
    crossing.push_back(a / (a - b));
  }
  return study::contours(grid, inside, edges, crossing, [&](int, int) { return connected; });
}

TEST(MapContours, GiveTheAreaOfADiscAndOfItsOutside) {
  const auto disc = [](study::MapPlace p) { return 0.3 - std::hypot(p.x - 0.5, p.y - 0.5); };
  const study::MapContours inside = contours_of({201, 201}, disc), outside = contours_of({201, 201}, [&](study::MapPlace p) { return -disc(p); });
  constexpr double chords = 1e-4;  // a polygon of about 240 sides
  EXPECT_NEAR(inside.area, M_PI * 0.09, chords);
  EXPECT_NEAR(outside.area, 1 - M_PI * 0.09, chords);
  ASSERT_EQ(inside.lines.size(), 1u);
  EXPECT_EQ(inside.lines[0].front().x, inside.lines[0].back().x);
  EXPECT_EQ(outside.rings.size(), 2u);  // the frame and the hole
}

TEST(MapContours, EndTheirLinesOnTheFrame) {
  const study::MapContours half = contours_of({11, 11}, [](study::MapPlace p) { return p.x - 0.42; });
  ASSERT_EQ(half.lines.size(), 1u);
  EXPECT_NEAR(half.area, 0.58, 1e-12);
  EXPECT_NEAR(std::abs(half.lines[0].front().y - half.lines[0].back().y), 1, 1e-12);
  for (const study::MapPlace& p : half.lines[0]) EXPECT_NEAR(p.x, 0.42, 1e-12);
}

TEST(MapContours, ConnectOppositeCornersOnlyWhereToldTo) {
  const auto saddle = [](study::MapPlace p) { return (p.x - 0.5) * (p.y - 0.5); };
  EXPECT_EQ(contours_of({2, 2}, saddle, false).rings.size(), 2u);
  EXPECT_EQ(contours_of({2, 2}, saddle, true).rings.size(), 1u);
}

TEST(MapContours, OfEverythingIsTheFrame) {
  const study::MapContours all = contours_of({5, 4}, [](study::MapPlace) { return 1.0; });
  EXPECT_NEAR(all.area, 1, 1e-15);
  EXPECT_TRUE(all.lines.empty());
}

// Families of matrices.

response::PlainDesign design_of(double k, double b) {
  response::PlainDesign design;
  design.A = Eigen::MatrixXd::Identity(2, 2);
  design.K = (Eigen::MatrixXd(2, 2) << 3 + k, -1, -1, 2).finished();
  design.B = b * design.K;
  design.load = Eigen::Vector2d(1, k);
  design.rows = Eigen::MatrixXd::Identity(2, 2);
  design.rows_on_velocity = Eigen::MatrixXd::Zero(2, 2);
  design.derivative = {0, 0};
  return design;
}

TEST(DesignFamily, ReproducesDesignsBetweenItsNodes) {
  const auto family = response::DesignFamily::fitted([](const response::FamilyPoint& p) { return response::PlainOrNot{design_of(p.x * p.x, p.y), ""}; }, {0.3, 10, "x"}, {0.01, 0.5, "y"}).family;
  ASSERT_TRUE(family);
  EXPECT_EQ(family->x_nodes(), 3u);  // x² and x² y
  EXPECT_EQ(family->y_nodes(), 2u);
  const std::vector<response::FamilyPoint> points = {{0.7, 0.2}, {5.1, 0.2}, {9.9, 0.43}};
  const numerics::Designs designs = family->designs(points);
  for (std::size_t d = 0; d < points.size(); ++d) {
    const response::PlainDesign exact = design_of(points[d].x * points[d].x, points[d].y);
    const auto row = static_cast<Eigen::Index>(d);
    EXPECT_NEAR(designs.K(row, 0), exact.K(0, 0), 1e-13 * exact.K(0, 0));
    EXPECT_NEAR(designs.B(row, 1), exact.B(1, 0), 1e-13 * exact.B(0, 0));
    EXPECT_NEAR(designs.load(row, 1), exact.load(1), 1e-13 * exact.load(1));
  }
}

TEST(DesignFamily, TakesLogarithmsWhereTheseAreSmoother) {
  const auto family = response::DesignFamily::fitted([](const response::FamilyPoint& p) { return response::PlainOrNot{design_of(std::log(p.x), p.y), ""}; }, {1, 1000, "x"}, {0.01, 0.5, "y"}).family;
  ASSERT_TRUE(family);
  EXPECT_EQ(family->x_nodes(), 2u);
}

TEST(DesignFamily, RefusesAKinkAndNamesTheNumber) {
  const auto along_x = [](const response::FamilyPoint& p) { return response::PlainOrNot{design_of(std::abs(p.x - 3.3), p.y), ""}; };
  const auto along_y = [](const response::FamilyPoint& p) { return response::PlainOrNot{design_of(p.x, std::max(p.y, 0.2)), ""}; };
  const auto of_x = response::DesignFamily::fitted(along_x, {0.3, 10, "length"}, {0.01, 0.5, "delta"}), of_y = response::DesignFamily::fitted(along_y, {0.3, 10, "length"}, {0.01, 0.5, "delta"});
  EXPECT_FALSE(of_x.family);
  EXPECT_FALSE(of_y.family);
  EXPECT_THAT(of_x.reason, testing::EndsWith("smoothly on length"));
  EXPECT_THAT(of_y.reason, testing::EndsWith("smoothly on delta"));
}

TEST(DesignFamily, RefusesRowsThatChangeAndSaysSo) {
  const auto changing = [](const response::FamilyPoint& p) {
    response::PlainDesign design = design_of(p.x, p.y);
    design.rows(0, 0) = p.x;
    return response::PlainOrNot{design, ""};
  };
  const auto found = response::DesignFamily::fitted(changing, {0.3, 10, "x"}, {0.01, 0.5, "y"});
  EXPECT_FALSE(found.family);
  EXPECT_THAT(found.reason, testing::HasSubstr("rows change from design to design"));
}

TEST(DesignFamily, TellsWhyADesignInTheMiddleIsNotPlain) {
  const auto lossy = [](const response::FamilyPoint& p) { return p.x > 5 ? response::PlainOrNot{{}, "loss factors"} : response::PlainOrNot{design_of(p.x, p.y), ""}; };
  EXPECT_EQ(response::DesignFamily::fitted(lossy, {0.3, 10, "x"}, {0.01, 0.5, "y"}).reason, "loss factors");
}

TEST(MissingKinds, AreMessagesWithoutTheirNumbers) {
  EXPECT_EQ(study::without_numbers("mass = -5.25e-3 kg of mount2; a mass must be > 0"), "mass = # kg of mount2; a mass must be > #");
  EXPECT_EQ(study::without_numbers("eigenvalues 1.5, 3 and 4e+05"), study::without_numbers("eigenvalues -2, 77.125 and 1"));
  EXPECT_NE(study::without_numbers("element a1: 3"), study::without_numbers("element a2: 3"));
}

/// A body whose inertia breaks the triangle inequality, each design by other figures.
TEST(DesignMap, GroupsDesignsWithoutAModelByKind) {
  const study::Project project = test::project(R"(
trivet = 1
[bodies.block]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[elements.mount]
type = "bushing"
on = "block"
at = [0.1, 0.2, 0.3]
translation = [900, 1100, 1300]
rotation = [90, 80, 70]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "block"
at = [0, 0, 0]
force = [1, 2, 3]
[analyses.map]
x = {parameter = "bodies.block.inertia.xx", from = 1, to = 9, points = 9}
y = {parameter = "bodies.block.mass", from = -10, to = 20, points = 7}
no_peak = "coordinates"
)");
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  std::size_t missing = 0;
  for (const study::MissingReason& reason : map.report.missing) missing += reason.designs;
  EXPECT_EQ(missing, map.unknown);
  EXPECT_GT(map.unknown, 20u);
  EXPECT_LE(map.report.missing.size(), 3u);
}

TEST(DesignMap, CountsDesignsByTheWayTheyWereJudged) {
  const study::Project project = *study::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/map.toml");
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map, {30, 30, {}});
  EXPECT_EQ(map.report.proven + map.report.redone + map.report.one_by_one, 900u);
  EXPECT_GT(map.report.proven, 800u);
}

const std::string with_cases = R"(
trivet = 1
[bodies.machine]
mass = 10
free = ["z"]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1000, 1000, 1000]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 10]
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.5, to = 2, points = 3}
y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 3}
no_peak = "coordinates"
[cases.point]
elements.spring.scale = 1.5
[cases.heavy]
bodies.machine.mass = 20
[cases.strict]
analyses.map.peak_tolerance = 0
)";

TEST(DesignMap, OfACaseIsItsOwnWhereTheCaseChangesTheQuestion) {
  const study::Project project = test::project(with_cases);
  EXPECT_TRUE(study::has_own_map(project, project.base()));
  EXPECT_FALSE(study::has_own_map(project, *project.find("point")));
  EXPECT_FALSE(study::has_own_map(project, *project.find("heavy")));
  EXPECT_TRUE(study::has_own_map(project, *project.find("strict")));
}

TEST(DesignMap, SaysThatRowsOfAnswersChangeWhereTheyForbidTheFastWay) {
  const study::Project project = test::project(with_cases, {"analyses.map.limits={\"spring.force.z\"=30}"});
  const study::DesignMap map = study::design_map(project, project.base(), *project.base().analyses.map);
  EXPECT_EQ(map.report.one_by_one, 9u);
  EXPECT_THAT(map.report.words(), testing::HasSubstr("rows change from design to design"));
}

}  // namespace
