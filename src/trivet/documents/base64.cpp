// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/base64.h"

#include <algorithm>

namespace trivet::documents {

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8U | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? characters[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace trivet::documents
