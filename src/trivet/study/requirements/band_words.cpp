// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/band_words.h"

#include "trivet/foundation/hertz.h"

namespace trivet::study {

std::string hertz_words(const assembly::Band& band) {
  return band.from == band.to ? foundation::hertz_words(band.from, 5) : foundation::hertz_range(band.from, band.to, 5);
}

}  // namespace trivet::study
