// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/foundation/plain_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace trivet::report {

std::vector<CurveGroup> curve_groups(const std::vector<CurveName>& curves) {
  std::vector<CurveGroup> result;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::string& full = curves[c].name;
    const std::size_t dot = full.rfind('.');
    std::string name = full.substr(0, dot), component = full.substr(dot + 1);
    bool lower = curves[c].unit.starts_with("rad");
    const bool forces = curves[c].unit.starts_with("N");
    if (forces) {
      lower = name.ends_with(".moment");
      component = (lower ? "M" : "F") + component;
      name = name.substr(0, name.rfind('.'));
    } else if (lower && component.size() == 2) {
      component = "θ" + component.substr(1);  // rx, ry, rz
    }
    auto group =
        std::ranges::find_if(result, [&](const CurveGroup& g) { return g.name == name && g.forces == forces; });
    if (group == result.end()) group = result.insert(result.end(), CurveGroup{name, forces, {}, {}});
    (lower ? group->lower : group->upper).push_back({component, c});
  }
  return result;
}

std::string file_part(std::string name) {
  const auto unsafe = [](char c) {
    return static_cast<unsigned char>(c) < 0x80 && !std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-';
  };
  std::ranges::replace_if(name, unsafe, '_');
  return foundation::shortened(name, longest_file_part);
}

std::string density_unit(const std::string& unit) {
  const bool composed = unit.find_first_of("/ ") != std::string::npos;
  return (composed ? "(" + unit + ")" : unit) + "²/Hz";
}

}  // namespace trivet::report
