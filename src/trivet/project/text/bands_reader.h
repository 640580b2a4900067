// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// `key = "third-octave"` or "octave", if it is there.
[[nodiscard]] std::optional<excitation::BandWidth> read_bands(TableReader& reader, const std::string& key);

/// A text with a level in this quantity, "2.1 µm/s" or "2.1 µm/s rms", in SI, or the reason why it has none: levels of
/// bands are root mean squares, so "0-p" and "p-p" are refused.
[[nodiscard]] tl::expected<double, std::string> to_rms(const std::string& text, Quantity quantity);

}  // namespace trivet::project
