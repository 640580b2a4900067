// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/results/format/quantity_name.h"

namespace trivet::report {

/// A curve of a group: its label "x", "θx", "Fx", "Mx", and its index.
struct GroupedCurve {
  std::string label;
  std::size_t curve = 0;
};

/// Curves in one picture: "machine", "machine.seat", "ground" …, translations or forces above, rotations or moments
/// below.
struct CurveGroup {
  std::string name;
  bool forces = false;  ///< of an element or the ground; a body may have the same name
  std::vector<GroupedCurve> upper, lower;
};

struct CurveName {
  std::string name, unit;
};

[[nodiscard]] std::vector<CurveGroup> curve_groups(const std::vector<CurveName>& curves);

/// Names and units of curves of any type.
template <typename Curves>
[[nodiscard]] std::vector<CurveName> curve_names(const Curves& curves) {
  std::vector<CurveName> names;
  for (const auto& curve : curves) names.push_back({curve.name, curve.unit});
  return names;
}

using results::quantity_name;

/// Largest number of bytes of a name in a file name; file systems allow 255 in total.
inline constexpr std::size_t longest_file_part = 100;

/// A name as part of a file name, of at most longest_file_part bytes.
[[nodiscard]] std::string file_part(std::string name);

/// Unit of the spectral density of a quantity: "mm" → "mm²/Hz", "m/s²" → "(m/s²)²/Hz".
[[nodiscard]] std::string density_unit(const std::string& unit);

}  // namespace trivet::report
