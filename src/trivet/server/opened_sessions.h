// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "trivet/engine/session.h"
#include "trivet/server/permitted_files.h"

namespace trivet::server {

/// The project with a text and settings, opened. The last sessions are kept, so that a slider costs
/// `engine::Session::changed` alone, also if two pages have different texts. Thread-safe.
class OpenedSessions {
 public:
  using Shared = std::shared_ptr<const engine::Session>;
  static constexpr std::size_t most_kept = 4;  ///< of two pages, each without and with settings

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
  /// Null if there is none. It is then the one that was used last.
  [[nodiscard]] Shared kept(const std::string& text, const std::vector<std::string>& settings);
  [[nodiscard]] foundation::Expected<Shared> opened(const std::string& text);
  /// @param permission  under which it was opened: it is not kept under a newer one
  Shared keep(engine::Session session, std::size_t permission);
  [[nodiscard]] PermittedFiles files(std::size_t* permission = nullptr) const;

  std::string source_;
  mutable std::mutex lock_;
  PermittedFiles files_;
  std::size_t permission_ = 0;  ///< counts changes of `files_`
  std::deque<Shared> kept_;     ///< the one that was used last is the first
};

}  // namespace trivet::server
