// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "trivet/exports/format_table.h"
#include "trivet/exports/unique_names.h"
#include "trivet/exports/zip_archive.h"
#include "trivet/project/input_files.h"

/// Archives of NumPy: an array "response/machine.z" for each array, and "about", JSON with its unit and axes.
namespace trivet::exports {
namespace {

using results::LabelledArray;

/// Header of the format .npy 1.0 or 2.0, padded to a multiple of 64 bytes.
std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string sizes;
  for (const std::size_t size : shape) sizes += fmt::format("{}, ", size);
  std::string words = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, sizes);
  constexpr std::size_t before = 10, multiple = 64;
  words.append(multiple - (before + words.size() + 1) % multiple, ' ');
  words += '\n';
  std::string header = "\x93NUMPY";
  header += {'\1', '\0', static_cast<char>(words.size() & 0xff), static_cast<char>(words.size() >> 8)};
  return header + words;
}

template <typename T>
std::string npy(const std::string& type, const std::vector<std::size_t>& shape, const std::vector<T>& numbers) {
  std::string bytes = npy_header(type, shape);
  const std::size_t start = bytes.size();
  bytes.resize(start + numbers.size() * sizeof(T));
  if (!numbers.empty()) std::memcpy(bytes.data() + start, numbers.data(), numbers.size() * sizeof(T));
  return bytes;
}

std::string npy_texts(const std::vector<std::size_t>& shape, const std::vector<std::string>& texts) {
  std::vector<std::u32string> all;
  std::size_t longest = 1;
  for (const std::string& text : texts) {
    all.push_back(code_points(text));
    longest = std::max(longest, all.back().size());
  }
  std::vector<char32_t> padded;
  for (std::u32string& text : all) {
    text.resize(longest, U'\0');
    padded.insert(padded.end(), text.begin(), text.end());
  }
  return npy(fmt::format("<U{}", longest), shape, padded);
}

std::string npy_of(const LabelledArray& array) {
  if (array.is_text()) return npy_texts(array.shape, array.texts());
  if (array.is_complex()) return npy("<c16", array.shape, array.complex_numbers());
  return npy("<f8", array.shape, array.real_numbers());
}

/// Names of files in the archive: without the characters that paths of some systems do not allow.
std::string entry_name(const std::string& name) {
  std::string entry = name;
  for (char& c : entry)
    if (c == ':' || c == '\\' || static_cast<unsigned char>(c) < ' ') c = '_';
  for (std::size_t at = 0; (at = entry.find("//", at)) != std::string::npos;) entry.insert(at + 1, "_");
  return entry;
}

std::vector<std::string> write_numpy(const Content& content, const Target& target, const foundation::Progress&) {
  ZipArchive archive;
  nlohmann::ordered_json about{{"source", content.words()}, {"sha256", project::input_hash(content.project)}};
  UniqueNames used;
  std::vector<std::string> lost;
  for (const Group& group : content.groups)
    for (const LabelledArray& array : group.arrays.list()) {
      const std::string name = group.name + "/" + array.name, entry = used.unique(entry_name(name));
      if (entry != name) lost.push_back(fmt::format("\"{}\" is named \"{}\"", name, entry));
      archive.add(entry + ".npy", npy_of(array));
      about["arrays"][entry] = {{"name", name}, {"unit", array.unit}, {"axes", array.axes}};
    }
  // The path of the project may have bytes that are no UTF-8.
  const std::string words = about.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  archive.add("about.npy", npy_texts({}, {words}));
  write_bytes(target.path(), archive.bytes());
  return lost;
}

}  // namespace

const Format numpy_format = {
    "numpy", "NumPy archive (.npz): matrices and results with units", Target::Kind::file, {}, false, write_numpy};

}  // namespace trivet::exports
