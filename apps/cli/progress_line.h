// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/engine/program.h"

namespace trivet::cli {

/// Shows the task, its share and, after two seconds, the time left on one line of a terminal, ten times a second at
/// most. If standard error is no terminal: a line every half a minute.
[[nodiscard]] foundation::Progress progress();

}  // namespace trivet::cli
