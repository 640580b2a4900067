// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <thread>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/study/shared/study_manifest.h"

namespace trivet::study {
namespace {

constexpr std::string_view part_heading = "Trivet part of a study, format 3\n";
constexpr std::string_view name_start = "part-", name_middle = "-of-";

std::optional<std::uint64_t> whole_number(std::string_view words) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  if (error != std::errc() || end != words.data() + words.size()) return std::nullopt;
  return number;
}

/// A file descriptor that is closed at the end.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

/// False if another process has the lock. A file system without locks counts as locked: `has_locks` is then false.
bool lock(int file, bool& has_locks) {
  for (;;) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK) return false;
    has_locks = false;
    return true;
  }
}

/// Is this still the file of that name? Its owner may have replaced it between opening and locking it.
bool is_current(int file, const foundation::FolderHandle& folder, const std::string& name) {
  struct stat own, named;
  return fstat(file, &own) == 0 && fstatat(folder.descriptor(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
      own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

void write_all(int file, const std::string& text) {
  std::size_t count = 0;
  while (count < text.size()) {
    const ssize_t written = write(file, text.data() + count, text.size() - count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw foundation::NotComputable(std::strerror(errno));
    count += to_size(written);
  }
  if (fsync(file) != 0) throw foundation::NotComputable(std::strerror(errno));
}

}  // namespace

std::string StudyPart::file_name() const { return fmt::format("{}{}{}{}", name_start, number, name_middle, of); }

std::optional<StudyPart> StudyPart::of_file(std::string_view name) {
  const std::size_t middle = name.find(name_middle);
  if (!name.starts_with(name_start) || middle == std::string_view::npos) return std::nullopt;
  const auto number = whole_number(name.substr(name_start.size(), middle - name_start.size())),
             of = whole_number(name.substr(middle + name_middle.size()));
  if (!number || !of || *number < 1 || *number > *of || *of > most_parts) return std::nullopt;
  const StudyPart part{*number, *of};
  if (part.file_name() != name) return std::nullopt;
  return part;
}

void PartRecord::stamp(std::chrono::steady_clock::time_point start) {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  const auto since_start = std::chrono::steady_clock::now() - start;
  written_at = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::seconds>(since_1970).count());
  milliseconds = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since_start).count());
}

std::string PartRecord::text() const {
  foundation::StoredWords words;
  words.text(study);
  for (const std::uint64_t one : {written_at, milliseconds, computed, std::uint64_t{has_ended}}) words.whole(one);
  words.end_line();
  chunks.store(words);
  words.end_line();
  words.text(results);
  words.end_line();
  return with_hash_line(std::string(part_heading) + words.words());
}

std::optional<PartRecord> PartRecord::read(const std::string& text) {
  const auto all = without_hash_line(text);
  if (!all || !all->starts_with(part_heading)) return std::nullopt;
  try {
    foundation::WordReader words(std::string_view(*all).substr(part_heading.size()));
    PartRecord found;
    found.study = words.text();
    for (std::uint64_t* one : {&found.written_at, &found.milliseconds, &found.computed}) *one = words.whole();
    found.has_ended = words.at_most(1) == 1;
    found.chunks = ChunkSet::restored(words, most_chunks);
    found.results = words.text();
    words.end();
    return found;
  } catch (const foundation::DamagedText&) {
    return std::nullopt;
  }
}

OwnPart::OwnPart(const foundation::FolderHandle& folder, const StudyPart& part, const std::filesystem::path& shown)
    : folder_(folder), name_(part.file_name()), shown_(shown / name_) {
  // Whoever only asks whether the part is worked on has its lock for a moment.
  constexpr int most_tries = 50;
  constexpr std::chrono::milliseconds pause(10);
  for (int i = 0; i < most_tries; ++i) {
    OpenFile file(openat(folder.descriptor(), name_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file.get() < 0)
      throw foundation::InvalidInput(fmt::format("{}: cannot be opened: {}", shown_.string(), std::strerror(errno)));
    if (lock(file.get(), locked_) && is_current(file.get(), folder, name_)) {
      file_ = file.release();
      return;
    }
    std::this_thread::sleep_for(pause);
  }
  throw foundation::InvalidInput(
      fmt::format("{}: another process works on part {} of {}; give each process its own --part", shown.string(),
                  part.number, part.of));
}

OwnPart::~OwnPart() {
  struct stat own;  // of a part without chunks nothing stays
  if (fstat(file_, &own) == 0 && own.st_size == 0 && is_current(file_, folder_, name_))
    unlinkat(folder_.descriptor(), name_.c_str(), 0);
  close(file_);
}

void OwnPart::replace(const std::string& text) {
  const int file = replaced_file(folder_, name_, text, shown_);
  close(file_);
  file_ = file;
}

int replaced_file(const foundation::FolderHandle& folder, const std::string& name, const std::string& text,
                  const std::filesystem::path& shown) {
  const std::string unfinished = name + ".new";
  OpenFile file(
      openat(folder.descriptor(), unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666));
  try {
    if (text.size() > largest_part_file) throw foundation::NotComputable("it would have more than 1 GiB");
    if (file.get() < 0) throw foundation::NotComputable(std::strerror(errno));
    bool has_locks = true;
    static_cast<void>(lock(file.get(), has_locks));  // before it gets its name, so that the part always is locked
    write_all(file.get(), text);
    if (renameat(folder.descriptor(), unfinished.c_str(), folder.descriptor(), name.c_str()) != 0)
      throw foundation::NotComputable(std::strerror(errno));
  } catch (const foundation::NotComputable& reason) {
    if (file.get() >= 0) unlinkat(folder.descriptor(), unfinished.c_str(), 0);  // a full disk gets its space again
    throw foundation::NotComputable(
        fmt::format("{} cannot be written: {}; what it had before stays. Make room or grant the right to write, then "
                    "start the same command "
                    "again to go on",
                    shown.string(), reason.what()));
  }
  return file.release();
}

bool is_worked_on(const foundation::FolderHandle& folder, const StudyPart& part) {
  constexpr int most_tries = 20;  // the file may be replaced between opening it and asking for its lock
  for (int i = 0; i < most_tries; ++i) {
    const OpenFile file(openat(folder.descriptor(), part.file_name().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (file.get() < 0) return false;
    if (flock(file.get(), LOCK_SH | LOCK_NB) != 0) return errno == EWOULDBLOCK;
    if (is_current(file.get(), folder, part.file_name())) return false;
  }
  return true;
}

}  // namespace trivet::study
