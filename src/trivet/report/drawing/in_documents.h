// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/results/format/in_documents.h"

/// The page writes its numbers and tables as the layer `documents`.
namespace trivet::report {
using namespace documents;
}
