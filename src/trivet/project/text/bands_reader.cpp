// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/bands_reader.h"

#include "trivet/project/text/units.h"

namespace trivet::project {

std::optional<excitation::BandWidth> read_bands(TableReader& reader, const std::string& key) {
  using excitation::BandWidth;
  const auto word = reader.choice(key, {name(BandWidth::third_octave), name(BandWidth::octave)});
  if (!word) return std::nullopt;
  return *word == name(BandWidth::octave) ? BandWidth::octave : BandWidth::third_octave;
}

tl::expected<double, std::string> to_rms(const std::string& text, Quantity quantity) {
  const auto without = [&text](const std::string& word) -> std::optional<std::string> {
    if (!text.ends_with(" " + word)) return std::nullopt;
    return text.substr(0, text.size() - word.size() - 1);
  };
  for (const char* peak : {"0-p", "p-p"})
    if (without(peak))
      return tl::unexpected("the level of a band is a root mean square, which \"" + std::string(peak) + "\" is not");
  return to_si(without("rms").value_or(text), quantity);
}

}  // namespace trivet::project
