// SPDX-License-Identifier: BSD-3-Clause
#include "support/projects.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include "trivet/judging/read_project.h"

namespace trivet::test {

project::Project project(const std::string& text, const std::vector<std::string>& settings) {
  auto result = judging::project_from_text(text, "test.toml", settings);
  if (!result)
    for (const auto& problem : result.error().list()) ADD_FAILURE() << foundation::message(problem);
  return std::move(result).value();
}

std::string chain(const std::vector<double>& masses, const std::vector<double>& springs,
                  const std::vector<double>& dashpots, const std::vector<double>& loss_factors,
                  const std::string& orientation) {
  std::string text = "trivet = 1\n";
  for (std::size_t i = 0; i < masses.size(); ++i) {
    text += fmt::format("[bodies.m{}]\nmass = {}\nfree = [\"x\"]\nposition = [{}, {}, 0]\n", i + 1, masses[i],
                        0.6 * static_cast<double>(i + 1), 0.8 * static_cast<double>(i + 1));
    if (!orientation.empty()) text += "orientation = " + orientation + "\n";
  }
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const bool last = i == masses.size();
    if (springs[i] == 0) continue;
    text += fmt::format(
        "[elements.k{}]\ntype = \"three_springs\"\non = \"m{}\"\nat = [0, 0, 0]\ntranslation = [{}, 0, 0]\n", i + 1,
        last ? i : i + 1, springs[i]);
    if (i > 0 && !last) text += fmt::format("from = \"m{}\"\n", i);
    const double dashpot = i < dashpots.size() ? dashpots[i] : 0;
    const double loss = i < loss_factors.size() ? loss_factors[i] : 0;
    if (dashpot > 0) text += fmt::format("damping = {{translation = [{}, 0, 0]}}\n", dashpot);
    if (loss > 0) text += fmt::format("damping = {{loss_factor = {}}}\n", loss);
  }
  return text;
}

std::complex<double> value(const study::ResponseResult& result, const std::string& name, Eigen::Index at) {
  for (const auto& curve : result.curves.curves)
    if (curve.name == name) return curve.value(at);
  throw std::out_of_range("no curve " + name);
}

std::string driven_pair() {
  return chain({10, 4}, {40000, 20000, 0}, {60, 30, 0}) +
      "[excitations.force]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [10, 0, 0]\n";
}

std::string sagging_mass() {
  return R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.m1]
mass = 10
free = ["z"]
[elements.k1]
type = "three_springs"
on = "m1"
at = [0, 0, 0]
translation = [0, 0, 40000]
)";
}

}  // namespace trivet::test
