// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "support/matchers.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/project.h"

namespace units_in_rows_test {

using namespace trivet;
using testing::AllOf;
using testing::HasSubstr;

constexpr double round_off = 1e-12, pi = std::numbers::pi, g = 9.80665;

/// A folder of this test with a project, and files beside it.
class UnitsInRows : public testing::Test {
 protected:
  UnitsInRows() { std::filesystem::create_directory(folder_); }
  ~UnitsInRows() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  [[nodiscard]] foundation::Expected<project::Project> read(const std::string& parts) const {
    write("machine.toml", R"(
trivet = 1
[bodies.box]
mass = 200
free = ["z"]
[elements.s]
type = "three_springs"
on = "box"
at = [0, 0, 0]
translation = [0, 0, "800 N/mm"]
damping = {translation = [0, 0, 2000]}
[excitations.f]
type = "harmonic"
on = "box"
at = [0, 0, 0]
force = [0, 0, "1 kN"]
)" + parts);
    return judging::read_project((folder_ / "machine.toml").string());
  }

  [[nodiscard]] std::string errors(const std::string& parts) const {
    const auto found = read(parts);
    std::string text;
    if (!found)
      for (const foundation::Problem& problem : found.error().list()) text += foundation::message(problem) + "\n";
    return text;
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("trivet-units-in-rows-{}", ::getpid());
};

constexpr const char* line_of_velocity =
    "[analyses]\nresponse = {quantity = \"velocity\", band = [\"5 Hz\", \"50 Hz\"]}\n"
    "[limit_lines.class]\nof = \"box.z\"\nquantity = \"velocity\"\n";

TEST_F(UnitsInRows, LimitLinesHaveThemInRowsHeadingsAndAKey) {
  write("bracket.csv", "frequency [rad/s],limit [mm/s]\n62.8318530717959,4.5\n314.159265358979,4.5\n");
  write("plain.csv", "frequency_hz,limit\n10,4.5\n50,4.5\n");
  for (const char* rows :
       {"rows = [[\"10 Hz\", \"4.5 mm/s\"], [\"50 Hz\", \"4.5 mm/s\"]]\n", "rows = [[10, 4.5e-3], [50, 4.5e-3]]\n",
        "rows = [[10, 4.5], [50, 4.5]]\nunit = \"mm/s\"\n", "rows = [[\"600 rpm\", 4.5e-3], [\"3000 rpm\", 4.5e-3]]\n",
        "file = \"bracket.csv\"\n", "file = \"plain.csv\"\nunit = \"mm/s\"\n"}) {
    const auto project = read(std::string(line_of_velocity) + rows);
    ASSERT_TRUE(project.has_value()) << rows << errors(std::string(line_of_velocity) + rows);
    const assembly::LimitLine& line = project->base().analyses.limit_lines.front().line;
    EXPECT_THAT(line.angular_frequency.front(), test::RelativelyNear(20 * pi, round_off)) << rows;
    EXPECT_THAT(line.angular_frequency.back(), test::RelativelyNear(100 * pi, round_off)) << rows;
    for (const double limit : line.limit) EXPECT_THAT(limit, test::RelativelyNear(4.5e-3, round_off)) << rows;
  }
}

TEST_F(UnitsInRows, WrongAndMixedUnitsAreErrorsThatNameTheUnitOfBareNumbers) {
  const std::string line = line_of_velocity;
  EXPECT_THAT(errors(line + "rows = [[10, \"4.5 mm\"], [50, \"4.5 mm\"]]\n"),
              AllOf(HasSubstr("limit_lines.class.rows[0][1]"), HasSubstr("converts to m/s")));
  EXPECT_THAT(errors(line + "rows = [[10, \"4.5 mm/s\"], [50, 4.5]]\n"),
              AllOf(HasSubstr("1 numbers of column 2 have a unit and 1 have none"), HasSubstr("bare ones are in m/s")));
  EXPECT_THAT(errors(line + "rows = [[\"10 Hz\", 4.5], [50, 4.5]]\n"), HasSubstr("bare ones are in Hz"));
  EXPECT_THAT(errors(line + "rows = [[10, 4.5], [50, 4.5]]\nunit = \"mm\"\n"), HasSubstr("limit_lines.class.unit"));
  write("wrong.csv", "frequency_hz,limit [N]\n10,4.5\n50,4.5\n");
  EXPECT_THAT(errors(line + "file = \"wrong.csv\"\n"), AllOf(HasSubstr("limit [N]"), HasSubstr("converts to m/s")));
  write("twice.csv", "frequency_hz,limit [m/s],limit [mm/s]\n10,4.5,4.5\n50,4.5,4.5\n");
  const std::string twice = errors(line + "file = \"twice.csv\"\n");
  EXPECT_THAT(twice, AllOf(HasSubstr("limit [mm/s]"), HasSubstr("another column is \"limit\"")));
  EXPECT_EQ(std::ranges::count(twice, '\n'), 1) << twice;
  write("cell.csv", "frequency_hz,limit\n10,4.5 mm/s\n50,4.5 mm/s\n");
  EXPECT_THAT(errors(line + "file = \"cell.csv\"\n"), HasSubstr("its unit is in the heading: NAME [unit]"));
}

TEST_F(UnitsInRows, SpectraAndHistoriesHaveThem) {
  write("psd.csv", "frequency_hz,psd [g^2/Hz]\n10,0.04\n100,0.04\n");
  const std::string random =
      "[excitations.road]\ntype = \"random\"\nbase = true\ntranslation = [0, 0, 1]\nquantity = \"acceleration\"\n"
      "[analyses]\nrandom = {}\n[excitations.road.psd]\n";
  for (const char* given : {"rows = [[\"10 Hz\", \"0.04 g^2/Hz\"], [\"100 Hz\", \"0.04 g^2/Hz\"]]\n",
                            "rows = [[10, 0.04], [100, 0.04]]\nunit = \"g^2/Hz\"\n", "file = \"psd.csv\"\n",
                            "flat = \"0.04 g^2/Hz\"\nband = [\"10 Hz\", \"100 Hz\"]\n"}) {
    const auto project = read(random + given);
    ASSERT_TRUE(project.has_value()) << given << errors(random + given);
    const auto& course = project->base().system.description().excitations.back().course;
    const double density = excitation::density(std::get<model::Random>(course).spectrum, 2 * pi * 50);  // per rad/s
    EXPECT_THAT(2 * pi * density, test::RelativelyNear(0.04 * g * g, 1e-9)) << given;
  }
  write("push.csv", "time [ms],value [kN]\n0,0\n10,2\n20,0\n");
  const std::string in_time =
      "[excitations.push]\ntype = \"time\"\non = \"box\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n"
      "[excitations.push.history]\n";
  for (const char* given : {"rows = [[0, 0], [\"10 ms\", \"2 kN\"], [\"20 ms\", 0]]\n", "file = \"push.csv\"\n",
                            "rows = [[0, 0], [0.01, 2], [0.02, 0]]\nunit = \"kN\"\n"}) {
    const auto project = read(in_time + given);
    ASSERT_TRUE(project.has_value()) << given << errors(in_time + given);
    const auto& course = project->base().system.description().excitations.back().course;
    const excitation::Signal& signal = std::get<model::History>(course).signal;
    EXPECT_THAT(excitation::state(signal, 0.005).value, test::RelativelyNear(1000, 1e-9)) << given;
  }
}

TEST_F(UnitsInRows, BracketsWithoutAUnitBelongToTheNameOfAColumn) {
  write("named.csv", "Zeit (s),acc (filtered)\n0,0\n0.01,2\n0.02,0\n");
  const std::string parts =
      "[excitations.push]\ntype = \"time\"\non = \"box\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n"
      "history = {file = \"named.csv\", time = \"Zeit (s)\", value = \"acc (filtered)\"}\n";
  EXPECT_EQ(errors(parts), "");
}

TEST_F(UnitsInRows, SpectraOfEarthquakesHaveThem) {
  for (const char* given :
       {"rows = [[\"100 ms\", \"0.3 g\"], [\"2 s\", \"0.1 g\"]]", "rows = [[0.1, 0.3], [2, 0.1]], unit = \"g\""}) {
    const auto project = read(fmt::format("[analyses]\nearthquake = {{direction = \"z\", {}}}\n", given));
    ASSERT_TRUE(project.has_value()) << given;
    const auto& request = project->base().analyses.earthquake;
    ASSERT_TRUE(request);
    const auto& list = request->spectrum.accelerations;
    EXPECT_THAT(std::ranges::max(list), test::RelativelyNear(0.3 * g, round_off)) << given;
  }
}

TEST_F(UnitsInRows, TracesOfCylindersInBarAreNotReadAsPascal) {
  std::string bare = "crank_angle_deg,pressure\n", heading = "crank_angle [deg],pressure [bar]\n",
              brackets = "Kurbelwinkel,Druck (bar)\n", pascal = "crank_angle_deg,pressure\n";
  for (int degrees = 0; degrees < 720; degrees += 10) {
    const double bar = 1 + 59 * std::exp(-degrees / 40.0);
    for (std::string* text : {&bare, &heading, &brackets}) *text += fmt::format("{},{:.17g}\n", degrees, bar);
    pascal += fmt::format("{},{:.17g}\n", degrees, 1e5 * bar);
  }
  write("bare.csv", bare), write("heading.csv", heading), write("brackets.csv", brackets), write("pascal.csv", pascal);
  const auto with = [](const std::string& pressure) {
    return "[excitations.crank]\ntype = \"orders\"\non = \"box\"\nat = [0, 0, 0]\n"
           "engine = {layout = \"inline\", cylinders = 1, crank_radius = \"45 mm\", rod_length = \"150 mm\", "
           "oscillating_mass = \"1e-9 kg\", crank = \"x\", up = \"z\", pressure = {bore = \"90 mm\", " +
        pressure + "}}\n";
  };
  const auto first_order = [&](const project::Project& project) {
    return std::get<model::Orders>(project.base().system.description().excitations.back().course).list.front().fixed;
  };
  const auto right = read(with("file = \"pascal.csv\""));
  ASSERT_TRUE(right.has_value()) << errors(with("file = \"pascal.csv\""));
  const Eigen::VectorXcd expected = first_order(*right);
  for (const char* given : {"file = \"bare.csv\", unit = \"bar\"", "file = \"heading.csv\"",
                            "file = \"brackets.csv\", crank_angle_deg = \"Kurbelwinkel\", pressure = \"Druck\""}) {
    const auto project = read(with(given));
    ASSERT_TRUE(project.has_value()) << given << errors(with(given));
    EXPECT_LE((first_order(*project) - expected).norm(), round_off * expected.norm()) << given;
  }
  const auto silent = read(with("file = \"bare.csv\""));
  ASSERT_TRUE(silent.has_value());
  std::string warnings;
  for (const foundation::Problem& problem : silent->base().warnings.list()) warnings += foundation::message(problem);
  EXPECT_THAT(warnings, HasSubstr("a largest pressure of 60 Pa"));
}

TEST_F(UnitsInRows, RangesOfParametersMayHaveTwo) {
  const auto project =
      read("[parameters.rate]\npath = \"elements.s.translation.z\"\nfrom = \"10 N/mm\"\nto = \"1 kN/mm\"\n");
  ASSERT_TRUE(project.has_value());
  const project::DesignAxis& axis = project->base().analyses.parameters.front();
  EXPECT_EQ(axis.unit, "N/mm");
  EXPECT_THAT(axis.to, test::RelativelyNear(1000, round_off));
}

}  // namespace units_in_rows_test
