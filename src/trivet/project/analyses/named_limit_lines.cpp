// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/named_limit_lines.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::project {
namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr double micro = 1e-6;

const char* const gordon =
    "H. Amick, M. Gendreau, T. Busch, C. Gordon: Evolving criteria for research facilities: vibration. Proc. SPIE 5933 "
    "(2005); VC-A … VC-E also in IEST-RP-CC012";
const char* const iso =
    "base curve of ISO 2631-2:1989 for combined directions times 8, 4, 2 or 1, as tabled by C. Gordon: Generic "
    "criteria "
    "for vibration-sensitive equipment. Proc. SPIE 1619 (1991)";

/// A constant velocity from 8 to 80 Hz, and the constant acceleration from 4 to 8 Hz in millionths of standard gravity.
Points above_8_hz(double velocity, double acceleration) {
  const auto at = [&](double hertz) {
    return micro * acceleration * foundation::standard_gravity / (foundation::two_pi * hertz);
  };
  return {{4, at(4)}, {8, at(8)}, {8, micro * velocity}, {80, micro * velocity}};
}

/// A constant velocity from 1 to 80 Hz.
Points constant(double velocity) { return {{1, micro * velocity}, {80, micro * velocity}}; }

/// The shape of the base curve: the acceleration falls with the root of the frequency up to 4 Hz, is constant up to
/// 8 Hz, and the velocity is constant above.
Points of_people(double velocity) {
  const double at_4 = 2 * velocity, at_1 = at_4 * std::pow(4, 1.5);
  return {{1, micro * at_1}, {4, micro * at_4}, {8, micro * velocity}, {80, micro * velocity}};
}

}  // namespace

const std::vector<NamedLimitLine>& named_limit_lines() {
  static const std::vector<NamedLimitLine> lines = {
      {"VC-A", above_8_hz(50, 260), gordon},
      {"VC-B", above_8_hz(25, 130), gordon},
      {"VC-C", constant(12.5), gordon},
      {"VC-D", constant(6.25), gordon},
      {"VC-E", constant(3.12), gordon},
      {"VC-F", constant(1.56), gordon},
      {"VC-G", constant(0.78), gordon},
      {"workshop", of_people(800), iso},
      {"office", of_people(400), iso},
      {"residential day", of_people(200), iso},
      {"operating theatre", of_people(100), iso},
  };
  return lines;
}

const NamedLimitLine* named_limit_line(const std::string& name) {
  const auto found = std::ranges::find(named_limit_lines(), name, &NamedLimitLine::name);
  return found == named_limit_lines().end() ? nullptr : &*found;
}

std::string names_of_limit_lines() {
  std::vector<std::string> names;
  for (const NamedLimitLine& line : named_limit_lines()) names.push_back(foundation::quoted(line.name));
  return foundation::comma_separated(names);
}

}  // namespace trivet::project
