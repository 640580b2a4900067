// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/file_writing.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "trivet/foundation/index.h"

namespace trivet::foundation {

void write_new_file(const FolderHandle& folder, const std::string& name, const std::string& content,
                    const std::filesystem::path& shown) {
  const int file =
      openat(folder.descriptor(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  bool good = file >= 0;
  std::size_t count = 0;
  while (good && count < content.size()) {
    const ssize_t written = write(file, content.data() + count, content.size() - count);
    if (written < 0 && errno == EINTR) continue;
    good = written > 0;
    count += to_size(std::max<ssize_t>(0, written));
  }
  int reason = good ? 0 : errno;
  if (file >= 0 && close(file) != 0 && reason == 0) reason = errno;  // some file systems report a full disk only here
  if (reason != 0 || !good)
    throw std::runtime_error(fmt::format("cannot write {}: {}", shown.string(), std::strerror(reason)));
}

}  // namespace trivet::foundation
