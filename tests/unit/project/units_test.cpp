// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include "support/matchers.h"
#include "trivet/project/text/units.h"

namespace units_test {

using trivet::project::Quantity;
using trivet::project::to_si;
constexpr double pi = std::numbers::pi;

struct Conversion {
  const char* text;
  Quantity quantity;
  double si;
};

TEST(Units, ConvertWhatEngineersWrite) {
  constexpr double round_off = 1e-12;       // a few products with conversion factors
  constexpr double printed_digits = 1e-11;  // 12 digits of 175.126835246
  for (const Conversion& c : {Conversion{"452.3 lb", Quantity::mass, 452.3 * 0.45359237},
                              {"0.205176 t", Quantity::mass, 205.176},
                              {"-502 mm", Quantity::length, -0.502},
                              {"1 in", Quantity::length, 0.0254},
                              {"1 Hz", Quantity::angular_frequency, 2 * pi},
                              {"2 kHz", Quantity::angular_frequency, 4000 * pi},
                              {"60 rpm", Quantity::angular_frequency, 2 * pi},
                              {"1 rev/s", Quantity::angular_frequency, 2 * pi},
                              {"3 rad/s", Quantity::angular_frequency, 3},
                              {"90 deg/s", Quantity::angular_frequency, pi / 2},
                              {"180 deg", Quantity::angle, pi},
                              {"180 °", Quantity::angle, pi},
                              {"0.5 rev", Quantity::angle, pi},
                              {"2 mrad", Quantity::angle, 0.002},
                              {"1 kNm", Quantity::moment, 1000},
                              {"1 N*m", Quantity::moment, 1},
                              {"1 N·m", Quantity::moment, 1},
                              {"1 N m/deg", Quantity::moment_per_angle, 180 / pi},
                              {"5 N/mm", Quantity::force_per_length, 5000},
                              {"1 lbf/in", Quantity::force_per_length, 175.126835246},
                              {"5 kg m2", Quantity::inertia, 5},
                              {"5 kg·m²", Quantity::inertia, 5},
                              {"2 kN s/m", Quantity::damping_force_per_length, 2000},
                              {"1 kgf", Quantity::force, 9.80665},
                              {"5 %", Quantity::pure, 0.05},
                              {"3 ms", Quantity::time, 0.003},
                              {"1 oz in", Quantity::mass_length, 0.45359237 / 16 * 0.0254},
                              {"2 slug", Quantity::mass, 2 * 0.45359237 * 9.80665 / 0.3048},
                              {"60 mph", Quantity::velocity, 60 * 1609.344 / 3600},
                              {"5 rps", Quantity::angular_frequency, 10 * pi},
                              {"2 nmi", Quantity::length, 3704},
                              {"3 µm", Quantity::length, 3e-6},
                              {"2 kilonewtons", Quantity::force, 2000},
                              {"4 krpm", Quantity::angular_frequency, 4000 * pi / 30},
                              {"+1e3 mm", Quantity::length, 1}}) {
    const auto found = to_si(c.text, c.quantity);
    ASSERT_TRUE(found.has_value()) << c.text << ": " << found.error();
    const double tolerance = std::string(c.text).find("lbf") == std::string::npos ? round_off : printed_digits;
    EXPECT_THAT(*found, trivet::test::RelativelyNear(c.si, tolerance)) << c.text;
  }
}

TEST(Units, ReadTheSpellingsOfDataSheets) {
  constexpr double round_off = 1e-12;
  for (const Conversion& c : {Conversion{"1500 1/min", Quantity::angular_frequency, 50 * pi},
                              {"1500 min⁻¹", Quantity::angular_frequency, 50 * pi},
                              {"1500 min^-1", Quantity::angular_frequency, 50 * pi},
                              {"1500 U/min", Quantity::angular_frequency, 50 * pi},
                              {"7 \u00b5m", Quantity::length, 7e-6},  // the micro sign
                              {"7 \u03bcm", Quantity::length, 7e-6},  // the Greek letter
                              {"7 um", Quantity::length, 7e-6},
                              {"3 m·s⁻²", Quantity::acceleration, 3},
                              {"0.5 g", Quantity::acceleration, 0.5 * 9.80665},
                              {"2 short ton", Quantity::mass, 4000 * 0.45359237},
                              {"2 long ton", Quantity::mass, 4480 * 0.45359237},
                              {"2 t", Quantity::mass, 2000},
                              {"2 metric ton", Quantity::mass, 2000},
                              {"5 kNs/m", Quantity::damping_force_per_length, 5000},
                              {"60 bar", Quantity::pressure, 6e6},
                              {"3 lbs", Quantity::mass, 3 * 0.45359237}}) {
    const auto found = to_si(c.text, c.quantity);
    ASSERT_TRUE(found.has_value()) << c.text << ": " << found.error();
    EXPECT_THAT(*found, trivet::test::RelativelyNear(c.si, round_off)) << c.text;
  }
}

/// A unit that can be meant in only one way is rejected with the text to write instead, and that text is right.
TEST(Units, RejectWhatIsAmbiguousWithTheUnitToWrite) {
  struct Offer {
    const char* text;
    Quantity quantity;
    const char* offered;
  };
  for (const Offer& one : {Offer{"100 lb/in", Quantity::force_per_length, "lbf/in"},
                           {"100 lbs/in", Quantity::force_per_length, "lbf/in"},
                           {"5 kg/mm", Quantity::force_per_length, "kgf/mm"},
                           {"500 lb", Quantity::force, "lbf"},
                           {"20 ft lb", Quantity::moment, "ft lbf"},
                           {"3 kg/cm^2", Quantity::pressure, "kgf/cm^2"},
                           {"2 ton", Quantity::mass, "t"},
                           {"2 tons", Quantity::mass, "short ton"},
                           {"25 1/s", Quantity::angular_frequency, "Hz"}}) {
    const auto found = to_si(one.text, one.quantity);
    ASSERT_FALSE(found.has_value()) << one.text;
    EXPECT_THAT(found.error(), testing::HasSubstr("\"" + std::string(one.offered) + "\"")) << one.text;
    EXPECT_TRUE(to_si(std::string("1 ") + one.offered, one.quantity).has_value()) << one.offered;
  }
}

TEST(Units, ReadSpectralDensitiesPerHertz) {
  using trivet::project::to_density;
  constexpr double round_off = 1e-12, g = 9.80665;
  for (const Conversion& c : {Conversion{"0.04 g^2/Hz", Quantity::acceleration, 0.04 * g * g},
                              {"0.04 g²/Hz", Quantity::acceleration, 0.04 * g * g},
                              {"2 (m/s^2)^2/Hz", Quantity::acceleration, 2},
                              {"2 m²/s⁴/Hz", Quantity::acceleration, 2},
                              {"3 mm^2/Hz", Quantity::length, 3e-6},
                              {"1 m^2/(rad/s)", Quantity::length, 2 * pi},
                              {"5 kN^2/Hz", Quantity::force, 5e6}}) {
    const auto found = to_density(c.text, c.quantity);
    ASSERT_TRUE(found.has_value()) << c.text << ": " << found.error();
    EXPECT_THAT(*found, trivet::test::RelativelyNear(c.si, round_off)) << c.text;
  }
  EXPECT_FALSE(to_density("0.04 g/Hz", Quantity::acceleration).has_value());
  EXPECT_FALSE(to_density("0.04 g^2/Hz", Quantity::length).has_value());
}

TEST(Units, CompareTwoUnits) {
  using trivet::project::unit_ratio;
  constexpr double round_off = 1e-12;
  EXPECT_THAT(unit_ratio("kN/mm", "N/mm").value(), trivet::test::RelativelyNear(1000, round_off));
  EXPECT_THAT(unit_ratio("m/s^2", "g").value(), trivet::test::RelativelyNear(1 / 9.80665, round_off));
  EXPECT_FALSE(unit_ratio("m", "s").has_value());
  EXPECT_FALSE(unit_ratio("m", "").has_value());
}

/// Factors of usual units are the nearest numbers to what they mean: "5 N/mm" is 5000 N/m to the last digit.
TEST(Units, UsualOnesAreExact) {
  for (const auto& [unit, quantity, factor] : {std::tuple{"mm", Quantity::length, 1e-3},
                                               {"cm", Quantity::length, 1e-2},
                                               {"Hz", Quantity::angular_frequency, 2 * pi},
                                               {"rpm", Quantity::angular_velocity, 2 * pi / 60},
                                               {"deg", Quantity::angle, pi / 180},
                                               {"g", Quantity::mass, 1e-3},
                                               {"t", Quantity::mass, 1e3},
                                               {"ms", Quantity::time, 1e-3},
                                               {"mm/s", Quantity::velocity, 1e-3},
                                               {"kN", Quantity::force, 1e3},
                                               {"kN m", Quantity::moment, 1e3},
                                               {"N/mm", Quantity::force_per_length, 1e3},
                                               {"kN/mm", Quantity::force_per_length, 1e6},
                                               {"kN m/rad", Quantity::moment_per_angle, 1e3},
                                               {"N s/mm", Quantity::damping_force_per_length, 1e3},
                                               {"kPa", Quantity::pressure, 1e3},
                                               {"bar", Quantity::pressure, 1e5},
                                               {"MPa", Quantity::pressure, 1e6},
                                               {"GPa", Quantity::pressure, 1e9},
                                               {"N/mm2", Quantity::pressure, 1e6}})
    EXPECT_EQ(to_si(std::string("1.2345678 ") + unit, quantity).value(), 1.2345678 * factor) << unit;
}

TEST(Units, ReadProductsFromLeftToRight) {
  constexpr double round_off = 1e-12, pound_force = 4.4482216152605, inch = 0.0254;
  for (const Conversion& c : {Conversion{"3 lbf-in", Quantity::moment, 3 * pound_force * inch},
                              {"3 in.lbf", Quantity::moment, 3 * pound_force * inch},
                              {"1 lbf s/in", Quantity::damping_force_per_length, pound_force / inch},
                              {"1 lbf/in*s", Quantity::damping_force_per_length, pound_force / inch},
                              {"1 kg/(m s2)", Quantity::pressure, 1},
                              {"1 N per mm", Quantity::force_per_length, 1000},
                              {"1 m/s/s", Quantity::acceleration, 1},
                              {"1 m s-1", Quantity::velocity, 1},
                              {"1 cm^3", Quantity::volume, 1e-6},
                              {"1 (mm)3", Quantity::volume, 1e-9},
                              {"2 Newtons", Quantity::force, 2},
                              {"1 psi", Quantity::pressure, pound_force / (inch * inch)},
                              {"1 kg m2/s2", Quantity::moment, 1}}) {
    const auto found = to_si(c.text, c.quantity);
    ASSERT_TRUE(found.has_value()) << c.text << ": " << found.error();
    EXPECT_THAT(*found, trivet::test::RelativelyNear(c.si, round_off)) << c.text;
  }
  for (const char* wrong : {"m^", "m/", "(m", "m)", "m0", "m12", "/m", "lbfs/in", "m//s", "N-", "kkg", "lbf in-"})
    EXPECT_FALSE(trivet::project::unit_ratio(wrong, wrong).has_value()) << wrong;
  EXPECT_TRUE(trivet::project::unit_ratio("lbf s/in", "lbf s/in").has_value());
}

TEST(Units, ReadTemperaturesWithTheirZero) {
  constexpr double round_off = 1e-12;
  for (const Conversion& c : {Conversion{"20 °C", Quantity::temperature, 293.15},
                              {"-40 degF", Quantity::temperature, 233.15},
                              {"68 °F", Quantity::temperature, 293.15},
                              {"-40 degC", Quantity::temperature, 233.15},
                              {"3 K", Quantity::temperature, 3}}) {
    const auto found = to_si(c.text, c.quantity);
    ASSERT_TRUE(found.has_value()) << c.text << ": " << found.error();
    EXPECT_THAT(*found, trivet::test::RelativelyNear(c.si, round_off)) << c.text;
  }
  EXPECT_EQ(trivet::project::unit_ratio("degC", "degC"), 1);
  EXPECT_FALSE(trivet::project::unit_ratio("degF", "degC").has_value());
}

/// SI prefixes before customary units are slips: "mmi" is no thousandth of a mile.
TEST(Units, RejectPrefixesBeforeCustomaryUnits) {
  for (const auto& [text, quantity] : {std::pair{"1 mmi", Quantity::length},
                                       {"22 cin", Quantity::length},
                                       {"0.7 kft", Quantity::length},
                                       {"1 mlb", Quantity::mass},
                                       {"310 kkg", Quantity::mass},
                                       {"0.1 nyd", Quantity::length}}) {
    const auto found = to_si(text, quantity);
    ASSERT_FALSE(found.has_value()) << text;
    EXPECT_THAT(found.error(), testing::HasSubstr("prefix")) << text;
  }
}

TEST(Units, RejectUnitsOfAnotherQuantity) {
  for (const auto& [text, quantity] : {std::pair{"3 m", Quantity::mass},
                                       {"5 J", Quantity::moment},
                                       {"5 kJ", Quantity::moment},
                                       {"5 cal", Quantity::moment},
                                       {"5 W s", Quantity::moment},
                                       {"1 1/s", Quantity::angular_frequency},
                                       {"1 Hz", Quantity::per_time},
                                       {"1 Nm", Quantity::moment_per_angle},
                                       {"5 rad", Quantity::pure},
                                       {"5", Quantity::length},
                                       {"5", Quantity::pure},
                                       {"", Quantity::length},
                                       {"mm", Quantity::length},
                                       {"1,5 mm", Quantity::length},
                                       {"nan mm", Quantity::length},
                                       {"inf mm", Quantity::length},
                                       {"20 degC", Quantity::length},
                                       {"5 cm since 2000", Quantity::length},
                                       {"5 m @ 3", Quantity::length},
                                       {"5 log(m)", Quantity::length},
                                       {"5 mmm", Quantity::length},
                                       {"1e999 m", Quantity::length},
                                       {"5 radians", Quantity::pure},
                                       {"3 turn", Quantity::pure},
                                       {"5 arc_degree", Quantity::pure},
                                       {"5 joules", Quantity::moment},
                                       {"5 BTU", Quantity::moment},
                                       {"2 therm", Quantity::moment},
                                       {"3 watts s", Quantity::moment},
                                       {"12 500 kg", Quantity::mass},
                                       {"1.234.567 kg", Quantity::mass},
                                       {"5 kg 2", Quantity::mass}})
    EXPECT_FALSE(to_si(text, quantity).has_value()) << text;
}

}  // namespace units_test
