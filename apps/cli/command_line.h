// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/engine/command.h"
#include "trivet/engine/session.h"

namespace trivet::cli {

enum class Form { text, json, csv };

/// What a command line requests.
struct CommandLine {
  const engine::Command* command = nullptr;  ///< nullptr for `new` and `schema`
  engine::Source source;
  std::vector<std::string> settings;  ///< of --set
  Form form = Form::text;
  std::string output;     ///< file for the result, whose ending chooses the form; empty: standard output
  bool is_shown = false;  ///< the page that was written, in a browser
  bool strict = false;
  bool full = false;                         ///< every row and column of tables
  bool paint = false, paint_errors = false;  ///< colours on standard output, on standard error
  engine::Request request;
};

/// Runs the command and writes its result to standard output and standard error. @returns the exit code
[[nodiscard]] int run(CommandLine line);

}  // namespace trivet::cli
