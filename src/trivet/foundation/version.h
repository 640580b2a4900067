// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::study {

/// "0.1.0".
[[nodiscard]] const char* version();

}  // namespace trivet::study
