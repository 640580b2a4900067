// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/project.h"

namespace trivet::report {

/// Project, client, machine, revision and author of [report], then date, program, input file and its SHA-256.
[[nodiscard]] std::string title_block(const project::Project& project);

/// The text of the input file as it was read, with the settings of the command line and the names of its cases.
[[nodiscard]] std::string input_file(const project::Project& project);

}  // namespace trivet::report
