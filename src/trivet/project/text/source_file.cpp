// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/source_file.h"

#include <fmt/format.h>
#include <sha2.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::project {

bool is_file_key(const std::string& key) {
  static constexpr std::array<const char*, 5> keys = {"file", "catalogue", "step", "load_cases", "loops"};
  return std::ranges::find(keys, key) != keys.end();
}

std::filesystem::path named_file(const Node& name) {
  namespace fs = std::filesystem;
  const fs::path folder = name.folder.empty() ? fs::path(name.origin.source).parent_path() : fs::path(name.folder);
  return fs::path(name.text).is_absolute() ? fs::path(name.text) : folder / name.text;
}

std::optional<std::filesystem::path> read_file_name(TableReader& reader, const std::string& key) {
  assert(is_file_key(key));
  namespace fs = std::filesystem;
  if (!reader.has(key)) reader.missing(key, "name the file, relative to the project file: " + key + " = \"…\"");
  const auto name = reader.text(key);
  if (!name) return std::nullopt;
  fs::path path = named_file(*reader.node(key));
  std::error_code unreadable;
  if (!fs::is_regular_file(path, unreadable)) {
    reader.error(key, "\"" + name->substr(0, 200) + "\"", "no file of this name can be read",
                 "names are relative to the folder of the project file");
    return std::nullopt;
  }
  return path;
}

namespace {

tl::unexpected<foundation::Problems> refused(const std::filesystem::path& path, const std::string& kind,
                                             std::string finding, std::string remedy) {
  return foundation::failure({.origin = {path.string()},
                              .finding = std::move(finding),
                              .rule = "the " + kind + " must be a readable text file",
                              .remedy = std::move(remedy)});
}

/// What to name in place of a folder.
std::string project_files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (auto it = std::filesystem::directory_iterator(folder, error); !error && it != std::filesystem::end(it);
       it.increment(error))
    if (it->path().extension() == ".toml") names.push_back(it->path().string());
  std::ranges::sort(names);
  if (names.empty()) return "it has no .toml file";
  return "name a file in it: " + foundation::comma_separated(names);
}

}  // namespace

foundation::Expected<std::string> read_bytes(const std::filesystem::path& path, const std::string& kind) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return refused(path, kind, error ? error.message() : "no such file", "check the path");
  if (std::filesystem::is_directory(status)) return refused(path, kind, "this is a directory", project_files_in(path));
  if (!std::filesystem::is_regular_file(status))
    return refused(path, kind, "this is a pipe or a device", "write it to a file first and name that");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refused(path, kind, std::strerror(errno), "check its permissions");
  std::string text;
  std::string chunk(1u << 16, '\0');
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || stream.gcount() > 0) {
    text.append(chunk, 0, to_size(stream.gcount()));
    if (text.size() > largest_project_file)
      return refused(path, kind, fmt::format("larger than {} MiB", largest_project_file >> 20),
                     "is this the right file?");
  }
  if (stream.bad()) return refused(path, kind, "reading failed", "check the disk");
  return text;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == std::string_view::npos; }

foundation::Problems source_problems(std::string_view bytes, const std::filesystem::path& path,
                                     const std::string& kind) {
  if (is_blank(bytes))
    return refused(path, kind, "the file is empty",
                   kind == "project file" ? "`trivet new` prints a starter" : "was it saved?")
        .value();
  if (bytes.find('\0') != std::string_view::npos)
    return refused(path, kind, "the file contains NUL bytes",
                   "it is not a text file, or is in UTF-16: save it as UTF-8")
        .value();
  return {};
}

foundation::Problems encoding_problems(std::string_view text, const std::string& source) {
  foundation::Problems problems;
  if (const auto foreign = foundation::first_foreign_byte(text))
    problems.add(
        {.origin = {source, foreign->line, foreign->place},
         .finding = fmt::format("byte {} of the line is {:02X}, which is not UTF-8", foreign->place, foreign->byte),
         .rule = "the file must be text in UTF-8",
         .remedy = "save it as UTF-8"});
  return problems;
}

foundation::Expected<std::string> read_source(const std::filesystem::path& path, const std::string& kind) {
  foundation::Expected<std::string> text = read_bytes(path, kind);
  if (!text) return text;
  if (foundation::Problems wrong = source_problems(*text, path, kind); wrong.has_errors())
    return tl::make_unexpected(std::move(wrong));
  return text;
}

std::string sha256(const std::string& text) {
  char digest[SHA256_DIGEST_STRING_LENGTH];
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digest);
  return digest;
}

}  // namespace trivet::project
