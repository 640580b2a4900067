// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/file_writing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace trivet::study {

std::filesystem::path name_beside(const std::filesystem::path& target, const std::string& purpose) {
  return target.parent_path() / fmt::format(".{}.{}-{}", target.filename().string(), purpose, static_cast<long>(::getpid()));
}

void write_file(const std::filesystem::path& path, const std::string& content, const std::filesystem::path& shown) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}: {}", shown.string(), errno ? std::strerror(errno) : "unknown reason"));
}

}  // namespace trivet::study
