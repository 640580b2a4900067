// SPDX-License-Identifier: BSD-3-Clause
#include "cli/colours.h"

#include <unistd.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <string>
#include <string_view>

namespace trivet::cli {
namespace {

constexpr std::string_view red = "\033[31m", green = "\033[32m", yellow = "\033[33m", plain = "\033[0m";

struct Painted {
  std::string_view words, colour;
};
constexpr std::array painted_words = {
    Painted{"VIOLATED", red},    Painted{"VIOLATES", red},      Painted{"NOT COMPUTED", red},
    Painted{"error:", red},      Painted{"NOT JUDGED", yellow}, Painted{"not judged", yellow},
    Painted{"warning:", yellow}, Painted{"meets its", green},   Painted{"All requirements are met", green},
    Painted{"met", green},
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Is "met" the word of a table's last column? In a sentence it may follow "0 of 1 requirements".
bool is_painted_here(std::string_view text, std::size_t from, const Painted& one) {
  const std::size_t end = from + one.words.size();
  if (!text.substr(from).starts_with(one.words)) return false;
  if ((from > 0 && is_letter(text[from - 1])) || (end < text.size() && is_letter(text[end]))) return false;
  return one.words != "met" || ((end == text.size() || text[end] == '\n') && from > 1 && text[from - 2] == ' ');
}

}  // namespace

bool has_colours(int stream) {
  const char* none = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool is_dumb = !terminal || *terminal == '\0' || std::string_view(terminal) == "dumb";
  return isatty(stream) != 0 && (!none || *none == '\0') && !is_dumb;
}

std::string painted(std::string_view text, bool paint) {
  if (!paint) return std::string(text);
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const Painted* found = nullptr;
    for (const Painted& one : painted_words)
      if (!found && is_painted_here(text, i, one)) found = &one;
    if (!found) {
      result += text[i++];
      continue;
    }
    result.append(found->colour).append(found->words).append(plain);
    i += found->words.size();
  }
  return result;
}

}  // namespace trivet::cli
