// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/study/project.h"

namespace trivet::cli {

/// What the command line said.
struct Options {
  std::string project;
  std::string case_name;
  std::vector<std::string> settings;
  bool json = false;
  bool csv = false;
  bool deep = false;
  std::string at;
  std::string band;
  std::string element;
  std::string output = "trivet-results";
};

/// Each returns the exit code.
int check_command(const Options& options);
int answer_command(const std::string& which, const Options& options);
int element_command(const Options& options);
int run_command(const Options& options);

/// The project, or nothing after its problems were printed.
[[nodiscard]] std::optional<study::Project> read_or_complain(const Options& options);

}  // namespace trivet::cli
