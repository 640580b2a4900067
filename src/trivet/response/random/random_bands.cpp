// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/random/random_bands.h"

#include <limits>

#include "trivet/foundation/constants.h"

namespace trivet::response {
namespace {

/// The inputs with density between two frequencies [rad/s], and the pairs among them.
RandomLoading loading_in_range(const RandomLoading& loading, double from, double to) {
  RandomLoading part;
  std::vector<std::optional<std::size_t>> place(loading.inputs.size());
  for (std::size_t i = 0; i < loading.inputs.size(); ++i) {
    excitation::Spectrum spectrum = excitation::in_range(loading.inputs[i].spectrum, from, to);
    if (spectrum.pieces.empty()) continue;
    place[i] = part.inputs.size();
    part.inputs.push_back({loading.inputs[i].name, loading.inputs[i].loading, std::move(spectrum)});
  }
  for (const excitation::InputPair& pair : loading.pairs)
    if (place[pair.first] && place[pair.second])
      part.pairs.push_back({*place[pair.first], *place[pair.second], pair.coherence, pair.delay});
  return part;
}

double level(const RandomChannel& channel) {
  if (channel.infinite_rms) return foundation::infinity;
  if (channel.vanishes) return 0;
  return channel.rms.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

RandomBands random_bands(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                         const RandomLoading& loading, const std::vector<excitation::FrequencyBand>& bands,
                         const RandomOptions& options, const foundation::Progress& progress) {
  RandomBands result{bands, std::vector(channels.size(), std::vector<double>(bands.size(), 0))};
  for (std::size_t b = 0; b < bands.size(); ++b) {
    foundation::report_progress(progress, "frequency bands",
                                static_cast<double>(b) / static_cast<double>(bands.size()));
    const RandomLoading inside = loading_in_range(loading, bands[b].from(), bands[b].to());
    if (inside.inputs.empty()) continue;
    const RandomResponse found = random_response(assembled, channels, inside, options);
    for (std::size_t c = 0; c < channels.size(); ++c) result.rms[c][b] = level(found.channels[c]);
  }
  return result;
}

}  // namespace trivet::response
