// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/opened_sessions.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "trivet/foundation/thread_progress.h"

namespace trivet::server {

void OpenedSessions::permit(PermittedFiles files) {
  decltype(kept_) ended;  // destroyed without the lock
  const std::scoped_lock guard(lock_);
  files_ = std::move(files);
  ++permission_;
  ended.swap(kept_);
}

PermittedFiles OpenedSessions::files(std::size_t* permission) const {
  const std::scoped_lock guard(lock_);
  if (permission) *permission = permission_;
  return files_;
}

std::vector<OpenedSessions::Kept> OpenedSessions::given_up(const std::string& client, const Shared& now) {
  std::vector<Kept> ended;
  if (now->settings().empty()) return ended;
  const auto is_earlier = [&](const Kept& one) {
    return one.session != now && !one.session->settings().empty() && one.session->text() == now->text();
  };
  for (Kept& one : kept_)
    if (is_earlier(one)) one.clients.erase(client);
  const auto left = std::stable_partition(kept_.begin(), kept_.end(),
                                          [&](const Kept& one) { return !is_earlier(one) || !one.clients.empty(); });
  std::move(left, kept_.end(), std::back_inserter(ended));
  kept_.erase(left, kept_.end());
  return ended;
}

OpenedSessions::Shared OpenedSessions::kept(const std::string& client, const std::string& text,
                                            const std::vector<std::string>& settings) {
  std::vector<Kept> ended;  // destroyed without the lock
  const std::scoped_lock guard(lock_);
  const auto found = std::ranges::find_if(
      kept_, [&](const Kept& one) { return one.session->settings() == settings && one.session->text() == text; });
  if (found == kept_.end()) return nullptr;
  found->clients.insert(client);
  std::rotate(kept_.begin(), found, found + 1);
  Shared session = kept_.front().session;
  ended = given_up(client, session);
  return session;
}

OpenedSessions::Shared OpenedSessions::keep(const std::string& client, engine::Session session,
                                            std::size_t permission) {
  auto shared = std::make_shared<const engine::Session>(std::move(session));
  std::vector<Kept> ended;  // destroyed without the lock
  const std::scoped_lock guard(lock_);
  if (permission != permission_) return shared;
  kept_.push_front({shared, {client}});
  // Of a page only the last settings are kept: a slider does not take the places of the sessions of others.
  ended = given_up(client, shared);
  if (kept_.size() > most_kept) {
    ended.push_back(std::move(kept_.back()));
    kept_.pop_back();
  }
  return shared;
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::opened(const std::string& client,
                                                                    const std::string& text) {
  if (Shared found = kept(client, text, {})) return found;
  std::size_t permission = 0;
  if (auto refused = files(&permission).refused_in_text(text, source_); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  auto session = engine::Session::open({.name = source_, .text = text});
  if (!session) return tl::make_unexpected(std::move(session.error()));
  return keep(client, std::move(*session), permission);
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::of(const std::string& client, const std::string& text,
                                                                const std::vector<std::string>& settings,
                                                                const foundation::Progress& progress) {
  if (Shared found = kept(client, text, settings)) return found;
  const foundation::ThreadProgress of_opening(progress);
  std::size_t permission = 0;
  const PermittedFiles permitted = files(&permission);  // before that of the text: it may become a newer one
  auto base = opened(client, text);
  if (!base || settings.empty()) return base;
  if (auto refused = permitted.refused_in_settings(settings); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  auto session = (*base)->changed(settings);
  if (!session) return tl::make_unexpected(std::move(session.error()));
  return keep(client, std::move(*session), permission);
}

foundation::Expected<engine::Session> OpenedSessions::only_for(const engine::Request& request, const std::string& text,
                                                               const std::vector<std::string>& settings,
                                                               const foundation::Progress& progress) const {
  const foundation::ThreadProgress of_opening(progress);
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
