// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/band_words.h"

#include <fmt/format.h>

#include "trivet/foundation/constants.h"

namespace trivet::study {

std::string hertz_words(const assembly::Band& band) {
  const double from = band.from / foundation::two_pi, to = band.to / foundation::two_pi;
  return band.from == band.to ? fmt::format("{:.5g} Hz", from) : fmt::format("{:.5g} … {:.5g} Hz", from, to);
}

}  // namespace trivet::study
