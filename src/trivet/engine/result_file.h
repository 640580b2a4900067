// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "trivet/engine/command.h"
#include "trivet/engine/request.h"
#include "trivet/engine/result.h"

namespace trivet::results {
class WholeFile;
}

namespace trivet::engine {

/// A file for a result as a whole. The ending of its name chooses the form: .json, .csv (SI), .html or .txt.
class ResultFile {
 public:
  /// @param project  the project file, which is not replaced
  /// @throws foundation::InvalidInput with the reason, before anything is computed: the ending is none of a form that
  /// the command has, the file is the project, no folder, no permission
  ResultFile(const std::string& name, const Command& command, const std::string& project);
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// @throws std::runtime_error with the reason; an earlier file then stays unchanged
  void publish(const Result& result) const;

 private:
  std::string name_, ending_;
  std::unique_ptr<const results::WholeFile> file_;
};

/// Of a command whose key `output` names a folder: the file for the result that it names instead, by an ending; the key
/// is then removed. Empty: it names none.
[[nodiscard]] std::string taken_result_file(const Command& command, Request& request);

}  // namespace trivet::engine
