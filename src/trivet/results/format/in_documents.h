// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Results are written in the words of the layer `documents`.
namespace trivet::documents::json {}
namespace trivet::results {
using namespace documents;
namespace json {
using namespace documents::json;
}
}  // namespace trivet::results
