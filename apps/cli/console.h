// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace trivet::cli {

/// Occupies the descriptors of standard streams that were closed at the start of the program, so that no file gets them
/// and receives our output. Writing to them remains an error. Call this first.
void occupy_closed_streams();

/// Writes to standard output and flushes it. After the reader of a pipe has left (`trivet … | head`), writes nothing.
/// @throws std::runtime_error if the disk is full
void write_output(std::string_view text);

/// `code`, or 141 if the reader of standard output left before the end: the code that a shell reports for any program
/// in this case (128 + SIGPIPE).
[[nodiscard]] int exit_code(int code);

/// Characters in a line of standard output: COLUMNS if that is set, otherwise those of the terminal; no limit in a file
/// or a pipe.
[[nodiscard]] std::size_t output_width();

/// Writes to standard error; errors are ignored.
void write_error(std::string_view text);

}  // namespace trivet::cli
