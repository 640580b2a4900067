// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/engine/request.h"
#include "trivet/engine/result.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"

namespace trivet::study {
class SolvedCase;
}

namespace trivet::engine {

class KeyReader;
class SolvedCases;

enum class KeyKind {
  flag,    ///< yes or no
  count,   ///< a whole number ≥ 1
  choice,  ///< one of `choices`
  text,    ///< anything else: a text that is not empty, a number or a list, as `about` says
  file     ///< name of a file that is written
};

/// A key of a command, besides those of its table in the project file.
struct Key {
  const char* name;  ///< "at": --at on a command line
  KeyKind kind;
  std::string about;
  std::vector<std::string> choices = {};  ///< of a text: those that are known, for completion
  const char* by_default = "";
  bool repeatable = false, required = false;
  bool positional = false;       ///< NAME after the project, instead of an option
  const char* excludes = "";     ///< a key that must not be given with it
  const char* short_name = "";   ///< "o": -o
  bool without_project = false;  ///< asks something that is about no project
  const char* value = "";        ///< what is given, in the help: "FROM,TO"; empty: by its kind
};

enum class Group { whole, machine, harmonic, time, nonlinear, design, data };
/// The heading of a group in the help: "Frequencies and harmonic curves".
[[nodiscard]] const char* heading(Group group);

/// What a command runs on. References live as long as the run; what the result keeps, it shares.
struct Task {
  const struct Command& command;
  std::shared_ptr<const project::Project> project;
  const std::vector<std::string>& settings;  ///< changes of the file that the project was read with
  const project::Case& variant;              ///< the case that was requested, or the base model
  const KeyReader& keys;
  const Request& request;
  const foundation::Progress& progress;
  SolvedCases& solved;
};

/// One row of the table of commands: everything that a command line, Python, a report or a page know of it.
struct Command {
  std::string name;
  std::string about;  ///< one line of help
  Group group;
  bool of_one_case;  ///< otherwise of the whole project
  /// Of a command of the whole project: what `--case` does, "judge this case alone"; empty: it is refused.
  std::string case_alone = {};
  std::string without_case = {};  ///< why it is refused, and what to do instead
  /// Tables of the file whose errors stop the command; others are ignored. `all_tables`: every one.
  std::vector<std::string> looks_at = {};
  bool all_tables = false;
  bool is_analysis = false;  ///< a table of this name in [analyses] has more keys
  std::vector<Key> keys = {};
  bool json = true, csv = false, strict = false;
  bool warnings_within = false;  ///< its text contains the warnings of all cases; otherwise they are on standard error
  bool for_programs = false;     ///< arrays alone, without a text
  std::vector<std::string> examples = {};
  /// @throws foundation::InvalidInput if the request is wrong, NotComputable if there is no result
  Result (*run)(const Task& task) = nullptr;
  /// Of a request with a key `without_project`.
  Result (*run_alone)(const KeyReader& keys) = nullptr;
};

/// All commands that ask something of a project.
[[nodiscard]] const std::vector<Command>& commands();

/// What a key takes, for the help: "FROM,TO", "FILE", "N"; empty for a flag.
[[nodiscard]] std::string value_name(const Key& key);

/// Has the command a key that asks without a project?
[[nodiscard]] bool can_be_alone(const Command& command);

/// nullptr if there is no such command.
[[nodiscard]] const Command* find_command(std::string_view name);

/// Path of the command's table in the project file: "analyses.orders", "operation".
[[nodiscard]] std::string file_table(const Command& command);

/// Keys of the command's table in the project file with their descriptions, from the schema: "  band  …" per line.
[[nodiscard]] std::string file_keys(const Command& command);

}  // namespace trivet::engine
