// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/session_start.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/index.h"

namespace trivet::server {

std::string new_token() {
  std::array<unsigned char, 32> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != to_index(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers for the token");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

RedirectFile::RedirectFile(const std::string& address) : path_((folder_.path() / "trivet.html").string()) {
  const std::string text = fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><title>Trivet</title>"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\"><a href=\"{0}\">Open the page</a>\n",
      address);
  const int file = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  const bool is_written = file >= 0 && write(file, text.data(), text.size()) == to_index(text.size());
  const int reason = errno;
  if (file >= 0) close(file);
  if (!is_written) throw std::runtime_error(fmt::format("cannot write {}: {}", path_, std::strerror(reason)));
}

}  // namespace trivet::server
