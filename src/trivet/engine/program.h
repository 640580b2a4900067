// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/problems.h"

/// What a program around the engine needs besides sessions: its version, texts without a project, and its end.
namespace trivet::engine {

/// "0.2.0"
[[nodiscard]] std::string version();
/// Keeps freed memory for the next computation; call this first.
void keep_freed_memory();
/// Ends child processes and removes temporary folders and unfinished results, from any thread.
void remove_leftovers();

/// A commented project file to begin with.
[[nodiscard]] std::string starter_text();
/// The JSON Schema of the project file.
[[nodiscard]] std::string project_schema();
/// The text of a project file; rejects what is none.
[[nodiscard]] foundation::Expected<std::string> read_source(const std::string& file);
/// (name, what it holds) of every format of `export`.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> export_formats();

/// Problems as the command line prints them, a line each; at most 100, then the number of the others.
[[nodiscard]] std::string message_list(const foundation::Problems& problems);
/// The problem with the caller's word for settings in place of that of the command line: "changes: ".
[[nodiscard]] foundation::Problem with_word_of_settings(const foundation::Problem& problem, std::string_view word);
/// A text on one line, with control characters made visible.
[[nodiscard]] std::string on_one_line(std::string_view text);
[[nodiscard]] std::string quoted(std::string_view text);
/// The reason of a failure in words, also of the system.
[[nodiscard]] std::string failure_words(const std::exception& failure);

}  // namespace trivet::engine
