// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/bands_reader.h"

namespace trivet::project {

std::optional<excitation::BandWidth> read_bands(TableReader& reader, const std::string& key) {
  using excitation::BandWidth;
  const auto word = reader.choice(key, {name(BandWidth::third_octave), name(BandWidth::octave)});
  if (!word) return std::nullopt;
  return *word == name(BandWidth::octave) ? BandWidth::octave : BandWidth::third_octave;
}

}  // namespace trivet::project
