// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/files.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::foundation {

FolderHandle::FolderHandle(const std::filesystem::path& path)
    : descriptor_(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {}

FolderHandle::~FolderHandle() {
  if (descriptor_ >= 0) close(descriptor_);
}

FolderHandle& FolderHandle::operator=(FolderHandle&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FolderHandle FolderHandle::folder(const std::string& name) const {
  FolderHandle found;
  found.descriptor_ = openat(descriptor_, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  return found;
}

FolderHandle FolderHandle::made_folder(const std::string& name, mode_t mode) const {
  if (mkdirat(descriptor_, name.c_str(), mode) != 0 && errno != EEXIST) return {};
  return folder(name);
}

FolderHandle::Kind FolderHandle::kind(const std::string& name) const {
  struct stat status;
  if (fstatat(descriptor_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
    return errno == ENOENT ? Kind::none : Kind::other;
  return S_ISREG(status.st_mode) ? Kind::file
      : S_ISDIR(status.st_mode)  ? Kind::folder
      : S_ISLNK(status.st_mode)  ? Kind::link
                                 : Kind::other;
}

std::vector<std::string> FolderHandle::names() const {
  const int again = openat(descriptor_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);  // separate reading position
  DIR* const stream = again >= 0 ? fdopendir(again) : nullptr;
  if (!stream) {
    const int reason = errno;
    if (again >= 0) close(again);
    throw std::system_error(reason, std::generic_category(), "a folder cannot be read");
  }
  std::vector<std::string> list;
  while (const dirent* entry = readdir(stream)) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") list.push_back(name);
  }
  closedir(stream);
  std::ranges::sort(list);
  return list;
}

std::optional<std::string> FolderHandle::content(const std::string& name, std::size_t largest) const {
  const int file =
      openat(descriptor_, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);  // a FIFO does not block
  if (file < 0) return std::nullopt;
  struct stat status;
  std::optional<std::string> bytes;
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && to_size(status.st_size) <= largest) {
    bytes.emplace(to_size(status.st_size), '\0');
    std::size_t count = 0;
    while (count < bytes->size()) {
      const ssize_t found = read(file, bytes->data() + count, bytes->size() - count);
      if (found < 0 && errno == EINTR) continue;
      if (found <= 0) break;
      count += to_size(found);
    }
    if (count < bytes->size()) bytes.reset();
  }
  close(file);
  return bytes;
}

bool FolderHandle::is_same_file(const std::string& name, const FolderHandle& other,
                                const std::string& other_name) const {
  struct stat one, two;
  return fstatat(descriptor_, name.c_str(), &one, AT_SYMLINK_NOFOLLOW) == 0 &&
      fstatat(other.descriptor_, other_name.c_str(), &two, AT_SYMLINK_NOFOLLOW) == 0 && one.st_dev == two.st_dev &&
      one.st_ino == two.st_ino;
}

const char* kind_name(FolderHandle::Kind kind) {
  switch (kind) {
    case FolderHandle::Kind::none:
      return "nothing";
    case FolderHandle::Kind::file:
      return "a file";
    case FolderHandle::Kind::folder:
      return "a folder";
    case FolderHandle::Kind::link:
      return "a symbolic link";
    case FolderHandle::Kind::other:
      return "neither a file nor a folder";
  }
  return "";
}

void write_new_file(const FolderHandle& folder, const std::string& name, const std::string& content,
                    const std::filesystem::path& shown, mode_t mode) {
  const int file =
      openat(folder.descriptor(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
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
