// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "trivet/engine/session.h"
#include "trivet/server/permitted_files.h"

namespace trivet::server {

/// The project with a text and settings, opened. The session of the last text and that of the last settings are kept,
/// so that a slider costs `engine::Session::changed` alone. Thread-safe.
class OpenedSessions {
 public:
  using Shared = std::shared_ptr<const engine::Session>;

  /// @param source  name of the project in messages, and the file to whose folder names are relative
  explicit OpenedSessions(std::string source) : source_(std::move(source)) {}

  /// Files that texts may name from now on.
  void permit(PermittedFiles files);

  [[nodiscard]] foundation::Expected<Shared> of(const std::string& text, const std::vector<std::string>& settings);
  /// Of a text with errors: good for this request alone, which may not look at the wrong tables.
  [[nodiscard]] foundation::Expected<engine::Session> only_for(const engine::Request& request, const std::string& text,
                                                               const std::vector<std::string>& settings) const;
  /// Names of files in a text that the page may not name.
  [[nodiscard]] foundation::Problems refused_files(const std::string& text,
                                                   const std::vector<std::string>& settings) const;

 private:
  [[nodiscard]] Shared kept(const std::string& text, const std::vector<std::string>& settings) const;
  [[nodiscard]] foundation::Expected<Shared> opened(const std::string& text);

  std::string source_;
  mutable std::mutex lock_;
  PermittedFiles files_;
  std::string text_;
  Shared of_text_, of_settings_;
};

}  // namespace trivet::server
