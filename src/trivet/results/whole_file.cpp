// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/whole_file.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "trivet/foundation/file_writing.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::results {

namespace fs = std::filesystem;

WholeFile::WholeFile(const fs::path& target, const std::function<std::string(const fs::path&)>& refusal) {
  const auto refuse = [&](const std::string& reason) {
    throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason));
  };
  std::error_code error;
  target_ = fs::absolute(target, error);
  if (error) refuse(fmt::format("the current folder cannot be found ({})", error.message()));
  const fs::file_status status = fs::symlink_status(target_, error);
  if (error && status.type() != fs::file_type::not_found) refuse(error.message());
  if (fs::exists(status)) {
    if (fs::is_symlink(status))
      refuse("this is a symbolic link, which is neither followed nor replaced; name the file itself");
    if (fs::is_directory(status)) refuse("this is a folder; name a file inside it");
    if (const std::string reason = fs::is_regular_file(status) ? refusal(target_) : "this is a pipe or a device";
        !reason.empty())
      refuse(reason);
  }
  if (!fs::is_directory(target_.parent_path(), error))
    refuse(fmt::format("there is no folder {}; create it, or choose another", target_.parent_path().string()));
  try {
    temporary_ = std::make_unique<foundation::TemporaryFolder>(target_.parent_path());
  } catch (const std::system_error& reason) {
    refuse(fmt::format("cannot write there: {}; choose a folder with write permission", reason.code().message()));
  }
}

void WholeFile::publish(const std::string& text) const {
  constexpr const char* name = "whole";
  foundation::write_new_file(foundation::FolderHandle(temporary_->path()), name, text, target_);
  const foundation::Undisturbed step;
  std::error_code error;
  fs::rename(temporary_->path() / name, target_,
             error);  // replaces a link that was created meanwhile, without following it
  if (error) throw std::runtime_error(fmt::format("cannot replace {}: {}", target_.string(), error.message()));
}

}  // namespace trivet::results
