// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/project/analyses/request_readers.h"

namespace trivet::project {

std::vector<double> read_single_frequencies(TableReader& reader) {
  constexpr std::size_t most_frequencies = 1000;
  if (!reader.has("at")) return {};
  std::vector<double> at = reader.numbers("at", Quantity::angular_frequency).value_or(std::vector<double>{});
  if (at.empty()) reader.error("at", "no frequency", "at least one is expected", "for instance at = [\"980 rpm\"]");
  if (at.size() > most_frequencies)
    reader.error("at", fmt::format("{} frequencies", at.size()),
                 fmt::format("at most {} are told in single rows", most_frequencies), "name fewer frequencies");
  for (std::size_t i = 0; i < at.size(); ++i)
    if (!(at[i] > 0))
      reader.error("at", value_text(*reader.node("at"), i), "a frequency or speed is > 0", "correct it");
  return at;
}

}  // namespace trivet::project
