// SPDX-License-Identifier: BSD-3-Clause
// How long does the program take from its start to its end? Peaks of the paper's example, the map of a million designs
// on all cores, and maps of 101 × 101 designs with loss factors, an unbalance and a moving ground.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "measure.h"
#include "process.h"
#include "trivet/foundation/temporary_folder.h"

namespace {

using namespace trivet::benchmarks;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The map of a project, for which `text` is written to a file.
void measure_map(const std::string& what, const std::string& text, double goal) {
  const trivet::foundation::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "project.toml";
  std::ofstream(file) << text;
  const Run map = median({TRIVET_PROGRAM, "map", file.string(), "--points", "101"}, 5);
  record("whole program", "`trivet map` of 101 × 101 designs, " + what + ", CPU", map.cpu, "s",
         "≤ " + std::to_string(static_cast<int>(goal)), map.cpu <= goal);
}

/// The paper's map with another excitation and without its rules on peaks.
std::string map_of_paper(const std::filesystem::path& examples, const std::string& excitation) {
  const std::string text = text_of(examples / "paper/map.toml");
  const std::size_t from = text.find("[excitations.force]"), to = text.find("[analyses.map]");
  std::string result = text.substr(0, from) + excitation + text.substr(to);
  const std::string peaks = "no_peak = \"coordinates\"\n";
  return result.erase(result.find(peaks), peaks.size());
}

void measure_maps(const std::filesystem::path& examples) {
  const std::string axes = R"(
[analyses.map]
x = {parameter = 'elements."upper front".scale', from = 0.3, to = 3, spacing = "logarithmic"}
y = {parameter = 'elements."upper rear".scale', from = 0.3, to = 3, spacing = "logarithmic"}
band = ["0.5 Hz", "100 Hz"]
limits = {"pump.z" = "2 mm", "pump.ry" = "5 mrad", "ground.force.z" = "300 N"}
)";
  const std::string raft = text_of(examples / "two_stage/pump_on_raft.toml") + axes;
  measure_map("two bodies, loss factors, three limits", raft, 3);
  measure_map("the same without peaks of the pump", raft + "no_peak = \"pump\"\n", 3);
  measure_map("one body, rotating unbalance, six limits", map_of_paper(examples, R"(
[excitations.rotor]
type = "unbalance"
on = "aggregate"
at = [0, 0, 0]
axis = "x"
mass_eccentricity = "0.1 kg m"

)"),
              2);
  measure_map("one body, moving ground, six limits", map_of_paper(examples, R"(
[excitations.floor]
type = "base"
translation = [0.001, 0, 0.002]

)"),
              2);
}

/// A search of one process on one core, and of two that share a study folder, on a core each.
void measure_shared_search(const std::string& project) {
  const std::string search = TRIVET_PROGRAM " optimize " + project + " --set analyses.optimize.starts=600";
  const auto wall = [](const std::string& command) { return median({"bash", "-c", command}, 3).wall; };
  const double alone = wall("taskset -c 0 " + search);
  const trivet::foundation::TemporaryFolder folder;
  const std::string study = (folder.path() / "study").string(), in_study = search + " -o " + study;
  const double shared = wall("rm -rf " + study + "; taskset -c 0 " + in_study + " --part 1/2 & taskset -c 1 " +
                             in_study + " --part 2/2 & wait; test -f " + study + "/result.json");
  record("whole program", "`trivet optimize` of 8 numbers, 600 starts, one core, wall", alone, "s", "", true);
  record("whole program", "… two processes of a core each in a study folder, times as fast", alone / shared, "",
         "≥ 1.7", alone / shared >= 1.7);
}

}  // namespace

int main() {
  const std::string example = TRIVET_EXAMPLES, question = "whole program";
  const Run peaks = median({TRIVET_PROGRAM, "peaks", example + "/corrected.toml"}, 21);
  record(question, "`trivet peaks` of the paper's example, wall", 1e3 * peaks.wall, "ms", "≤ 20", peaks.wall <= 0.020);
  record(question, "… CPU", 1e3 * peaks.cpu, "ms", "", true);

  measure_maps(std::filesystem::path(example).parent_path());
  const std::string powertrain = (std::filesystem::path(example).parent_path() / "powertrain/decoupled.toml").string();
  const Run search = median({TRIVET_PROGRAM, "optimize", powertrain, "--set", "analyses.optimize.starts=32"}, 5);
  record(question, "`trivet optimize` of 8 numbers, 32 starts, all cores, wall", search.wall, "s", "≤ 2",
         search.wall <= 2);
  record(question, "… CPU of all threads", search.cpu, "s", "", true);
  measure_shared_search(powertrain);
  const double before = idle_part();
  const Run map = median({TRIVET_PROGRAM, "map", example + "/map.toml", "--points", "1000x1000"}, 7);
  const bool idle = before >= 0.9 && idle_part() >= 0.9;
  const std::string which = "`trivet map` of 1,000,000 designs on all cores, wall";
  record(question, which + (idle ? "" : " (contended)"), map.wall, "s", "≤ 2", map.wall <= 2);
  record(question, "… CPU of all threads", map.cpu, "s", "", true);
  record(question, "… memory", map.memory / 1e6, "MB", "", true);
}
