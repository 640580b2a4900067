// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/element_cache.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <system_error>

#include "trivet/foundation/files.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/foundation/version.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_entry = 1u << 20;  // the largest stored one has 2.4 kB

std::optional<fs::path> folder() {
  if (const char* given = std::getenv("TRIVET_CACHE")) return *given ? std::optional<fs::path>(given) : std::nullopt;
  if (const char* given = std::getenv("XDG_CACHE_HOME"); given && *given) return fs::path(given) / "trivet";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "trivet";
  return std::nullopt;
}

/// Removes what killed runs left, once per run, also if no new entry is stored.
void clean(const fs::path& cache) {
  static std::once_flag cleaned;
  std::call_once(cleaned, [&] { foundation::remove_abandoned_folders(cache); });
}

std::string bytes_of(const std::vector<double>& numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

}  // namespace

std::string content_key(const std::string& description, const std::vector<std::string>& files) {
  std::string all = std::string(foundation::version()) + "\n" + description;
  for (const std::string& name : files) {
    std::ifstream file(name, std::ios::binary);
    all += "\n" + sha256(std::string(std::istreambuf_iterator<char>(file), {}));
  }
  return sha256(all);
}

std::optional<std::vector<double>> cached_numbers(const std::string& key) {
  const auto where = folder();
  if (!where) return std::nullopt;
  clean(*where);
  const foundation::FolderHandle cache(*where);
  const auto found = cache.is_open() ? cache.content(key, largest_entry) : std::nullopt;
  if (!found) return std::nullopt;
  const std::string& all = *found;
  constexpr std::size_t digest = 64;
  if (all.size() < digest || (all.size() - digest) % sizeof(double) != 0) return std::nullopt;
  std::vector<double> numbers((all.size() - digest) / sizeof(double));
  std::copy(all.begin() + digest, all.end(), reinterpret_cast<char*>(numbers.data()));
  if (sha256(bytes_of(numbers)) != all.substr(0, digest)) return std::nullopt;
  return numbers;
}

void keep_numbers(const std::string& key, const std::vector<double>& numbers) {
  const auto where = folder();
  if (!where) return;
  try {
    std::error_code ignored;
    fs::create_directories(*where, ignored);
    const foundation::TemporaryFolder unfinished(*where);
    const std::string bytes = bytes_of(numbers);
    foundation::write_new_file(foundation::FolderHandle(unfinished.path()), key, sha256(bytes) + bytes, *where / key);
    const foundation::Undisturbed step;
    fs::rename(unfinished.path() / key, *where / key, ignored);  // replaces a link, and does not follow it
  } catch (const std::runtime_error&) {
    // Without a writable folder, or on a full disk, the next run computes again.
  }
}

}  // namespace trivet::project
