// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/resource_folder.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#if defined(_WIN32)
#include <windows.h>
#endif

namespace trivet::fmu {
namespace {

#if defined(_WIN32)
constexpr bool on_windows = true;

std::FILE* opened(const std::string& path) {
  std::wstring wide(path.size() + 1, L'\0');
  const int size = static_cast<int>(path.size());
  wide.resize(static_cast<std::size_t>(
      MultiByteToWideChar(CP_UTF8, 0, path.data(), size, wide.data(), static_cast<int>(wide.size()))));
  return _wfopen(wide.c_str(), L"rb");
}
#else
constexpr bool on_windows = false;

std::FILE* opened(const std::string& path) { return std::fopen(path.c_str(), "rb"); }
#endif

struct Closing {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    const std::string_view digits = text.substr(i + 1, 2);
    unsigned char character = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), character, 16);
    if (digits.size() != 2 || error != std::errc() || end != digits.data() + 2)
      throw std::runtime_error("the location of the resources has an incomplete escape");
    plain += static_cast<char>(character);
    i += 2;
  }
  return plain;
}

bool is_drive(std::string_view path) { return path.size() >= 3 && path[0] == '/' && path[2] == ':'; }

}  // namespace

std::string path_of_uri(std::string_view uri) {
  constexpr std::string_view scheme = "file:", host = "//", local = "//localhost/";
  if (!uri.starts_with(scheme)) {
    if (uri.find("://") != std::string_view::npos)
      throw std::runtime_error("the resources must be in a folder of this computer (file:)");
    return std::string(uri);
  }
  uri.remove_prefix(scheme.size());
  if (uri.starts_with(local)) uri.remove_prefix(local.size() - 1);
  else if (uri.starts_with("///")) uri.remove_prefix(host.size());
  else if (uri.starts_with(host) && !on_windows)
    throw std::runtime_error("the resources must be in a folder of this computer (file:)");
  const std::string path = without_escapes(uri);
  return on_windows && is_drive(path) ? path.substr(1) : path;
}

std::string text_in_folder(const std::string& folder, const std::string& name) {
  const bool ends = folder.ends_with('/') || (on_windows && folder.ends_with('\\'));
  const std::string path = folder + (ends ? "" : "/") + name;
  const auto fail = [&]() { throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno)); };
  errno = 0;
  const std::unique_ptr<std::FILE, Closing> file(opened(path));
  if (!file) fail();
  std::string text;
  std::array<char, 65536> part;
  while (std::feof(file.get()) == 0 && std::ferror(file.get()) == 0)
    text.append(part.data(), std::fread(part.data(), 1, part.size(), file.get()));
  if (std::ferror(file.get()) != 0) fail();
  return text;
}

}  // namespace trivet::fmu
