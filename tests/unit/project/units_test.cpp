// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <numbers>

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
