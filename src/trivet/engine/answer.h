// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "trivet/documents/json_text.h"
#include "trivet/engine/question.h"
#include "trivet/engine/session.h"
#include "trivet/foundation/interruption.h"

namespace trivet::engine {

/// The project that a question is about, with its text and settings.
struct Questioned {
  foundation::Expected<std::shared_ptr<const Session>> session;
  std::string version = {};  ///< of the file; empty: there is none
  /// Opens a wrong project for one request, which may not look at the wrong tables. Empty: no request is answered.
  std::function<foundation::Expected<Session>(const Request&)> only_for = {};
};

/// The answer of /ask (docs/serve.md) as JSON: problems of the project in the case of the question, and the results
/// that it wants. A wrong project or request is content, too; requests that would write a file are rejected.
/// @throws foundation::Interrupted from the progress
[[nodiscard]] std::string answer_json(const Question& question, const Questioned& questioned,
                                      const foundation::Progress& progress = {});

/// Problems as an answer lists them.
[[nodiscard]] documents::json::Json problem_list(const foundation::Problems& problems);
/// Warnings of a case; none if there is no such case.
[[nodiscard]] foundation::Problems warnings_of(const Session& session, const std::string& case_name);

}  // namespace trivet::engine
