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
)" + further + "[analyses]\n" + map;
}

/// 5 × 4 designs of it.
inline const std::string two_axes =
    "x = {parameter = \"elements.spring.scale\", from = 0.5, to = 2, points = 5}, "
    "y = {parameter = \"elements.spring.damping.proportional\", from = 0.01, to = 0.3, points = 4}";

}  // namespace trivet::test
