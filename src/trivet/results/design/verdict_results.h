// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::results {

/// A case: how many requirements are met, which one governs and why, and all of them; for people those that could not
/// be judged first, then by ascending margin. The summary is without the table.
[[nodiscard]] Document verdict_document(const study::CaseVerdict& judged);
/// Least and largest static values over all cases, "envelope.csv"; nothing for people if they do not differ.
[[nodiscard]] Document envelope_document(const study::Envelope& envelope);

/// All cases and the envelope; "verdict.csv" has one row per case and requirement.
[[nodiscard]] Document whole_verdict(const study::Verdict& verdict);

}  // namespace trivet::results
