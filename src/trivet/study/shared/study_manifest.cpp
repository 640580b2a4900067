// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/study_manifest.h"

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

constexpr std::string_view manifest_heading = "Trivet study, format 2\n";
constexpr std::string_view hash_mark = "sha256: ";
constexpr const char* command_key = "command";
constexpr std::uint64_t most_entries = 100'000;

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
  StudyIdentity identity(words.at_most(most_entries));
  for (auto& [key, value] : identity) {
    key = words.text();
    value = words.text();
  }
  return identity;
}

}  // namespace

StudyIdentity study_identity(const std::string& command, const project::Project& project) {
  std::string settings;
  for (const std::string& one : project.settings)
    settings += (settings.empty() ? "" : ", ") + foundation::on_one_line(one);
  StudyIdentity identity = {{command_key, command},
                            {"version", foundation::version()},
                            {"case", project.base().name},
                            {"settings", settings},
                            {"project file", project.parsed ? project::sha256(project.parsed->text) : project.sha256}};
  for (const project::InputFile& file : project::input_files(project))
    identity.emplace_back("file " + foundation::quoted(file.name), file.sha256);
  return identity;
}

std::string identity_differences(const StudyIdentity& there, const StudyIdentity& here) {
  const std::string *command = found_in(there, command_key), *own_command = found_in(here, command_key);
  if (command && own_command && *command != *own_command)
    return fmt::format("it is of trivet {}, not of trivet {}", *command, *own_command);
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
  words += "\nThe same for programs:\n";
  foundation::StoredWords stored;
  stored.whole(identity.size());
  for (const auto& [key, value] : identity) {
    stored.text(key);
    stored.text(value);
  }
  stored.end_line();
  stored.text(fixed);
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
    found.fixed = words.text();
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
