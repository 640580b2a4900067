// SPDX-License-Identifier: BSD-3-Clause
// How long does the best of a million combinations of mounts take? A generating set on three pairs of mounts with loss
// factors; the same question for 10,648 combinations in Python with SciPy, whose winner must be the same.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "measure.h"
#include "process.h"
#include "trivet/foundation/temporary_folder.h"

namespace {

using namespace trivet::benchmarks;
namespace fs = std::filesystem;

constexpr const char* genset = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.genset]
mass = 3100
center_of_mass = [-0.38, 0, 0.56]
inertia = {about = "center_of_mass", xx = 540, yy = 2900, zz = 2700, xz = -90}
points.turbocharger = [1.2, 0.2, 1.3]
[tables.elements]
rows = [
  {name = "front left",   type = "front",  on = "genset", at = [1.3, 0.5, 0]},
  {name = "front right",  type = "front",  on = "genset", at = [1.3, -0.5, 0]},
  {name = "middle left",  type = "middle", on = "genset", at = [0, 0.5, 0]},
  {name = "middle right", type = "middle", on = "genset", at = [0, -0.5, 0]},
  {name = "rear left",    type = "rear",   on = "genset", at = [-1.3, 0.5, 0]},
  {name = "rear right",   type = "rear",   on = "genset", at = [-1.3, -0.5, 0]},
]
[excitations.firing]
type = "harmonic"
on = "genset"
at = [0, 0, 0.5]
moment = [420, 0, 0]
[requirements]
band = ["45 Hz", "55 Hz"]
limits = {"genset.turbocharger.y" = 9e-6, "ground.force.y" = 120}
natural_frequencies = {avoid = [["20 Hz", "30 Hz"], ["45 Hz", "55 Hz"]]}
mount_load = "catalogue"
)";

/// Mounts of growing stiffness, otherwise spread without a pattern.
std::string catalogue(int mounts) {
  std::string text = "catalogue = 1\ntitle = \"maker\"\nsource = \"made up\"\n";
  for (int i = 0; i < mounts; ++i) {
    const double k = 2.5e5 * std::pow(12, double(i) / (mounts - 1)), side = 0.5 + 0.004 * (i * 37 % 100),
                 eta = 0.05 + 0.0012 * (i * 61 % 100);
    text += fmt::format(
        "[mounts.m{}]\nmaker = \"none\"\ntranslation = [{}, {}, {}]\nrotation = [{}, {}, {}]\nloss_factor = {}\n"
        "static_load = [{}, {}]\nstatic_deflection_limit = 0.007\nprice = \"{:.2f} EUR\"\n",
        i, side * k, 0.8 * side * k, k, 1e-3 * k, 1e-3 * k, 1e-3 * k, eta, 0.0012 * k, 0.0065 * k, 20 + 0.7 * i);
  }
  return text;
}

/// Writes the files. @param for_python  without what only Trivet reads
void write(const fs::path& folder, int mounts, bool for_python) {
  std::ofstream(folder / "maker.toml") << catalogue(mounts);
  std::string text = genset;
  text += for_python ? "price = 900\n" : "price = \"900 EUR\"\n";
  for (const char* place : {"front", "middle", "rear"}) {
    if (for_python) continue;
    text += fmt::format(
        "[element_types.{0}]\ntype = \"catalogue:m{1}\"\ncatalogue = \"maker.toml\"\n[parameters.{0}]\npath = "
        "\"element_types.{0}.type\"\ncatalogue = \"maker.toml\"\n",
        place, mounts / 2);
  }
  std::ofstream(folder / "genset.toml") << text;
}

nlohmann::json answer_of(const std::string& command, const fs::path& folder, Run& run, int runs) {
  const fs::path file = folder / "answer.json";
  run = median({"/bin/sh", "-c", "exec " + command + " > '" + file.string() + "'"}, runs);
  return nlohmann::json::parse(std::ifstream(file));
}

}  // namespace

int main() {
  const std::string question = "mounts out of a catalogue";
  const trivet::foundation::TemporaryFolder folder;
  const std::string project = "'" + (folder.path() / "genset.toml").string() + "'",
                    select = std::string("'") + TRIVET_PROGRAM + "' select " + project + " --json";
  Run ours, theirs, million;
  write(folder.path(), 22, true);
  const auto python = answer_of(
      std::string("'") + TRIVET_PYTHON + "' '" + TRIVET_RIVALS + "/selection.py' '" + folder.path().string() + "'",
      folder.path(), theirs, 1);
  write(folder.path(), 22, false);
  const auto found = answer_of(select, folder.path(), ours, 3);
  const auto& best = found.at("best").at(0);
  const std::vector<std::string> mounts = {best.at("mounts").at("front"), best.at("mounts").at("middle"),
                                           best.at("mounts").at("rear")};
  if (python.at("mounts") != mounts) {
    std::fprintf(stderr, "another winner than in Python\n");
    return 1;
  }
  constexpr double grid = 1e-4;  // the band holds no resonance: its ends decide
  compared("margin of the winner", std::abs(best.at("margin").get<double>() / python.at("margin").get<double>() - 1),
           grid);
  const double seconds = python.at("seconds").get<double>();
  record(question, "`trivet select`, 10,648 combinations, CPU", ours.cpu, "s", "", true);
  record(question, "Python with SciPy, the same winner, CPU without its start", seconds, "s", "", true);
  record(question, "… × ours", seconds / ours.cpu, "", "", true);

  write(folder.path(), 100, false);
  const double before = idle_part();
  const auto all = answer_of(select, folder.path(), million, 3);
  const bool idle = before >= 0.9 && idle_part() >= 0.9;
  record(question,
         std::string("`trivet select`, 1,000,000 combinations on all cores, wall") + (idle ? "" : " (contended)"),
         million.wall, "s", "≤ 10", million.wall <= 10);
  record(question, "… CPU of all threads", million.cpu, "s", "", true);
  record(question, "… memory", million.memory / 1e6, "MB", "", true);
  record(question, "… of which amplitudes were computed exactly", all.at("curves").get<double>(), "combinations", "",
         true);
  for (const auto& one : all.at("failed"))
    record(question, "… fall out by " + one.at("test").get<std::string>(), one.at("combinations").get<double>(),
           "combinations", "", true);
}
