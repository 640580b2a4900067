// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/sample/study_status.h"

namespace trivet::results {

/// How far the processes of a study folder are; "status.csv" has one row per part.
[[nodiscard]] Document study_status_document(const study::StudyStatus& status);

}  // namespace trivet::results
