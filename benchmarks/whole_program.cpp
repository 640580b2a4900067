// SPDX-License-Identifier: BSD-3-Clause
// How long does the program take from its start to its end? Peaks of the paper's example, and the map of a million
// designs on all cores.
#include <filesystem>
#include <string>

#include "measure.h"
#include "process.h"

using namespace trivet::benchmarks;

int main() {
  const std::string example = TRIVET_EXAMPLES, question = "whole program";
  const Run peaks = median({TRIVET_PROGRAM, "peaks", example + "/corrected.toml"}, 21);
  record(question, "`trivet peaks` of the paper's example, wall", 1e3 * peaks.wall, "ms", "≤ 20", peaks.wall <= 0.020);
  record(question, "… CPU", 1e3 * peaks.cpu, "ms", "", true);

  if (!std::filesystem::exists(example + "/map.toml")) return 0;
  const double before = idle_part();
  const Run map = median({TRIVET_PROGRAM, "map", example + "/map.toml", "--points", "1000x1000"}, 7);
  const bool idle = before >= 0.9 && idle_part() >= 0.9;
  const std::string which = "`trivet map` of 1,000,000 designs on all cores, wall";
  record(question, which + (idle ? "" : " (contended)"), map.wall, "s", "≤ 2", map.wall <= 2);
  record(question, "… CPU of all threads", map.cpu, "s", "", true);
  record(question, "… memory", map.memory / 1e6, "MB", "", true);
}
