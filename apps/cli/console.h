// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::cli {

/// The last two only with --strict: computed and written, but a limit or rule is broken, or there are warnings alone.
enum ExitCode { done = 0, not_computed = 1, wrong_input = 2, over_a_limit = 3, with_warnings = 4 };

/// Writes to standard output and makes sure it arrived. @throws std::runtime_error if the disk is full or the reader is gone
void write_output(const std::string& text);

/// To standard error. Where nobody reads that either, nothing is left to be told.
void write_error(std::string_view text);

/// Every problem on a line of its own, on standard error.
void write_problems(const foundation::Problems& problems);

/// Ctrl-C and SIGTERM stop the work at the next progress report instead of killing the process.
void catch_interrupts();

/// Shows progress on a terminal, and throws foundation::Interrupted once an interrupt was caught.
[[nodiscard]] foundation::Progress progress();

}  // namespace trivet::cli
