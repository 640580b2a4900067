// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>

namespace trivet::test {

/// A machine on three bushings with skew axes, its feet on the foundation "deck" (given by `foundation`, empty: on the
/// rigid ground).
[[nodiscard]] inline std::string machine_on_deck(const std::string& foundation, const std::string& rest) {
  std::string text = R"(trivet = 1
[bodies.machine]
mass = 400
inertia = {about = "center_of_mass", xx = 30, yy = 50, zz = 60, xy = 4}
center_of_mass = [0.02, 0.01, 0.3]
position = [0.2, -0.1, 0.5]
)";
  const char* const places[] = {"[0.5, 0.4, -0.2]", "[-0.5, -0.4, -0.2]", "[0.5, -0.4, -0.2]"};
  for (int i = 0; i < 3; ++i)
    text += fmt::format(
        "[elements.m{}]\ntype = \"bushing\"\non = \"machine\"\nat = {}\norientation = {{axis = [1, 2, 0.5], angle = "
        "\"{} deg\"}}\n"
        "translation = [2e6, 2e6, 4e6]\nrotation = [1e3, 1e3, 1e3]\ndamping = {{proportional = 0.002}}\n{}",
        i + 1, places[i], 20 * i, foundation.empty() ? "" : "foundation = \"deck\"\n");
  return text + foundation + rest;
}

}  // namespace trivet::test
