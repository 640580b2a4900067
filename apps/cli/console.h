// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "trivet/foundation/problems.h"

namespace trivet::cli {

/// 3 and 4 only with --strict: results are written, but a limit or rule is violated (3) or there are only warnings (4).
enum ExitCode { done = 0, not_computed = 1, wrong_input = 2, over_a_limit = 3, with_warnings = 4, reader_left = 141 };

/// Occupies the descriptors of standard streams that were closed at the start of the program, so that no file gets them
/// and receives our output. Writing to them remains an error. Call this first.
void occupy_closed_streams();

/// Writes to standard output and flushes it. After the reader of a pipe has left (`trivet … | head`), writes nothing.
/// @throws std::runtime_error if the disk is full
void write_output(const std::string& text);

/// `code`, or reader_left if the reader of standard output left before the end: the code that a shell reports for any
/// program in this case (128 + SIGPIPE).
[[nodiscard]] int exit_code(int code);

/// Writes to standard error; errors are ignored.
void write_error(std::string_view text);

/// Writes every problem on a separate line to standard error; at most 100, then the number of the others.
void write_problems(const foundation::Problems& problems);

/// Writes the reason of a failure as one line to standard error.
void write_failure(const std::exception& failure);

}  // namespace trivet::cli
