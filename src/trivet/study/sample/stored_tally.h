// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/stored_words.h"
#include "trivet/study/sample/sample_tally.h"

namespace trivet::study {

void store_tally(const SampleTally& tally, foundation::StoredWords& words);

/// Sets a tally of the same cases and requirements to the one stored. @throws foundation::DamagedText
void restore_tally(foundation::WordReader& words, SampleTally& tally);

}  // namespace trivet::study
