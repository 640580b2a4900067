// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace trivet::test {

/// A project with one body on eight skew mounts and twenty parameters: stiffness factors and places of mounts, mass,
/// centre of mass and inertia; with requirements of all kinds that families of designs judge.
/// @param damping  keys of each mount
[[nodiscard]] inline std::string machine_with_twenty_numbers(const std::string& damping) {
  std::string text =
      "trivet = 1\ngravity = [0, 0, -9.80665]\n[bodies.machine]\nmass = 900\ncenter_of_mass = [0.05, -0.02, 0.4]\n"
      "inertia = {about = \"center_of_mass\", xx = 60, yy = 140, zz = 120, xy = 4, xz = -7, yz = 2}\n"
      "points.seat = [0.6, 0.2, 0.8]\n[excitations.f]\ntype = \"harmonic\"\non = \"machine\"\nat = [0.1, 0.05, 0.3]\n"
      "force = [100, 60, 250]\n";
  std::string parameters;
  const auto add = [&](const std::string& name, const std::string& path, const std::string& range) {
    parameters += "[parameters." + name + "]\npath = '" + path + "'\n" + range + "\n";
  };
  for (int i = 0; i < 8; ++i) {
    const std::string name = "m" + std::to_string(i), x = std::to_string(-0.9 + 0.26 * i), y = i % 2 ? "0.4" : "-0.4";
    text += "[elements." + name + "]\ntype = \"bushing\"\non = \"machine\"\nat = [" + x + ", " + y +
        ", 0.0]\ntranslation = [2e5, 3e5, 6e5]\nrotation = [400, 500, 300]\norientation = {axis = [0.2, 0.1, 1], angle "
        "= 0." +
        std::to_string(i) + "}\n" + damping;
    add("k" + std::to_string(i), "elements." + name + ".stiffness_factor.z",
        "from = 0.4\nto = 3\nspacing = \"logarithmic\"");
    if (i < 4) {
      add("x" + std::to_string(i), "elements." + name + ".at.x", "from = -1\nto = 1");
      add("z" + std::to_string(i), "elements." + name + ".at.z", "from = -0.2\nto = 0.3");
    }
  }
  add("mass", "bodies.machine.mass", "from = 700\nto = 1200");
  add("height", "bodies.machine.center_of_mass.z", "from = 0.2\nto = 0.6");
  add("roll", "bodies.machine.inertia.xx", "from = 50\nto = 80");
  add("product", "bodies.machine.inertia.xz", "from = -12\nto = 5");
  return text + parameters +
      "[analyses.response]\nband = [\"2 Hz\", \"40 Hz\"]\n[requirements]\nband = [\"2 Hz\", \"40 Hz\"]\n"
      "limits = {\"machine.seat.z\" = \"1 mm\", \"ground.force.x\" = 300, \"m2.deflection.z\" = \"0.3 mm\"}\n"
      "no_peak = \"machine.seat.z\"\nnatural_frequencies = {avoid = [[\"9 Hz\", \"10 Hz\"]], separation = 1.05}\n"
      "decoupling = {machine = \"80 %\"}\nstatic = {\"machine.z\" = \"5 mm\", \"m1.force.z\" = 3000}\n";
}

}  // namespace trivet::test
