// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/design_outcome.h"

#include <fmt/format.h>

#include <cassert>
#include <cctype>
#include <cmath>

#include "trivet/foundation/plain_text.h"

namespace trivet::design {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
/// Bytes of non-ASCII characters count as letters.
bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
}

/// End of the number that begins at `i`: digits, a point, an exponent.
std::size_t end_of_number(const std::string& text, std::size_t i) {
  while (i < text.size() && (is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))))
    ++i;
  std::size_t exponent = i;
  if (exponent < text.size() && text[exponent] == 'e') {
    ++exponent;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    if (exponent < text.size() && is_digit(text[exponent])) return end_of_number(text, exponent);
  }
  return i;
}

}  // namespace

void MapRule::set_case(const std::string& name) {
  in_case = name;
  words += case_words();
}

void MapRule::unset_case() {
  words.erase(words.size() - case_words().size());
  in_case.clear();
}

std::string MapRule::case_words() const { return in_case.empty() ? "" : " in case " + foundation::quoted(in_case); }

std::string without_numbers(const std::string& message) {
  std::string kind;
  for (std::size_t i = 0; i < message.size();) {
    const bool in_a_word = !kind.empty() && is_of_word(kind.back());
    const bool sign = message[i] == '-' && i + 1 < message.size() && is_digit(message[i + 1]);
    if (!in_a_word && (is_digit(message[i]) || sign)) {
      kind += '#';
      i = end_of_number(message, i + (sign ? 1 : 0));
    } else {
      kind += message[i++];
    }
  }
  return kind;
}

float rounded_margin(double margin) {
  const auto rounded = static_cast<float>(margin);
  const float kept = margin < 1 && rounded >= 1 ? std::nextafter(1.0F, 0.0F) : rounded;
  assert((kept >= 1) == (margin >= 1) && "rounding decides on no limit");
  return kept;
}

std::string EvaluationReport::summary() const {
  std::string text;
  if (proven + fallback > 0)
    text = fmt::format("{} designs by poles and residues{}; {}", proven + fallback,
                       fallback > 0 ? fmt::format(", {} of them recomputed by a slower solver", fallback) : "", family);
  if (assembled_separately > 0)
    text += fmt::format("{}{} designs assembled from the changed project and searched separately: {}",
                        text.empty() ? "" : "; ", assembled_separately,
                        family.empty() ? no_family : "not certain by poles and residues");
  for (const std::string& words : further) text += (text.empty() ? "" : "; ") + words;
  return text;
}

}  // namespace trivet::design
