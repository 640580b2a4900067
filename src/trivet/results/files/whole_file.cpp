// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/whole_file.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "trivet/foundation/file_writing.h"

namespace trivet::results {

namespace fs = std::filesystem;

WholeFile::WholeFile(const fs::path& target, const std::function<std::string(const fs::path&)>& refusal)
    : place_(target_place(target, [&](const fs::path& path, const fs::file_status& status) {
        const std::string folder = reason_against_folder(status);
        return folder.empty() ? refusal(path) : folder;
      })) {}

void WholeFile::publish(const std::string& text) const {
  constexpr const char* name = "whole";
  const fs::path temporary = place_.temporary->path();
  foundation::write_new_file(foundation::FolderHandle(temporary), name, text, place_.path);
  const foundation::Undisturbed step;
  std::error_code error;
  fs::rename(temporary / name, place_.path, error);  // replaces a link that was created meanwhile, not its target
  if (error) throw std::runtime_error(fmt::format("cannot replace {}: {}", place_.path.string(), error.message()));
}

}  // namespace trivet::results
