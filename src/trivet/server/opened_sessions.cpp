// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/opened_sessions.h"

#include <utility>

namespace trivet::server {

void OpenedSessions::permit(PermittedFiles files) {
  const std::scoped_lock guard(lock_);
  files_ = std::move(files);
  of_text_.reset();
  of_settings_.reset();
}

OpenedSessions::Shared OpenedSessions::kept(const std::string& text, const std::vector<std::string>& settings) const {
  const std::scoped_lock guard(lock_);
  if (!of_text_ || text != text_) return nullptr;
  if (settings.empty()) return of_text_;
  return of_settings_ && of_settings_->settings() == settings ? of_settings_ : nullptr;
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::opened(const std::string& text) {
  if (Shared found = kept(text, {})) return found;
  if (auto refused = refused_files(text, {}); refused.has_errors()) return tl::make_unexpected(std::move(refused));
  auto session = engine::Session::open({.name = source_, .text = text});
  if (!session) return tl::make_unexpected(std::move(session.error()));
  auto shared = std::make_shared<const engine::Session>(std::move(*session));
  const std::scoped_lock guard(lock_);
  text_ = text;
  of_text_ = shared;
  of_settings_.reset();
  return shared;
}

foundation::Expected<OpenedSessions::Shared> OpenedSessions::of(const std::string& text,
                                                                const std::vector<std::string>& settings) {
  if (Shared found = kept(text, settings)) return found;
  const auto base = opened(text);
  if (!base || settings.empty()) return base;
  PermittedFiles files;
  {
    const std::scoped_lock guard(lock_);
    files = files_;
  }
  if (auto refused = files.refused_in_settings(settings); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  auto session = (*base)->changed(settings);
  if (!session) return tl::make_unexpected(std::move(session.error()));
  auto shared = std::make_shared<const engine::Session>(std::move(*session));
  const std::scoped_lock guard(lock_);
  if (of_text_ == *base) of_settings_ = shared;
  return shared;
}

foundation::Expected<engine::Session> OpenedSessions::only_for(const engine::Request& request, const std::string& text,
                                                               const std::vector<std::string>& settings) const {
  return engine::Session::open({.name = source_, .text = text}, settings, &request);
}

foundation::Problems OpenedSessions::refused_files(const std::string& text,
                                                   const std::vector<std::string>& settings) const {
  PermittedFiles files;
  {
    const std::scoped_lock guard(lock_);
    files = files_;
  }
  foundation::Problems refused = files.refused_in_text(text, source_);
  refused.add(files.refused_in_settings(settings));
  return refused;
}

}  // namespace trivet::server
