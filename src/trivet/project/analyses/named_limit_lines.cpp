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
const char* const people = "ISO criteria for people in buildings as tabled by Amick and others (2005), from 8 to 80 Hz";

/// A constant velocity from 8 to 80 Hz, and the constant acceleration from 4 to 8 Hz in millionths of standard gravity.
Points above_8_hz(double velocity, double acceleration) {
  const auto at = [&](double hertz) {
    return micro * acceleration * foundation::standard_gravity / (foundation::two_pi * hertz);
  };
  return {{4, at(4)}, {8, at(8)}, {8, micro * velocity}, {80, micro * velocity}};
}

/// A constant velocity up to 80 Hz. @param from  lowest frequency [Hz]  @param velocity  rms [um/s]
Points constant(double from, double velocity) { return {{from, micro * velocity}, {80, micro * velocity}}; }

}  // namespace

const std::vector<NamedLimitLine>& named_limit_lines() {
  static const std::vector<NamedLimitLine> lines = {
      {"VC-A", above_8_hz(50, 260), gordon},
      {"VC-B", above_8_hz(25, 130), gordon},
      {"VC-C", constant(1, 12.5), gordon},
      {"VC-D", constant(1, 6.25), gordon},
      {"VC-E", constant(1, 3.12), gordon},
      {"VC-F", constant(1, 1.56), gordon},
      {"VC-G", constant(1, 0.78), gordon},
      {"workshop", constant(8, 800), people},
      {"office", constant(8, 400), people},
      {"residential day", constant(8, 200), people},
      {"operating theatre", constant(8, 100), people},
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
