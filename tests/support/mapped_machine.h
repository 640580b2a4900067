// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::test {

/// A machine on one spring, free along z; the map is added by each test.
inline std::string mapped_machine(const std::string& map, const std::string& further = "") {
  return R"(
trivet = 1
[bodies.machine]
mass = 10
free = ["z"]
points.seat = [0, 0, 0.1]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1000, 1000, 1000]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 10]
)" + further +
      "[analyses]\n" + map;
}

/// Axes of a map of 5 × 4 designs of the machine.
inline const std::string two_axes =
    "x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 5}, "
    "y = {parameter = \"elements.spring.damping.proportional\", from = 0.01, to = 0.3, points = 4}";

/// A block of six coordinates on one spring through its centre, with a force along x off the centre; the map with these
/// two axes allows no peak of any coordinate.
inline std::string mapped_block(const std::string& x, const std::string& y) {
  return R"(
trivet = 1
[bodies.block]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[elements.spring]
type = "bushing"
on = "block"
at = [0, 0, 0]
translation = [900, 1100, 1300]
rotation = [90, 80, 70]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "block"
at = [0, 0, 0.1]
force = [1, 0, 0]
[analyses.map]
no_peak = "coordinates"
x = )" +
      x + "\ny = " + y + "\n";
}

}  // namespace trivet::test
