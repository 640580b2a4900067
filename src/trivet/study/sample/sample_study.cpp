// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/study/sample/sample_result.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/sample_shares.h"
#include "trivet/study/sample/stored_tally.h"
#include "trivet/study/sample/study_folder.h"

namespace trivet::study {
namespace {

using Clock = std::chrono::steady_clock;
using foundation::Interrupted;
using foundation::Progress;

constexpr std::chrono::milliseconds between_looks(50);
constexpr std::chrono::milliseconds most_between_files(2000);  // soon after the begin less

std::uint64_t milliseconds_since(Clock::time_point start) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start).count());
}

std::uint64_t seconds_since_1970() {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count());
}

/// What one process counts in its chunks. A thread of its own writes it to the file every few seconds, and at once when
/// the process is to end.
class CountedPart {
 public:
  CountedPart(const SampleRun& run, const StudyManifest& manifest, const StudyRequest& request, OwnPart& own)
      : run_(run),
        manifest_(manifest),
        request_(request),
        own_(own),
        tally_(run.empty_tally(manifest.magnitudes)),
        record_{.study = manifest.hash(), .chunks = ChunkSet(manifest.chunks.count())} {}

  /// Begins with what an earlier process has counted.
  void begin_with(const PartRecord& earlier) {
    record_.chunks = earlier.chunks;
    foundation::WordReader words(earlier.counts);
    restore_tally(words, tally_);
  }

  /// Computes chunks until `request.ends`. @returns how many
  std::uint64_t count(const std::vector<std::uint64_t>& chunks, const Progress& progress) {
    {
      const std::jthread writer([this](const std::stop_token& over) { keep_file(over); });
      try {
        foundation::parallel_for(chunks.size(), {.size = 1, .progress = progress, .task = "designs"},
                                 [&](std::size_t from, std::size_t to) {
                                   for (; from < to; ++from) count_chunk(chunks[from]);
                                 });
      } catch (const Interrupted&) {
        if (!is_to_end_) from_caller_ = std::current_exception();
      }
    }
    if (failure_) std::rethrow_exception(failure_);
    record_.has_ended = true;
    write();
    if (from_caller_) std::rethrow_exception(from_caller_);
    return computed_;
  }

 private:
  void count_chunk(std::uint64_t chunk) {
    const auto interruption = [this](std::string_view, double) {
      if (is_to_end_) throw Interrupted();
    };
    interruption("", 0);
    SampleTally counted = run_.empty_tally(manifest_.magnitudes);
    run_.count(manifest_.chunks.first(chunk), manifest_.chunks.designs_of(chunk), counted, interruption);
    const std::lock_guard lock(counting_);
    tally_.merge(counted);
    record_.chunks.add(chunk);
    record_.designs += manifest_.chunks.designs_of(chunk);
    ++computed_;
  }

  void keep_file(const std::stop_token& over) {
    Clock::time_point written = Clock::now();
    std::chrono::milliseconds between_files = between_looks;
    std::mutex waiting;
    std::unique_lock lock(waiting);
    std::condition_variable_any wake;
    try {
      while (!over.stop_requested() && !is_to_end_) {
        wake.wait_for(lock, over, between_looks, [] { return false; });
        is_to_end_ = request_.ends && request_.ends();
        if (!is_to_end_ && Clock::now() - written < between_files) continue;
        write();
        written = Clock::now();
        between_files = std::min(2 * between_files, most_between_files);
      }
    } catch (...) {
      failure_ = std::current_exception();
      is_to_end_ = true;
    }
  }

  void write() {
    std::string text;
    {
      const std::lock_guard lock(counting_);
      foundation::StoredWords words;
      store_tally(tally_, words);
      record_.counts = words.words();
      record_.written_at = seconds_since_1970();
      record_.milliseconds = milliseconds_since(start_);
      text = record_.text();
    }
    own_.replace(text);
  }

  const SampleRun& run_;
  const StudyManifest& manifest_;
  const StudyRequest& request_;
  OwnPart& own_;
  const Clock::time_point start_ = Clock::now();
  std::mutex counting_;
  SampleTally tally_;
  PartRecord record_;
  std::uint64_t computed_ = 0;
  std::atomic<bool> is_to_end_ = false;
  std::exception_ptr failure_, from_caller_;
};

/// @throws foundation::InvalidInput if the folder is of another study
void check_identity(const StudyFolder& folder, const StudyManifest& manifest, const StudyIdentity& identity) {
  const std::string differences = identity_differences(manifest.identity, identity);
  if (!differences.empty())
    throw foundation::InvalidInput(fmt::format("study folder {} is of another study: {}; name another folder",
                                               folder.path().string(), differences));
}

StudyManifest manifest_of(const StudyFolder& folder, const SampleRun& run, const StudyIdentity& identity,
                          const Progress& progress) {
  if (auto there = folder.manifest()) return *there;
  const StudyManifest made{identity, study_chunks(run.request().designs, run.piece()),
                           run.first_designs(progress).magnitudes};
  StudyManifest there = folder.with_manifest(made);
  check_identity(folder, there, identity);
  return there;
}

SampleTally tally_of(const SampleRun& run, const StudyManifest& manifest, const StudyFolder::Content& content) {
  SampleTally all = run.empty_tally(manifest.magnitudes);
  for (const auto& [part, record] : content.parts) {
    SampleTally one = run.empty_tally(manifest.magnitudes);
    foundation::WordReader words(record.counts);
    restore_tally(words, one);
    all.merge(one);
  }
  return all;
}

/// The result of all chunks in the folder.
Sample result_of(const SampleRun& run, const StudyManifest& manifest, const StudyFolder::Content& content,
                 const std::filesystem::path& folder) {
  const SampleTally all = tally_of(run, manifest, content);
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
  const StudyIdentity identity = study_identity(project);
  const bool was_damaged = folder.has_manifest() && !folder.manifest();
  if (const auto there = folder.manifest()) check_identity(folder, *there, identity);
  folder.check_number_of_parts(request.part.of);
  OwnPart own(folder.handle(), request.part, folder.path());
  const SampleRun run(project);
  const StudyManifest manifest = manifest_of(folder, run, identity, progress);
  const StudyFolder::Content before = folder.content(manifest);
  StudyProgress study{.folder = request.folder,
                      .part = request.part.number,
                      .of = request.part.of,
                      .designs = run.request().designs,
                      .chunks = manifest.chunks.count(),
                      .found = before.chunks.size(),
                      .damaged = before.damaged,
                      .is_locked = own.is_locked()};
  if (was_damaged) study.damaged.emplace_back("study.txt");

  CountedPart counted(run, manifest, request, own);
  for (const auto& [part, record] : before.parts)
    if (part == request.part) counted.begin_with(record);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t chunk = 0; chunk < study.chunks; ++chunk)
    if (request.part.has(chunk) && !before.chunks.holds(chunk)) missing.push_back(chunk);
  if (!missing.empty()) study.computed = counted.count(missing, progress);
  study.ended_early = study.computed < missing.size();

  const StudyFolder::Content after = folder.content(manifest);
  study.done = after.chunks.size();
  study.overlapping = after.overlapping;
  Sample found = result_of(run, manifest, after, folder.path());
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
