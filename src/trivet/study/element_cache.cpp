// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/element_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "trivet/study/source_file.h"
#include "trivet/study/version.h"

namespace trivet::study {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> folder() {
  if (const char* given = std::getenv("TRIVET_CACHE")) return *given ? std::optional<fs::path>(given) : std::nullopt;
  if (const char* given = std::getenv("XDG_CACHE_HOME"); given && *given) return fs::path(given) / "trivet";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "trivet";
  return std::nullopt;
}

std::string bytes_of(const std::vector<double>& numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

}  // namespace

std::string content_key(const std::string& description, const std::vector<std::string>& files) {
  std::string all = std::string(version()) + "\n" + description;
  for (const std::string& name : files) {
    std::ifstream file(name, std::ios::binary);
    all += "\n" + sha256(std::string(std::istreambuf_iterator<char>(file), {}));
  }
  return sha256(all);
}

std::optional<std::vector<double>> cached_numbers(const std::string& key) {
  const auto where = folder();
  if (!where) return std::nullopt;
  std::ifstream file(*where / key, std::ios::binary);
  const std::string all(std::istreambuf_iterator<char>(file), {});
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
  std::error_code ignored;  // without a writable folder, the next run computes again
  fs::create_directories(*where, ignored);
  const fs::path unfinished = *where / fmt::format("{}.{}", key, getpid());
  {
    std::ofstream file(unfinished, std::ios::binary);
    const std::string bytes = bytes_of(numbers);
    file << sha256(bytes) << bytes;
    if (!file) {
      file.close();
      fs::remove(unfinished, ignored);
      return;
    }
  }
  fs::rename(unfinished, *where / key, ignored);
}

}  // namespace trivet::study
