// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/study_manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/foundation/version.h"
#include "trivet/project/input_files.h"
#include "trivet/project/text/source_file.h"

namespace trivet::study {
namespace {

constexpr std::string_view manifest_heading = "Trivet study of designs within tolerances, format 1\n";
constexpr std::string_view hash_mark = "sha256: ";
constexpr std::uint64_t most_cases = 10'000, most_requirements = 100'000;

const std::string* found_in(const StudyIdentity& identity, const std::string& key) {
  const auto at = std::ranges::find(identity, key, &StudyIdentity::value_type::first);
  return at == identity.end() ? nullptr : &at->second;
}

bool is_hash(const std::string& words) {
  return words.size() == 64 && words.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string shown(const std::string* words) {
  return !words ? "not given" : words->empty() ? "none" : foundation::shortened(*words);
}

StudyIdentity read_identity(foundation::WordReader& words) {
  StudyIdentity identity(words.at_most(most_requirements));
  for (auto& [key, value] : identity) {
    key = words.text();
    value = words.text();
  }
  return identity;
}

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

StudyIdentity study_identity(const project::Project& project) {
  const project::SampleRequest request = project.base().analyses.sample.value_or(project::SampleRequest());
  std::string settings;
  for (const std::string& one : project.settings)
    settings += (settings.empty() ? "" : ", ") + foundation::on_one_line(one);
  StudyIdentity identity = {{"version", foundation::version()},
                            {"number of designs", std::to_string(request.designs)},
                            {"sampling", request.sobol ? "sobol" : "random"},
                            {"seed", std::to_string(request.seed)},
                            {"case", project.base().name},
                            {"settings", settings},
                            {"project file", project.parsed ? project::sha256(project.parsed->text) : project.sha256}};
  for (const project::InputFile& file : project::input_files(project))
    identity.emplace_back("file " + foundation::quoted(file.name), file.sha256);
  return identity;
}

std::string identity_differences(const StudyIdentity& there, const StudyIdentity& here) {
  std::string words;
  const auto add = [&](const std::string& key, const std::string* one, const std::string* other) {
    const bool hashes = one && other && is_hash(*one) && is_hash(*other);
    words += (words.empty() ? "" : "; ") +
        (hashes ? fmt::format("the {} has another content there", key)
                : fmt::format("{}: {} there, {} here", key, shown(one), shown(other)));
  };
  for (const auto& [key, value] : there)
    if (const std::string* own = found_in(here, key); !own || *own != value) add(key, &value, own);
  for (const auto& [key, value] : here)
    if (!found_in(there, key)) add(key, nullptr, &value);
  return words;
}

std::string StudyManifest::text() const {
  std::string words;
  for (const auto& [key, value] : identity) words += fmt::format("{}: {}\n", key, value);
  words +=
      fmt::format("designs in a chunk: {}\n\nThe same for programs, with the magnitudes of the sums:\n", chunks.size);
  foundation::StoredWords stored;
  stored.whole(identity.size());
  for (const auto& [key, value] : identity) {
    stored.text(key);
    stored.text(value);
  }
  stored.end_line();
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
  stored.end_line();
  foundation::StoredWords lengths;
  lengths.text(words);
  return with_hash_line(std::string(manifest_heading) + lengths.words() + stored.words());
}

std::optional<StudyManifest> StudyManifest::read(const std::string& text) {
  const auto all = without_hash_line(text);
  if (!all || !all->starts_with(manifest_heading)) return std::nullopt;
  try {
    foundation::WordReader words(std::string_view(*all).substr(manifest_heading.size()));
    static_cast<void>(words.text());
    StudyManifest found;
    found.identity = read_identity(words);
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

std::string StudyManifest::hash() const { return project::sha256(text()); }

std::string with_hash_line(const std::string& text) {
  return text + std::string(hash_mark) + project::sha256(text) + "\n";
}

std::optional<std::string> without_hash_line(const std::string& text) {
  const std::size_t mark = text.rfind(hash_mark);
  if (mark == std::string::npos) return std::nullopt;
  std::string before = text.substr(0, mark);
  if (with_hash_line(before) != text) return std::nullopt;
  return before;
}

}  // namespace trivet::study
