// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// "1.2.3", as in CMakeLists.txt.
[[nodiscard]] const char* version();

}  // namespace trivet::foundation
