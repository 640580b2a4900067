// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "support/matchers.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"

/// Functions of universal files as histories and spectra of excitations.
namespace universal_course_test {

using namespace trivet;
using testing::AllOf;
using testing::HasSubstr;

constexpr double round_off = 1e-12, pi = std::numbers::pi, g = 9.80665;

/// Set 58 as its description prints it.
struct Function {
  int type = 1;
  int abscissa = 17;  ///< time; 18: frequency
  double first = 0, step = 0.01;
  std::vector<double> values = {0, 2, 0};
  int numerator = 13;  ///< force; 12: acceleration
  std::string label = "NONE";
  int denominator = 0;
  std::string denominator_label = "NONE";
  int node = 3, direction = 3;
  std::string id = "NONE";
};

std::string text_of(const Function& f) {
  const auto axis = [](int quantity, const std::string& unit) {
    return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", quantity, 0, 0, 0, "NONE", unit);
  };
  std::string text = fmt::format("    -1\n    58\n{}\nNONE\nNONE\nNONE\nNONE\n", f.id);
  text += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}\n", f.type, 0, 0, 0, "NONE", f.node,
                      f.direction, "NONE", 0, 0);
  text += fmt::format("{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n", 4, f.values.size(), 1, f.first, f.step, 0.0);
  text += axis(f.abscissa, f.abscissa == 17 ? "s" : "Hz") + axis(f.numerator, f.label) +
      axis(f.denominator, f.denominator_label) + axis(0, "NONE");
  for (std::size_t i = 0; i < f.values.size(); ++i)
    text += fmt::format("{:20.11E}{}", f.values[i], i % 4 == 3 || i + 1 == f.values.size() ? "\n" : "");
  return text + "    -1\n";
}

/// Set 164: factors by which lengths and forces in SI are multiplied.
std::string units(double length, double force) {
  return fmt::format("    -1\n   164\n{:10}{:20}{:10}\n{:25.17E}{:25.17E}{:25.17E}\n{:25.17E}\n    -1\n", 9, "", 2,
                     length, force, 1.0, 273.15);
}

class UniversalCourse : public testing::Test {
 protected:
  UniversalCourse() { std::filesystem::create_directory(folder_); }
  ~UniversalCourse() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& text) const { std::ofstream(folder_ / "course.uff") << text; }

  [[nodiscard]] foundation::Expected<project::Project> read(const std::string& excitation) const {
    std::ofstream(folder_ / "machine.toml") << R"(trivet = 1
[bodies.box]
mass = 200
free = ["z"]
[elements.s]
type = "three_springs"
on = "box"
at = [0, 0, 0]
translation = [0, 0, "800 N/mm"]
damping = {translation = [0, 0, 2000]}
)" + excitation;
    return judging::read_project((folder_ / "machine.toml").string());
  }

  [[nodiscard]] std::string messages(const std::string& excitation) const {
    const auto found = read(excitation);
    std::string text;
    for (const foundation::Problem& problem : (found ? found->base().warnings : found.error()).list())
      text += foundation::message(problem) + "\n";
    return text;
  }

  /// Value of the history [N] after 5 ms; NaN after an error.
  [[nodiscard]] double force(const std::string& keys) const {
    const auto project = read(push(keys));
    if (!project) return std::numeric_limits<double>::quiet_NaN();
    const auto& course = project->base().system.description().excitations.back().course;
    return excitation::state(std::get<model::History>(course).signal, 0.005).value;
  }

  /// Density of accelerations at 50 Hz [(m/s2)2/Hz]; NaN after an error.
  [[nodiscard]] double density(const std::string& keys) const {
    const auto project = read(shake(keys));
    if (!project) return std::numeric_limits<double>::quiet_NaN();
    const auto& course = project->base().system.description().excitations.back().course;
    return 2 * pi * excitation::density(std::get<model::Random>(course).spectrum, 2 * pi * 50);
  }

  static std::string push(const std::string& keys) {
    return "[excitations.push]\ntype = \"time\"\non = \"box\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n"
           "history = {file = \"course.uff\"" +
        keys + "}\n";
  }
  static std::string shake(const std::string& keys) {
    return "[excitations.road]\ntype = \"random\"\nbase = true\ntranslation = [0, 0, 1]\nquantity = \"acceleration\"\n"
           "psd = {file = \"course.uff\"" +
        keys + "}\n[analyses]\nrandom = {}\n";
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("trivet-universal-course-{}", ::getpid());
};

