// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// "0.1.0".
[[nodiscard]] const char* version();

}  // namespace trivet::foundation
