// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/stored_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <system_error>

namespace trivet::foundation {

void StoredWords::word(std::string_view name) {
  if (!words_.empty() && words_.back() != '\n') words_ += ' ';
  words_ += name;
}

void StoredWords::whole(std::uint64_t number) { word(fmt::format_int(number).c_str()); }

void StoredWords::exact(double number) { whole(std::bit_cast<std::uint64_t>(number)); }

void StoredWords::text(std::string_view bytes) {
  whole(bytes.size());
  words_ += ' ';
  words_ += bytes;
}

void StoredWords::end_line() { words_ += '\n'; }

std::string_view WordReader::next() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size()));
  const std::string_view found = rest_.substr(0, rest_.find_first_of(" \n"));
  if (found.empty()) throw DamagedText("the text ends too early");
  rest_.remove_prefix(found.size());
  return found;
}

void WordReader::word(std::string_view name) {
  if (const std::string_view found = next(); found != name)
    throw DamagedText(fmt::format("\"{}\" in place of \"{}\"", found, name));
}

std::uint64_t WordReader::whole() {
  const std::string_view found = next();
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), number);
  if (error != std::errc() || end != found.data() + found.size())
    throw DamagedText(fmt::format("\"{}\" in place of a whole number", found));
  return number;
}

std::uint64_t WordReader::at_most(std::uint64_t most) {
  const std::uint64_t number = whole();
  if (number > most) throw DamagedText(fmt::format("{} is more than {}", number, most));
  return number;
}

double WordReader::exact() { return std::bit_cast<double>(whole()); }

std::string WordReader::text() {
  const std::uint64_t size = whole();
  if (rest_.empty() || rest_.size() - 1 < size) throw DamagedText("the text ends too early");
  std::string bytes(rest_.substr(1, size));
  rest_.remove_prefix(1 + size);
  return bytes;
}

void WordReader::end() {
  if (rest_.find_first_not_of(" \n") != std::string_view::npos) throw DamagedText("more follows than was stored");
}

}  // namespace trivet::foundation
