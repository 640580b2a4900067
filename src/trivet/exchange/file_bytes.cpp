// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/file_bytes.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "trivet/foundation/index.h"

namespace trivet::exchange {
namespace {

tl::unexpected<foundation::Problems> refused(const std::filesystem::path& path, std::string finding,
                                             std::string remedy) {
  return foundation::failure({.origin = {path.string()},
                              .subject = "matrix file",
                              .finding = std::move(finding),
                              .rule = "it must be a readable file with a matrix in it",
                              .remedy = std::move(remedy)});
}

}  // namespace

foundation::Expected<std::string> file_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return refused(path, "no such file", "check the path; it is relative to the folder of the project file");
  if (std::filesystem::is_directory(status)) return refused(path, "this is a directory", "name the file inside it");
  if (!std::filesystem::is_regular_file(status))
    return refused(path, "this is a pipe or a device", "write it to a file first and name that");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refused(path, std::strerror(errno), "check its permissions");
  std::string bytes, chunk(1u << 16, '\0');
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || stream.gcount() > 0) {
    bytes.append(chunk, 0, to_size(stream.gcount()));
    if (bytes.size() > largest_matrix_file)
      return refused(path, fmt::format("larger than {} MiB", largest_matrix_file >> 20),
                     "condense the model to its interface nodes first");
  }
  if (stream.bad()) return refused(path, "reading failed", "check the disk");
  if (bytes.empty()) return refused(path, "the file is empty", "did the program that wrote it finish?");
  return bytes;
}

}  // namespace trivet::exchange
