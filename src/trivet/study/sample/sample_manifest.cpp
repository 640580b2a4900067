// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_manifest.h"

#include "trivet/foundation/stored_words.h"

namespace trivet::study {
namespace {

constexpr std::uint64_t most_cases = 10'000, most_requirements = 100'000;

SampleMagnitudes read_magnitudes(foundation::WordReader& words) {
  SampleMagnitudes magnitudes(words.at_most(most_cases));
  for (std::vector<SumMagnitudes>& of_case : magnitudes) {
    of_case.resize(words.at_most(most_requirements));
    for (SumMagnitudes& one : of_case) {
      one.value = words.exact();
      one.square = words.exact();
    }
  }
  return magnitudes;
}

}  // namespace

StudyIdentity sample_identity(const project::Project& project) {
  const project::SampleRequest request = project.base().analyses.sample.value_or(project::SampleRequest());
  StudyIdentity identity = study_identity(sample_command_name, project);
  identity.insert(identity.begin() + 2,
                  {{"number of designs", std::to_string(request.designs)},
                   {"sampling", request.sobol ? "sobol" : "random"},
                   {"seed", std::to_string(request.seed)}});
  return identity;
}

std::string FixedBySample::text() const {
  foundation::StoredWords stored;
  stored.whole(chunks.designs);
  stored.whole(chunks.size);
  stored.whole(magnitudes.size());
  for (const std::vector<SumMagnitudes>& of_case : magnitudes) {
    stored.whole(of_case.size());
    for (const SumMagnitudes& one : of_case) {
      stored.exact(one.value);
      stored.exact(one.square);
    }
  }
  return stored.words();
}

std::optional<FixedBySample> FixedBySample::read(const std::string& text) {
  try {
    foundation::WordReader words(text);
    FixedBySample found;
    found.chunks.designs = words.whole();
    found.chunks.size = words.whole();
    if (found.chunks.size == 0 || found.chunks.count() > most_chunks) return std::nullopt;
    found.magnitudes = read_magnitudes(words);
    words.end();
    return found;
  } catch (const foundation::DamagedText&) {
    return std::nullopt;
  }
}

}  // namespace trivet::study
