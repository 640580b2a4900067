// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "trivet/engine/session.h"
#include "trivet/foundation/interruption.h"
#include "trivet/server/permitted_files.h"

namespace trivet::server {

/// The project with a text and settings, opened. The last sessions are kept, so that a slider costs
/// `engine::Session::changed` alone, and what was computed for one page stays if another page has other settings of the
/// same text. Thread-safe.
class OpenedSessions {
 public:
  using Shared = std::shared_ptr<const engine::Session>;
  static constexpr std::size_t most_kept =
      16;  ///< of four pages with three names each, and their texts without settings

  /// @param source  name of the project in messages, and the file to whose folder names are relative
  explicit OpenedSessions(std::string source) : source_(std::move(source)) {}

  /// Files that texts may name from now on.
  void permit(PermittedFiles files);

  /// @param client    the page that asks. Of each text the last session with settings of each page is kept
  /// @param progress  of opening; may throw foundation::Interrupted
  [[nodiscard]] foundation::Expected<Shared> of(const std::string& client, const std::string& text,
                                                const std::vector<std::string>& settings,
                                                const foundation::Progress& progress = {});
  /// Of a text with errors: good for this request alone, which may not look at the wrong tables.
  [[nodiscard]] foundation::Expected<engine::Session> only_for(const engine::Request& request, const std::string& text,
                                                               const std::vector<std::string>& settings,
                                                               const foundation::Progress& progress) const;
  /// Names of files in a text that the page may not name.
  [[nodiscard]] foundation::Problems refused_files(const std::string& text,
                                                   const std::vector<std::string>& settings) const;

 private:
  struct Kept {
    Shared session;
    std::set<std::string> clients;  ///< with settings: the pages that had it last
  };

  /// Null if there is none. It is then the one that was used last.
  [[nodiscard]] Shared kept(const std::string& client, const std::string& text,
                            const std::vector<std::string>& settings);
  [[nodiscard]] foundation::Expected<Shared> opened(const std::string& client, const std::string& text);
  /// @param permission  under which it was opened: it is not kept under a newer one
  Shared keep(const std::string& client, engine::Session session, std::size_t permission);
  /// Ends what a page had of the text of this session, which is now its own. To be called with the lock.
  /// @returns what no page has any more, to be destroyed without it
  [[nodiscard]] std::vector<Kept> given_up(const std::string& client, const Shared& now);
  [[nodiscard]] PermittedFiles files(std::size_t* permission = nullptr) const;

  std::string source_;
  mutable std::mutex lock_;
  PermittedFiles files_;
  std::size_t permission_ = 0;  ///< counts changes of `files_`
  std::deque<Kept> kept_;       ///< the one that was used last is the first
};

}  // namespace trivet::server
