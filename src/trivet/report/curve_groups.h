// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::report {

/// A curve among its neighbours: "x", "θx", "Fx", "Mx", and its index.
struct GroupedCurve {
  std::string label;
  std::size_t curve = 0;
};

/// Curves that share a picture: "machine", "machine.seat", "ground" … with translations or forces above, rotations or
/// moments below.
struct CurveGroup {
  std::string name;
  std::vector<GroupedCurve> upper, lower;
};

struct CurveName {
  std::string name, unit;
};

[[nodiscard]] std::vector<CurveGroup> curve_groups(const std::vector<CurveName>& curves);

/// Names and units of anything that has both.
template <typename Curves>
[[nodiscard]] std::vector<CurveName> curve_names(const Curves& curves) {
  std::vector<CurveName> names;
  for (const auto& curve : curves) names.push_back({curve.name, curve.unit});
  return names;
}

/// "displacement" for m, "moment" for N m …
[[nodiscard]] std::string quantity_name(const std::string& unit);

/// Bytes of a name that go into a file name; file systems allow 255 for the whole.
inline constexpr std::size_t longest_file_part = 100;

/// A name as part of a file name, of at most longest_file_part bytes.
[[nodiscard]] std::string file_part(std::string name);

/// "rms" of a unit as the unit of its spectral density: "mm" → "mm²/Hz", "m/s²" → "(m/s²)²/Hz".
[[nodiscard]] std::string density_unit(const std::string& unit);

}  // namespace trivet::report
