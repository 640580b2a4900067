// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/labelled_arrays.h"
#include "trivet/results/format/in_documents.h"
