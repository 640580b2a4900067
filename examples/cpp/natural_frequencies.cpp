// SPDX-License-Identifier: BSD-3-Clause
// Which natural frequencies does the machine of a project file have?   natural_frequencies PROJECT.toml
#include <cstdio>
#include <numbers>

#include "trivet/judging/read_project.h"
#include "trivet/modal/modes.h"
#include "trivet/project/project.h"

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: natural_frequencies PROJECT.toml\n"), 2;
  const auto project = trivet::judging::read_project(arguments[1]);
  if (!project) {
    for (const auto& problem : project.error().list()) std::fprintf(stderr, "%s\n", message(problem).c_str());
    return 2;
  }
  for (const auto& mode : trivet::modal::modes(project->base().system).list)
    std::printf("mode %d: %8.4f Hz  %s\n", mode.number, mode.angular_frequency.value_or(0) / (2 * std::numbers::pi),
                mode.name.c_str());
}
