// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/study/explain/stated_words.h"

namespace trivet::results {

/// Words of a study as a sentence for people.
[[nodiscard]] inline documents::Sentence shown_words(const study::StatedWords& words) {
  documents::Sentence sentence;
  for (const auto& part : words) {
    if (const auto* text = std::get_if<std::string>(&part)) {
      sentence.parts.emplace_back(*text);
      continue;
    }
    const auto& number = std::get<study::StatedNumber>(part);
    const bool frequency = number.kind == study::StatedNumber::Kind::frequency;
    sentence.parts.emplace_back(documents::Quantity{
        number.value, number.unit, frequency ? documents::Kind::frequency : documents::Kind::amplitude, 4});
  }
  return sentence;
}

}  // namespace trivet::results
