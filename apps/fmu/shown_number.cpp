// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/shown_number.h"

#include <array>
#include <cstdio>
#include <string>

namespace trivet::fmu {

std::string shown(double number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.12g", number);
  return text.data();
}

}  // namespace trivet::fmu
