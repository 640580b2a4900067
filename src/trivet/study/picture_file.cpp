// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/picture_file.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/file_writing.h"

namespace trivet::study {
namespace {

namespace fs = std::filesystem;

/// Nothing, or the head of an SVG file: declaration, comments and document type may stand before the element.
bool is_earlier_picture(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  if (head.empty()) return stream.eof();
  const std::size_t start = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (start == std::string::npos) return false;
  const auto begins = [&](const char* words) { return head.compare(start, std::string(words).size(), words) == 0; };
  return begins("<svg") || ((begins("<?xml") || begins("<!DOCTYPE svg")) && head.find("<svg") != std::string::npos);
}

}  // namespace

PictureFile::PictureFile(const fs::path& target, const fs::path& project) {
  const auto refuse = [&](const std::string& reason) { throw foundation::InvalidInput(fmt::format("{}: {}", target.string(), reason)); };
  std::error_code error;
  target_ = fs::weakly_canonical(fs::absolute(target), error);
  if (error) refuse(error.message());
  if (fs::exists(target_)) {
    if (fs::equivalent(target_, project, error)) refuse("this is the project file itself; give the picture a name of its own");
    if (fs::is_directory(target_)) refuse("this is a folder; name a file inside it");
    if (!fs::is_regular_file(target_) || !is_earlier_picture(target_)) refuse("it exists and holds something else than an SVG picture; choose another name");
  }
  if (!fs::is_directory(target_.parent_path(), error)) refuse(fmt::format("there is no folder {}; make it, or choose another", target_.parent_path().string()));
  working_ = name_beside(target_, "partial");
  try {
    write_file(working_, "", target_);
  } catch (const std::runtime_error& reason) {
    refuse(fmt::format("{}; choose a folder where you may write", reason.what()));
  }
}

PictureFile::~PictureFile() {
  std::error_code ignored;
  fs::remove(working_, ignored);
}

void PictureFile::publish(const std::string& svg) const {
  write_file(working_, svg, target_);
  std::error_code error;
  fs::rename(working_, target_, error);
  if (error) throw std::runtime_error(fmt::format("cannot put {} in place: {}", target_.string(), error.message()));
}

}  // namespace trivet::study
