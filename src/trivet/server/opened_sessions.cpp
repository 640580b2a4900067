// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/opened_sessions.h"

#include <algorithm>
#include <utility>

namespace trivet::server {

void OpenedSessions::permit(PermittedFiles files) {
  const std::scoped_lock guard(lock_);
  files_ = std::move(files);
  ++permission_;
  kept_.clear();
}

PermittedFiles OpenedSessions::files(std::size_t* permission) const {
  const std::scoped_lock guard(lock_);
  if (permission) *permission = permission_;
  return files_;
}

OpenedSessions::Shared OpenedSessions::kept(const std::string& text, const std::vector<std::string>& settings) {
  const std::scoped_lock guard(lock_);
  const auto found = std::ranges::find_if(
      kept_, [&](const Shared& one) { return one->settings() == settings && one->text() == text; });
  if (found == kept_.end()) return nullptr;
  std::rotate(kept_.begin(), found, found + 1);
  return kept_.front();
}

OpenedSessions::Shared OpenedSessions::keep(engine::Session session, std::size_t permission) {
  auto shared = std::make_shared<const engine::Session>(std::move(session));
  std::deque<Shared> ended;  // destroyed without the lock
  const std::scoped_lock guard(lock_);
  if (permission != permission_) return shared;
  // Of a text only the last settings are kept: a slider does not take the places of the sessions of other texts.
  const auto other = [&](const Shared& one) {
    return one->settings().empty() || shared->settings().empty() || one->text() != shared->text();
  };
  const auto same = std::stable_partition(kept_.begin(), kept_.end(), other);
  ended.assign(same, kept_.end());
  kept_.erase(same, kept_.end());
  kept_.push_front(shared);
  if (kept_.size() > most_kept) {
    ended.push_back(std::move(kept_.back()));
    kept_.pop_back();
  }
  return shared;
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::opened(const std::string& text) {
  if (Shared found = kept(text, {})) return found;
  std::size_t permission = 0;
  if (auto refused = files(&permission).refused_in_text(text, source_); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  auto session = engine::Session::open({.name = source_, .text = text});
  if (!session) return tl::make_unexpected(std::move(session.error()));
  return keep(std::move(*session), permission);
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::of(const std::string& text,
                                                                const std::vector<std::string>& settings) {
  if (Shared found = kept(text, settings)) return found;
  std::size_t permission = 0;
  const PermittedFiles permitted = files(&permission);  // before that of the text: it may become a newer one
  const auto base = opened(text);
  if (!base || settings.empty()) return base;
  if (auto refused = permitted.refused_in_settings(settings); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  auto session = (*base)->changed(settings);
  if (!session) return tl::make_unexpected(std::move(session.error()));
  return keep(std::move(*session), permission);
}

foundation::Expected<engine::Session> OpenedSessions::only_for(const engine::Request& request, const std::string& text,
                                                               const std::vector<std::string>& settings) const {
  return engine::Session::open({.name = source_, .text = text}, settings, &request);
}

foundation::Problems OpenedSessions::refused_files(const std::string& text,
                                                   const std::vector<std::string>& settings) const {
  const PermittedFiles permitted = files();
  foundation::Problems refused = permitted.refused_in_text(text, source_);
  refused.add(permitted.refused_in_settings(settings));
  return refused;
}

}  // namespace trivet::server
