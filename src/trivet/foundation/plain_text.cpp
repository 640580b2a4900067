// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace trivet::foundation {
namespace {

/// One character, or one byte that does not begin a character.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool sound = true;  ///< valid UTF-8
};

std::uint32_t byte(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

Character character_at(std::string_view text, std::size_t at) {
  const std::uint32_t lead = byte(text, at);
  if (lead < 0x80) return {lead};
  const std::size_t bytes = lead >= 0xC2 && lead < 0xE0 ? 2
      : lead >= 0xE0 && lead < 0xF0                     ? 3
      : lead >= 0xF0 && lead < 0xF5                     ? 4
                                                        : 0;
  if (bytes == 0) return {lead, 1, false};
  std::uint32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (at + i >= text.size() || (byte(text, at + i) & 0xC0) != 0x80) return {lead, 1, false};
    code = code << 6 | (byte(text, at + i) & 0x3F);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least[bytes] || surrogate || code > 0x10FFFF) return {lead, 1, false};
  return {code, bytes};
}

/// Control characters of both sets, line separators, marks that change the writing direction, and characters that XML
/// does not allow.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F ||
      (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF || code == 0xFFFE ||
      code == 0xFFFF;
}

}  // namespace

std::string shortened(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  std::size_t at = 0, end = 0;
  for (; at <= longest; at += character_at(text, at).bytes) end = at;
  return std::string(text.substr(0, end));
}

std::string quoted(std::string_view text, std::size_t longest) {
  return "\"" + shortened(text, longest) + (text.size() > longest ? "…\"" : "\"");
}

std::string comma_separated(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i == 0 ? "" : ", ") + shortened(names[i]);
  return names.size() > most ? text + fmt::format(" and {} more", names.size() - most) : text;
}

std::string on_one_line(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (!c.sound) line += fmt::format("\\x{:02x}", c.code);
    else if (c.code == '\n') line += "\\n";
    else if (is_control(c.code))
      line += c.code < 0x100 ? fmt::format("\\x{:02x}", c.code) : fmt::format("\\u{:04x}", c.code);
    else line += text.substr(at, c.bytes);
    at += c.bytes;
  }
  return line;
}

std::optional<std::string> unprintable(std::string_view text, bool one_line) {
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (!c.sound) return fmt::format("the byte {:02X}, which is not UTF-8", byte(text, at));
    const bool of_lines = c.code == '\n' || c.code == '\r' || c.code == '\t';
    if (is_control(c.code) && (one_line || !of_lines)) return fmt::format("the control character U+{:04X}", c.code);
    at += c.bytes;
  }
  return std::nullopt;
}

std::optional<ForeignByte> first_foreign_byte(std::string_view text) {
  std::size_t at = 0, line_begin = 0;
  int line = 1;
  while (at < text.size()) {
    const Character c = character_at(text, at);
    if (!c.sound) return ForeignByte{line, static_cast<int>(at - line_begin) + 1, byte(text, at)};
    at += c.bytes;
    if (c.code == '\n') ++line, line_begin = at;
  }
  return std::nullopt;
}

std::string path_key(std::string_view name) {
  const auto is_bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!name.empty() && std::ranges::all_of(name, is_bare)) return std::string(name);
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

}  // namespace trivet::foundation
