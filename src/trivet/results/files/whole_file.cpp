// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/whole_file.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "trivet/foundation/files.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::results {

namespace fs = std::filesystem;

namespace {

std::string reason_against(const fs::path& target, const fs::file_status& status, const Refusal& refusal) {
  if (fs::is_symlink(status))
    return "this is a symbolic link, which is neither followed nor replaced; name the file itself";
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) return "this is a pipe or a device";
  return refusal(target, status);
}

}  // namespace

std::string reason_against_folder(const fs::file_status& status) {
  return fs::is_directory(status) ? "this is a folder; name a file inside it" : "";
}

TargetPlace target_place(const fs::path& target, const Refusal& refusal) {
  const auto refuse = [&](const std::string& reason) {
    throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason));
  };
  std::error_code error;
  TargetPlace place{fs::absolute(target, error), nullptr};
  if (error) refuse(fmt::format("the current folder cannot be found ({})", error.message()));
  if (place.path.filename().empty()) place.path = place.path.parent_path();  // "folder/"
  const fs::file_status status = fs::symlink_status(place.path, error);
  if (error && status.type() != fs::file_type::not_found) refuse(error.message());
  if (fs::exists(status))
    if (const std::string reason = reason_against(place.path, status, refusal); !reason.empty()) refuse(reason);
  const fs::path folder = place.path.parent_path();
  if (!fs::is_directory(folder, error))
    refuse(fmt::format("there is no folder {}; create it, or choose another", folder.string()));
  try {
    place.temporary = std::make_unique<foundation::TemporaryFolder>(folder);
  } catch (const std::system_error& reason) {
    refuse(fmt::format("cannot write there: {}; choose a folder with write permission", reason.code().message()));
  }
  return place;
}

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

namespace {

namespace fs = std::filesystem;

/// Is the file empty or an SVG file? Declaration, comments and document type may precede the element.
bool is_earlier_picture(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(to_size(stream.gcount()));
  if (head.empty()) return stream.eof();
  const std::size_t start = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (start == std::string::npos) return false;
  const auto begins = [&](const char* words) { return head.compare(start, std::string(words).size(), words) == 0; };
  return begins("<svg") || ((begins("<?xml") || begins("<!DOCTYPE svg")) && head.find("<svg") != std::string::npos);
}

const fs::path& not_the_project(const fs::path& target, const fs::path& project) {
  std::error_code error;
  if (fs::equivalent(target, project, error))
    throw foundation::InvalidInput(
        fmt::format("{}: this is the project file; choose another name for the picture", target.string()));
  return target;
}

}  // namespace

PictureFile::PictureFile(const fs::path& target, const fs::path& project)
    : WholeFile(not_the_project(target, project), [](const fs::path& earlier) {
        return is_earlier_picture(earlier) ? std::string() : "it exists and is not an SVG picture; choose another name";
      }) {}

}  // namespace trivet::results
