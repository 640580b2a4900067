// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::cli {

/// The whole program: reads the command line and runs it. It takes over signals and standard streams, so it is for a
/// process that does nothing else. @returns the exit code
[[nodiscard]] int main_program(int argc, char** argv);

}  // namespace trivet::cli
