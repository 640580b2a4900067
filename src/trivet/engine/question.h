// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/engine/request.h"

namespace trivet::engine {

/// A command whose result the page wants.
struct Want {
  Request request;         ///< without its case; that of the question is that of all
  std::string known = {};  ///< hash of the result that the page has already; if it is still the same, it is not sent
};

/// What a page sends (docs/serve.md), to the server or to the kernel of a notebook. Keys that a question does not use
/// are absent.
struct Question {
  double revision = 0;                     ///< counts the changes of the page; in the answer again
  std::optional<std::string> text = {};    ///< of the edited file; otherwise the file as it was opened
  std::vector<std::string> settings = {};  ///< "elements.mount.scale = 1.5"
  std::string case_name = {};
  std::optional<std::string> new_case = {};  ///< name of a case to add to the text, like `case_name`
  std::vector<Want> wants = {};
  std::string version = {};  ///< of the file with which the edits began; empty: any
};

/// @throws foundation::InvalidInput with a sentence if the body is not the JSON of a question
[[nodiscard]] Question read_question(const std::string& body);

}  // namespace trivet::engine
