// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/study/sample/sample_manifest.h"
#include "trivet/study/sample/sample_result.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/sample_shares.h"
#include "trivet/study/sample/stored_tally.h"
#include "trivet/study/shared/periodic_writer.h"
#include "trivet/study/shared/study_folder.h"

namespace trivet::study {
namespace {

using foundation::Interrupted;
using foundation::Progress;

constexpr std::chrono::milliseconds most_between_files(2000);

/// What one process counts in its chunks. A thread of its own writes it to the file every few seconds, and at once when
/// the process is to end.
class CountedPart {
 public:
  CountedPart(const SampleRun& run, const FixedBySample& fixed, const std::string& study, const StudyRequest& request,
              OwnPart& own)
      : run_(run),
        fixed_(fixed),
        request_(request),
        own_(own),
        tally_(run.empty_tally(fixed.magnitudes)),
        record_{.study = study, .chunks = ChunkSet(fixed.chunks.count())} {}

  /// Begins with what an earlier process has counted.
  void begin_with(const PartRecord& earlier) {
    record_.chunks = earlier.chunks;
    foundation::WordReader words(earlier.results);
    restore_tally(words, tally_);
  }

  /// Computes chunks until `request.ends`. @returns how many
  std::uint64_t count(const std::vector<std::uint64_t>& chunks, const Progress& progress) {
    std::exception_ptr from_caller;
    PeriodicWriter writer([this] { write(); }, request_.ends, most_between_files);
    try {
      foundation::parallel_for(chunks.size(), {.size = 1, .progress = progress, .task = "designs"},
                               [&](std::size_t from, std::size_t to) {
                                 for (; from < to; ++from) count_chunk(chunks[from], writer);
                               });
    } catch (const Interrupted&) {
      if (!writer.is_to_end()) from_caller = std::current_exception();
    } catch (...) {
      from_caller = std::current_exception();
    }
    writer.stop();
    record_.has_ended = true;
    write();
    if (from_caller) std::rethrow_exception(from_caller);
    return computed_;
  }

 private:
  void count_chunk(std::uint64_t chunk, const PeriodicWriter& writer) {
    const auto interruption = [&writer](std::string_view, double) {
      if (writer.is_to_end()) throw Interrupted();
    };
    interruption("", 0);
    SampleTally counted = run_.empty_tally(fixed_.magnitudes);
    run_.count(fixed_.chunks.first(chunk), fixed_.chunks.designs_of(chunk), counted, interruption);
    const std::lock_guard lock(counting_);
    tally_.merge(counted);
    record_.chunks.add(chunk);
    record_.computed += fixed_.chunks.designs_of(chunk);
    ++computed_;
  }

  void write() {
    std::string text;
    {
      const std::lock_guard lock(counting_);
      foundation::StoredWords words;
      store_tally(tally_, words);
      record_.results = words.words();
      record_.stamp(start_);
      text = record_.text();
    }
    own_.replace(text);
  }

  const SampleRun& run_;
  const FixedBySample& fixed_;
  const StudyRequest& request_;
  OwnPart& own_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex counting_;
  SampleTally tally_;
  PartRecord record_;
  std::uint64_t computed_ = 0;
};

StudyManifest manifest_of(const StudyFolder& folder, const SampleRun& run, const StudyIdentity& identity,
                          const Progress& progress) {
  if (auto there = folder.manifest()) return *there;
  const FixedBySample fixed{study_chunks(run.request().designs, run.piece()), run.first_designs(progress).magnitudes};
  StudyManifest there = folder.with_manifest({identity, fixed.text()});
  folder.check_identity(identity);
  return there;
}

/// @throws foundation::NotComputable if it is of another format
FixedBySample fixed_by(const StudyFolder& folder, const StudyManifest& manifest) {
  if (auto fixed = FixedBySample::read(manifest.fixed)) return *std::move(fixed);
  throw foundation::NotComputable(fmt::format(
      "study folder {}: the chunks of study.txt cannot be read; name another folder", folder.path().string()));
}

SampleTally tally_of(const SampleRun& run, const SampleMagnitudes& magnitudes, const StudyFolder::Content& content) {
  SampleTally all = run.empty_tally(magnitudes);
  for (const auto& [part, record] : content.parts) {
    SampleTally one = run.empty_tally(magnitudes);
    foundation::WordReader words(record.results);
    restore_tally(words, one);
    all.merge(one);
  }
  return all;
}

/// The result of all chunks in the folder.
Sample result_of(const SampleRun& run, const SampleMagnitudes& magnitudes, const StudyFolder::Content& content,
                 const std::filesystem::path& folder) {
  const SampleTally all = tally_of(run, magnitudes, content);
  std::uint64_t designs = 0;
  for (const std::uint64_t one : all.designs) designs += one;
  if (designs == 0)
    throw foundation::NotComputable(fmt::format(
        "study folder {}: no chunk of designs is complete yet, so there is no result; the same command goes on",
        folder.string()));
  Sample found = sample_result(run, all);
  found.request.designs = designs;
  return found;
}

Progress with_interruption(const Progress& progress, const std::function<bool()>& ends) {
  return [&progress, &ends](std::string_view task, double fraction) {
    if (ends && ends()) throw Interrupted();
    foundation::report_progress(progress, task, fraction);
  };
}

}  // namespace

Sample sample_in_folder(const project::Project& project, const StudyRequest& request, const Progress& progress) {
  const StudyFolder folder = StudyFolder::made(request.folder);
  const StudyIdentity identity = sample_identity(project);
  const bool was_damaged = folder.has_manifest() && !folder.manifest();
  folder.check_identity(identity);
  folder.check_number_of_parts(request.part.of);
  OwnPart own(folder.handle(), request.part, folder.path());
  const SampleRun run(project);
  const StudyManifest manifest = manifest_of(folder, run, identity, progress);
  const FixedBySample fixed = fixed_by(folder, manifest);
  const StudyFolder::Content before = folder.content(manifest, fixed.chunks.count());
  StudyProgress study{.folder = request.folder,
                      .part = request.part.number,
                      .of = request.part.of,
                      .designs = run.request().designs,
                      .chunks = fixed.chunks.count(),
                      .found = before.chunks.size(),
                      .damaged = before.damaged,
                      .is_locked = own.is_locked()};
  if (was_damaged) study.damaged.emplace_back(manifest_file);

  CountedPart counted(run, fixed, manifest.hash(), request, own);
  for (const auto& [part, record] : before.parts)
    if (part == request.part) counted.begin_with(record);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t chunk = 0; chunk < study.chunks; ++chunk)
    if (request.part.has(chunk) && !before.chunks.holds(chunk)) missing.push_back(chunk);
  if (!missing.empty()) study.computed = counted.count(missing, progress);
  study.ended_early = study.computed < missing.size();

  const StudyFolder::Content after = folder.content(manifest, fixed.chunks.count());
  study.done = after.chunks.size();
  study.overlapping = after.overlapping;
  Sample found = result_of(run, fixed.magnitudes, after, folder.path());
  try {
    const Progress interruptible = with_interruption(progress, request.ends);
    if (run.request().worst_case && study.is_complete()) add_worst_designs(run, found, interruptible);
    if (request.shares && study.is_complete())
      found.shares = variance_shares(run.cases(), run.tolerances(), run.request(), interruptible);
  } catch (const Interrupted&) {
    if (!request.ends || !request.ends()) throw;
    study.ended_early = true;
  }
  found.study = std::move(study);
  return found;
}

}  // namespace trivet::study
