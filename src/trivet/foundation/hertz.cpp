// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/hertz.h"

#include "trivet/foundation/significant_digits.h"

namespace trivet::foundation {

std::string hertz_words(double omega, int digits) { return significant(hertz(omega), digits) + " Hz"; }

std::string hertz_range(double from, double to, int digits) {
  return significant(hertz(from), digits) + " … " + hertz_words(to, digits);
}

}  // namespace trivet::foundation
