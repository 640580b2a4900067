// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::exports {

/// Version of the Functional Mock-up Interface.
enum class FmiVersion { two, three };

}  // namespace trivet::exports
