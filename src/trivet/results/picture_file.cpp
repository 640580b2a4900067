// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/picture_file.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/file_writing.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::results {
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

}  // namespace

PictureFile::PictureFile(const fs::path& target, const fs::path& project) {
  const auto refuse = [&](const std::string& reason) {
    throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason));
  };
  std::error_code error;
  target_ = fs::absolute(target, error);
  if (error) refuse(fmt::format("the current folder cannot be found ({})", error.message()));
  const fs::file_status status = fs::symlink_status(target_, error);
  if (error && status.type() != fs::file_type::not_found) refuse(error.message());
  if (fs::exists(status)) {
    if (fs::equivalent(target_, project, error))
      refuse("this is the project file; choose another name for the picture");
    if (fs::is_symlink(status))
      refuse("this is a symbolic link, which is neither followed nor replaced; name the picture itself");
    if (fs::is_directory(status)) refuse("this is a folder; name a file inside it");
    if (!fs::is_regular_file(status) || !is_earlier_picture(target_))
      refuse("it exists and is not an SVG picture; choose another name");
  }
  if (!fs::is_directory(target_.parent_path(), error))
    refuse(fmt::format("there is no folder {}; create it, or choose another", target_.parent_path().string()));
  try {
    temporary_ = std::make_unique<foundation::TemporaryFolder>(target_.parent_path());
  } catch (const std::system_error& reason) {
    refuse(fmt::format("cannot write there: {}; choose a folder with write permission", reason.code().message()));
  }
}

void PictureFile::publish(const std::string& svg) const {
  constexpr const char* name = "picture.svg";
  foundation::write_new_file(foundation::FolderHandle(temporary_->path()), name, svg, target_);
  const foundation::Undisturbed step;
  std::error_code error;
  fs::rename(temporary_->path() / name, target_,
             error);  // replaces a link that was created meanwhile, without following it
  if (error) throw std::runtime_error(fmt::format("cannot replace {}: {}", target_.string(), error.message()));
}

}  // namespace trivet::results
