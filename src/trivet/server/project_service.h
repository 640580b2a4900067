// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/engine/question.h"
#include "trivet/foundation/interruption.h"
#include "trivet/server/answer.h"
#include "trivet/server/opened_sessions.h"
#include "trivet/server/project_file.h"

namespace trivet::server {

/// The answers of the data paths (docs/serve.md). It opens, changes, asks and saves; every number comes from the
/// engine. Thread-safe. A wrong body throws foundation::InvalidInput. `client` is the page that asks; the progress may
/// throw foundation::Interrupted.
class ProjectService {
 public:
  /// @param file        the project; empty: a page that offers examples
  /// @param resume_key  for pages, of their Resumption
  ProjectService(std::string file, bool read_only, std::string resume_key);

  /// GET /project: the file as it is on disk now, which questions without a text are about from now on.
  [[nodiscard]] Answer project(const foundation::Progress& progress);
  /// GET /version: of the file as it is on disk now; it is not opened.
  [[nodiscard]] Answer version() const;
  /// POST /ask: results of commands. Errors of the project are content, too.
  [[nodiscard]] Answer ask(const std::string& client, const std::string& body, const foundation::Progress& progress);
  /// POST /text: the text with settings, nothing is written.
  [[nodiscard]] Answer text(const std::string& client, const std::string& body);
  /// POST /save: writes the text with settings, unless the file was changed meanwhile.
  [[nodiscard]] Answer save(const std::string& client, const std::string& body);

 private:
  [[nodiscard]] FileState opened() const;
  void open(const FileState& state);
  /// The text that a question is about, and the version of the file that is opened at this moment: another page may
  /// open a newer one before the answer is complete. None: the question names a version of the file that is not the
  /// opened one, because another page has opened a newer one, or because the program was started again.
  struct Subject {
    std::string text, version;
    foundation::Problems problems;  ///< why the file has no text
  };
  [[nodiscard]] std::optional<Subject> subject_of(const engine::Question& question) const;
  /// The text with settings, or why there is none.
  [[nodiscard]] foundation::Expected<std::string> new_text(const std::string& client, const std::string& text,
                                                           const std::vector<std::string>& settings);
  /// The text with a further case, or why there is none.
  [[nodiscard]] foundation::Expected<std::string> text_with_new_case(const std::string& text,
                                                                     const engine::Question& question) const;

  const std::string file_;
  const bool read_only_;
  const std::string resume_key_;
  OpenedSessions sessions_;
  std::mutex saving_;
  mutable std::mutex lock_;
  FileState opened_;
};

/// GET /schema
[[nodiscard]] Answer schema_answer();

}  // namespace trivet::server
