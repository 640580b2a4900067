// SPDX-License-Identifier: BSD-3-Clause
// Content of universal files: the sets, their numbers, and the conversion to SI.
#include <gtest/gtest.h>

#include <numbers>

#include "trivet/exchange/universal/universal_units.h"
#include "unit/exchange/universal_texts.h"

namespace trivet::test {
namespace universal_reading_test {

using exchange::EvenAbscissa;
using exchange::UniversalComplexMode;
using exchange::UniversalFile;
using exchange::UniversalFunction;
using exchange::UniversalMode;
using exchange::UniversalNormalMode;
using exchange::UniversalQuantity;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Complex = std::complex<double>;

/// One product and one quotient.
constexpr double round_off = 4e-16;
/// Half a unit of the last of 24 bits.
constexpr double single_precision = 6e-8;

constexpr double inch = 0.0254, pound_force = 4.4482216152605;

std::string data_file(const std::string& name) {
  return std::string(TRIVET_SOURCE_DIR) + "/tests/data/universal/" + name;
}

UniversalFile file_of(const std::string& name) {
  const auto read = exchange::read_universal(data_file(name));
  EXPECT_TRUE(read) << complaint(read);
  return read ? read->file : UniversalFile{};
}

void expect_near(Complex found, Complex wanted, double tolerance) {
  EXPECT_LE(std::abs(found - wanted), tolerance * std::abs(wanted)) << found << " instead of " << wanted;
}

/// The values that the script in tests/data/universal wrote.
void expect_receptance(const UniversalFunction& function, double unit, double tolerance) {
  ASSERT_EQ(function.values.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k)
    expect_near(function.values[k], static_cast<double>(k + 1) * 1e-6 * unit * Complex(1, -0.5), tolerance);
}

TEST(UniversalFiles, OfOtherProgramsAreReadInAllForms) {
  const struct {
    const char* name;
    bool even;
    double unit, tolerance;
    bool single_abscissa = false;
  } files[] = {{"without_blanks.unv", true, -1, round_off},
               {"line_end_before_delimiter.unv", true, 1, single_precision},
               {"big_endian_wrong_bytes.unv", true, 1, round_off},
               {"uneven_single_abscissa.unv", false, 1, round_off, true},
               {"uneven_double_abscissa.unv", false, 1, round_off},
               {"inch_units.unv", true, inch / pound_force, round_off},
               {"pyuff_text.unv", false, 1, round_off},
               {"pyuff_binary.unv", false, 1, round_off}};
  for (const auto& file : files) {
    const UniversalFile read = file_of(file.name);
    ASSERT_EQ(read.functions.size(), 1u) << file.name;
    expect_receptance(read.functions[0], file.unit, file.tolerance);
    if (file.even) {
      EXPECT_THAT(abscissa_values(read.functions[0]), ElementsAre(5, 5.5, 6, 6.5, 7, 7.5, 8));
    } else if (file.single_abscissa) {
      EXPECT_THAT(abscissa_values(read.functions[0]), ElementsAre(1, 2.5, 4.25, 10.1f, 11, 30.7f, 99.9f));
    } else {
      EXPECT_THAT(abscissa_values(read.functions[0]), ElementsAre(1, 2.5, 4.25, 10.1, 11, 30.7, 99.9));
    }
    EXPECT_EQ(read.functions[0].response.node, 12);
    EXPECT_EQ(read.functions[0].response.direction, -3);
    EXPECT_EQ(read.functions[0].reference.node, 7);
    EXPECT_EQ(read.functions[0].reference.direction, 3);
  }
}

TEST(UniversalFiles, KeepTheTextsAndTheGeometry) {
  const UniversalFile file = file_of("inch_units.unv");
  EXPECT_EQ(file.header.model, "machine");
  EXPECT_EQ(file.header.description, "");
  EXPECT_EQ(file.header.created, "28-Jan-21 14:01:42");
  ASSERT_TRUE(file.units_of_file);
  EXPECT_EQ(file.units_of_file->code, 7);
  EXPECT_EQ(file.units_of_file->description, "Inch (pound f)");
  ASSERT_EQ(file.nodes.size(), 2u);
  EXPECT_EQ(file.nodes[1].label, 12);
  EXPECT_LE((file.nodes[1].position - inch * Eigen::Vector3d(10, -20, 0.5)).norm(), round_off);
  ASSERT_EQ(file.lines.size(), 1u);
  EXPECT_EQ(file.lines[0].name, "wire");
  EXPECT_THAT(file.lines[0].nodes, ElementsAre(7, 12));
  EXPECT_EQ(file.functions[0].ids[0], "Receptance");
  EXPECT_EQ(file.functions[0].ids[1], "");
  EXPECT_EQ(file.functions[0].response.entity, "ENGINE");
  EXPECT_EQ(file.functions[0].abscissa_axis.unit, "Hz");
  EXPECT_EQ(file.functions[0].numerator.unit, "m");
}

TEST(UniversalModes, AreReadWithTheirParametersAndListedNodes) {
  const UniversalFile file = file_of("pyuff_text.unv");
  ASSERT_EQ(file.modes.size(), 1u);
  const UniversalMode& mode = file.modes[0];
  const auto& parameters = std::get<UniversalComplexMode>(mode.parameters);
  EXPECT_EQ(parameters.eigenvalue, Complex(-1.5, 62));
  EXPECT_EQ(parameters.modal_a, Complex(1, 2));
  EXPECT_EQ(parameters.modal_b, Complex(3, -1));
  EXPECT_THAT(natural_frequency_hz(mode), DoubleEq(std::abs(Complex(-1.5, 62)) / (2 * std::numbers::pi)));
  EXPECT_THAT(damping_ratio(mode), DoubleEq(1.5 / std::abs(Complex(-1.5, 62))));
  EXPECT_FALSE(mode.has_rotations);
  ASSERT_EQ(mode.nodes.size(), 2u);
  EXPECT_EQ(mode.nodes[1].node, 12);
  EXPECT_THAT(mode.nodes[1].components, ElementsAre(3, Complex(0, -1), 4, 0, 0, 0));
}

TEST(UniversalModes, KeepTheirReceptanceInOtherUnits) {
  const UniversalMode mode = file_of("inch_units.unv").modes.at(0);
  const auto& parameters = std::get<UniversalNormalMode>(mode.parameters);
  EXPECT_EQ(parameters.frequency_hz, 12.5);
  EXPECT_EQ(damping_ratio(mode), 0.01);
  ASSERT_EQ(mode.nodes.size(), 1u);
  const auto& shape = mode.nodes[0].components;
  expect_near(shape[0], inch, round_off);
  EXPECT_EQ(shape[3], 0.1);  // a rotation
  // φφ/m in in/(lbf s²) and in m/(N s²)
  expect_near(shape[0] * shape[1] / parameters.modal_mass, 1.0 * -2.0 / 2.0 * inch / pound_force, 4 * round_off);
}

TEST(UniversalModes, MayHaveSixComplexNumbersPerNodeInOneLineOrTwo) {
  const std::string head =
      "NONE\nNONE\nNONE\nNONE\nNONE\n         1         7         3         8         5         6\n"
      "         2         6         1         4\n"
      " -1.00000E+00  3.00000E+01  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n"
      "         9\n";
  for (const char* middle : {"\n", " "}) {
    const UniversalFile file =
        content(universal_set(55, head + " 1.0 2.0 3.0 4.0 5.0 6.0" + middle + "7.0 8.0 9.0 10.0 11.0 12.0\n"));
    ASSERT_EQ(file.modes.size(), 1u);
    EXPECT_TRUE(std::get<UniversalComplexMode>(file.modes[0].parameters).second_order);
    EXPECT_EQ(file.modes[0].number, 4);
    EXPECT_EQ(file.modes[0].nodes[0].components[0], Complex(1, 2));
    EXPECT_EQ(file.modes[0].nodes[0].components[5], Complex(11, 12));
  }
}

TEST(UniversalModes, AreOnlySetsWithModes) {
  const std::string other =
      "NONE\nNONE\nNONE\nNONE\nNONE\n         1         5         2         8         5         3\n"
      "         2         1         1         4\n  1.00000E+01\n";
  const std::string said = warnings(universal_set(55, other) + universal_set(55, other) + universal_set(2499, "1\n"));
  EXPECT_THAT(said, HasSubstr("sets: 2499, 55 with analysis type 5 (2×)"));
}

TEST(UniversalFunctions, HaveFourTypesOfOrdinatesWithBothSpacings) {
  const struct {
    int type, spacing;
    const char* values;
    Complex second;
  } cases[] = {{2, 1, " 1.0 2.0", 2},          {2, 0, " 1.0 10.0 2.0 20.0", 20},
               {4, 1, " 1.0 2.0", 2},          {4, 0, " 1.0 10.0 2.0 20.0", 20},
               {5, 1, " 1. 2. 3. 4.", {3, 4}}, {5, 0, " 1. 2. 3. 4. 5. 6.", {5, 6}},
               {6, 1, " 1. 2. 3. 4.", {3, 4}}, {6, 0, " 1. 2. 3.\n 4. 5. 6.", {5, 6}}};
  for (const auto& each : cases) {
    const UniversalFunction function = function_of(universal(
        {.form = fmt::format("{:10d}{:10d}{:10d}{:13.5E}{:13.5E}{:13.5E}", each.type, 2, each.spacing, 1.0, 0.5, 0.0),
         .values = std::string(each.values) + "\n"}));
    ASSERT_EQ(function.values.size(), 2u) << each.values;
    EXPECT_EQ(function.values[1], each.second) << each.values;
    EXPECT_EQ(function.is_complex, each.type > 4);
    EXPECT_EQ(std::holds_alternative<EvenAbscissa>(function.abscissa), each.spacing == 1);
  }
}

TEST(UniversalFunctions, AreOfEveryTypeWithoutAWarning) {
  for (int type = 0; type <= 27; ++type) {
    const std::string text =
        universal({.place = fmt::format("{:5d}{:10d}{:5d}{:10d} {:<10}{:10d}{:4d}", type, 0, 0, 0, "NONE", 1, 6)});
    EXPECT_EQ(static_cast<int>(function_of(text).type), type);
    EXPECT_EQ(warnings(text), "");
  }
}

TEST(UniversalUnits, HoldForTheSetsAfterThem) {
  const std::string text = units_set(5, 1e3, 1e3) + universal({}) + units_set(10, 1e3, 1) + universal({});
  const UniversalFile file = content(text);
  ASSERT_EQ(file.functions.size(), 2u);
  expect_near(file.functions[0].values[0], {1e-6, -2e-6}, round_off);
  expect_near(file.functions[1].values[0], {1e-9, -2e-9}, round_off);
  EXPECT_THAT(warnings(universal({}) + units_set(5, 1e3, 1e3)), HasSubstr("those before it are read as SI"));
}

/// Value of 1 in SI, of a function in mm and mN with this type, directions and axes.
double si_of_one(int type, int response, int reference, const std::string& numerator, const std::string& denominator,
                 bool* in_file_units = nullptr) {
  const UniversalFunction function =
      function_of(units_set(5, 1e3, 1e3) +
                  universal({.place = fmt::format("{:5d}{:10d}{:5d}{:10d} {:<10}{:10d}{:4d} {:<10}{:10d}{:4d}", type, 0,
                                                  0, 0, "NONE", 1, response, "NONE", 2, reference),
                             .form = "         2         1         1          0.0          0.0          0.0",
                             .numerator = numerator,
                             .denominator = denominator,
                             .values = "  1.0\n"}));
  if (in_file_units) *in_file_units = function.in_file_units;
  return function.values.at(0).real();
}

TEST(UniversalUnits, FollowQuantityAndDirection) {
  const std::string displacement = "         8    0    0    0", acceleration = "        12    1    0    0",
                    force = "        13    0    1    0", general = "         1    2   -1    0",
                    unused = "         0    0    0    0";
  EXPECT_THAT(si_of_one(4, 1, -2, displacement, force), DoubleEq(1));
  EXPECT_THAT(si_of_one(4, 4, 2, displacement, force), DoubleEq(1e3));  // rad/mN
  EXPECT_THAT(si_of_one(4, 1, 5, displacement, force), DoubleEq(1e3));  // mm/(mN mm)
  EXPECT_THAT(si_of_one(1, 3, 0, acceleration, unused), DoubleEq(1e-3));
  EXPECT_THAT(si_of_one(1, 0, 0, acceleration, unused), DoubleEq(1e-3));  // a scalar by its powers
  EXPECT_THAT(si_of_one(1, 0, 0, displacement, unused), DoubleEq(1e-3));  // a scalar without powers
  EXPECT_THAT(si_of_one(0, 0, 0, general, unused), DoubleEq(1e-3));
  bool in_file_units = true;
  EXPECT_THAT(si_of_one(6, 1, 2, acceleration, unused, &in_file_units), DoubleEq(1));  // coherence has no unit
  EXPECT_FALSE(in_file_units);
  EXPECT_THAT(si_of_one(5, 1, 2, acceleration, acceleration), DoubleEq(1));
}

TEST(UniversalUnits, ThatAreNotKnownAreLeftAndReported) {
  bool left = false;
  EXPECT_EQ(si_of_one(9, 1, 0, "        12    0    0    0", "         0    0    0    0", &left), 1);
  EXPECT_TRUE(left);
  EXPECT_EQ(si_of_one(1, 1, 0, "        77    0    0    0", "         0    0    0    0", &left), 1);
  EXPECT_TRUE(left);
  EXPECT_EQ(si_of_one(4, 1, 1, "         8    0    0    0", "        13    0    0    0", &left), 1);
  EXPECT_FALSE(left);
}

TEST(UniversalUnits, LeaveFrequenciesInHertz) {
  EXPECT_THAT(abscissa_values(function_of(units_set(7, 1 / inch, 1 / pound_force) + universal({}))),
              ElementsAre(5, 5.5));
  const UniversalFunction over_displacement = function_of(
      units_set(5, 1e3, 1e3) + universal({.abscissa = "         8    0    0    0 Travel               mm"}));
  EXPECT_THAT(abscissa_values(over_displacement), ElementsAre(DoubleEq(5e-3), DoubleEq(5.5e-3)));
  EXPECT_EQ(over_displacement.abscissa_axis.unit, "m");
}

TEST(UniversalUnits, AreThoseOfTheLabelsWithoutSet164) {
  const std::string in_g = "        12    0    0    0 Acceleration         g",
                    per_pound = "        13    0    0    0 Force                lbf";
  const UniversalFunction accelerance = function_of(universal({.numerator = in_g, .denominator = per_pound}));
  constexpr double unit = 9.80665 / 4.4482216152605;
  expect_near(accelerance.values[0], unit * Complex(1e-6, -2e-6), round_off);
  EXPECT_EQ(accelerance.numerator.stated.by_label, 9.80665);
  EXPECT_EQ(accelerance.numerator.stated.by_set, std::nullopt);
  EXPECT_EQ(accelerance.numerator.stated.label, "g");
  EXPECT_EQ(accelerance.numerator.unit, "m/s2");
  const auto read = read_text(universal({.numerator = in_g, .denominator = per_pound}));
  EXPECT_TRUE(read->warnings.list().empty());  // nothing is missing
  EXPECT_THAT(
      abscissa_values(function_of(universal({.abscissa = "        18    0    0    0 Speed                rpm"}))),
      ElementsAre(DoubleEq(5.0 / 60), DoubleEq(5.5 / 60)));
}

TEST(UniversalUnits, AreThoseOfSet164AndTheLabelIsNoted) {
  const UniversalFunction function = function_of(
      units_set(5, 1e3, 1e3) + universal({.numerator = "        12    0    0    0 Acceleration         g"}));
  expect_near(function.values[0], {1e-6, -2e-6}, round_off);  // mm/s² per mN
  EXPECT_THAT(function.numerator.stated.by_set, testing::Optional(DoubleEq(1e-3)));
  EXPECT_EQ(function.numerator.stated.by_label, 9.80665);
}

TEST(UniversalUnits, HaveLabelsOfMotionsAndLoads) {
  using exchange::unit_of_label;
  using exchange::UniversalMotion;
  const auto value = [](UniversalQuantity quantity, UniversalMotion motion, const char* label) {
    const auto unit = unit_of_label(quantity, motion, label);
    return unit ? unit->value : 0;
  };
  constexpr auto translation = UniversalMotion::translation, rotation = UniversalMotion::rotation,
                 scalar = UniversalMotion::scalar;
  EXPECT_EQ(value(UniversalQuantity::excitation_force, translation, "mN"), 1e-3);
  EXPECT_EQ(value(UniversalQuantity::excitation_force, translation, "MN"), 1e6);
  EXPECT_EQ(value(UniversalQuantity::excitation_force, translation, "N m"), 0);
  EXPECT_EQ(value(UniversalQuantity::reaction_force, rotation, "N*mm"), 1e-3);
  EXPECT_EQ(value(UniversalQuantity::reaction_force, rotation, "N"), 0);
  EXPECT_TRUE(unit_of_label(UniversalQuantity::reaction_force, scalar, "N m")->turns);
  EXPECT_FALSE(unit_of_label(UniversalQuantity::reaction_force, scalar, "N")->turns);
  EXPECT_EQ(value(UniversalQuantity::velocity, translation, "(in/sec)"), inch);
  EXPECT_EQ(value(UniversalQuantity::acceleration, translation, "m/s**2"), 1);
  EXPECT_EQ(value(UniversalQuantity::acceleration, rotation, "rad/s²"), 1);
  EXPECT_EQ(value(UniversalQuantity::acceleration, translation, "furlong"), 0);
}

TEST(UniversalUnits, MustAgreeWithTheirCode) {
  EXPECT_THAT(warnings(units_set(5, 1, 1)), HasSubstr("code 5 with the factors 1 and 1; this code has 1000 and 1000"));
  EXPECT_EQ(warnings(units_set(9, 12, 34)), "");
  EXPECT_EQ(warnings(units_set(2, 3.2808, 0.22481)), "");
  const auto read = read_text(universal({}));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->warnings.list().size(), 1u);
  EXPECT_EQ(
      message(read->warnings.list()[0]),
      "f: warning: units: no set 164; set 164 states the units of the numbers; numbers without the label of a known "
      "unit are read as SI");
}

}  // namespace universal_reading_test
}  // namespace trivet::test