TEST_F(UniversalCourse, ATimeResponseIsAHistoryInItsUnit) {
  struct Case {
    std::string text, keys;
    double newtons;  ///< half of the middle value
  };
  const Function si, kilo{.label = "kN"};
  Function z = si, y = si;
  z.values = {0, 4, 0};
  y.direction = 2, y.id = "hammer";
  for (const auto& [text, keys, newtons] :
       {Case{text_of(si), "", 1}, Case{text_of(kilo), "", 1000}, Case{units(1e3, 1e3) + text_of(si), "", 1e-3},  // mN
        Case{text_of(si), ", unit = \"lbf\"", 4.4482216152605}, Case{text_of(si), ", scale = 3", 3},
        Case{text_of(z) + text_of(y), ", value = \"3:+z\"", 2}, Case{text_of(z) + text_of(y), ", value = \"3:-z\"", -2},
        Case{text_of(z) + text_of(y), ", value = \"hammer\"", 1}}) {
    write(text);
    EXPECT_THAT(force(keys), test::RelativelyNear(newtons, round_off)) << keys << "\n" << messages(push(keys));
  }
}

TEST_F(UniversalCourse, ADensityIsASpectrumInItsUnit) {
  Function si{.type = 9, .abscissa = 18, .first = 0, .step = 10, .values = {1e3, 4, 4, 4, 4, 4, 4, 4}, .numerator = 12};
  const auto labelled = [&](const std::string& label, const std::string& below = "NONE", int type = 9) {
    Function f = si;
    f.label = label, f.denominator_label = below, f.type = type;
    return text_of(f);
  };
  struct Case {
    std::string text, keys;
    double expected;
  };
  for (const auto& [text, keys, expected] :
       {Case{text_of(si), "", 4}, Case{labelled("g^2/Hz"), "", 4 * g * g}, Case{labelled("g"), "", 4 * g * g},
        Case{labelled("g^2", "Hz"), "", 4 * g * g}, Case{labelled("g^2/Hz", "NONE", 2), "", 4 * g * g},
        Case{units(1e3, 1e3) + text_of(si), "", 4e-6}, Case{text_of(si), ", unit = \"g^2/Hz\"", 4 * g * g},
        Case{units(1, 1) + labelled("g^2/Hz"), ", unit = \"g^2/Hz\"", 4 * g * g}}) {
    write(text);
    EXPECT_THAT(density(keys), test::RelativelyNear(expected, 1e-9)) << keys << text << messages(shake(keys));
  }
}

TEST_F(UniversalCourse, FunctionsThatCannotDriveAreErrors) {
  const Function force, acceleration{.numerator = 12};
  Function spectrum{.type = 2, .abscissa = 18, .first = 10, .step = 10, .values = {1, 1}, .numerator = 12};
  write(text_of(acceleration));
  EXPECT_THAT(messages(push("")), AllOf(HasSubstr("3:+z is measured in m/s2"), HasSubstr("is driven in N")));
  write(text_of(force) + text_of(force));
  EXPECT_THAT(messages(push("")), AllOf(HasSubstr("several functions: 3:+z, 3:+z"), HasSubstr("name it: value =")));
  EXPECT_THAT(messages(push(", value = \"4:+x\"")), HasSubstr("the file has: 3:+z, 3:+z"));
  write(text_of(spectrum));
  EXPECT_THAT(messages(push("")),
              AllOf(HasSubstr("1 × auto spectrum (type 2)"), HasSubstr("a time response (type 1)")));
  EXPECT_THAT(messages(shake("")), HasSubstr("a power spectral density (type 9) is read from a universal file here"));
  Function density = spectrum;
  density.type = 9, density.label = "furlong";
  write(text_of(density));
  EXPECT_THAT(messages(shake("")), HasSubstr("the label \"furlong\" is not a known unit"));
  density.label = "g^2/Hz";
  write(units(1, 1) + text_of(density));
  EXPECT_THAT(messages(shake("")), AllOf(HasSubstr("the label \"g^2/Hz\" against set 164"), HasSubstr("state it")));
  density.denominator = 13;
  write(text_of(density));
  EXPECT_THAT(messages(shake("")), HasSubstr("a power spectral density is a mean square per hertz"));
  write(text_of(force));
  EXPECT_THAT(messages("[analyses]\nresponse = {band = [\"5 Hz\", \"50 Hz\"]}\n[limit_lines.class]\nof = \"box.z\"\n"
                       "file = \"course.uff\"\n"),
              AllOf(HasSubstr("limit_lines.class.file: a universal file"), HasSubstr("`history` and `psd`")));
}

}  // namespace universal_course_test
