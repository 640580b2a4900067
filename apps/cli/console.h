// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"

namespace trivet::cli {

/// 3 and 4 only with --strict: computed and written, but a limit or rule is broken, or there are warnings alone.
enum ExitCode { done = 0, not_computed = 1, wrong_input = 2, over_a_limit = 3, with_warnings = 4, reader_left = 141 };

/// Occupies the numbers of standard streams that were closed when the program was started, so that no file gets them
/// and our output. Writing there stays an error. To be called first.
void occupy_closed_streams();

/// Writes to standard output and makes sure it arrived. Once the reader of a pipe has left (`trivet … | head`), nothing
/// more is written.
/// @throws std::runtime_error if the disk is full
void write_output(const std::string& text);

/// `code`, or reader_left if the reader of standard output left before the end: what a shell reports of any program in
/// its place (128 + SIGPIPE).
[[nodiscard]] int exit_code(int code);

/// To standard error. If nobody reads that either, there is nothing left to do.
void write_error(std::string_view text);

/// Every problem on a line of its own, on standard error; at most 100, then the number of the others.
void write_problems(const foundation::Problems& problems);

/// What stopped the work, as one line in the program's own words, on standard error.
void write_failure(const std::exception& failure);

/// Shows progress on a terminal.
[[nodiscard]] foundation::Progress progress();

}  // namespace trivet::cli
