// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/shared_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/stored_words.h"
#include "trivet/project/text/source_file.h"
#include "trivet/study/shared/item_order.h"

namespace trivet::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_items = 100'000'000;
/// Files of others are read this often, and at most one twentieth of the time.
constexpr std::chrono::milliseconds least_between_reads(200);
constexpr int shares_of_reading = 20;
constexpr std::chrono::milliseconds most_between_files(500), between_waits(50), least_wait(1000);

StudyFolder folder_for(const std::filesystem::path& path, const StudyIdentity& identity, const StudyPart& part) {
  StudyFolder folder = StudyFolder::made(path);
  folder.check_identity(identity);
  folder.check_number_of_parts(part.of);
  return folder;
}

std::set<std::string> damaged_manifest(const StudyFolder& folder) {
  if (folder.has_manifest() && !folder.manifest()) return {manifest_file};
  return {};
}

StudyManifest manifest_in(const StudyFolder& folder, const StudyIdentity& identity) {
  StudyManifest manifest = folder.with_manifest({identity, ""});
  folder.check_identity(identity);  // another process may have begun at the same moment
  return manifest;
}

}  // namespace

/// The results of one loop. Its threads share it.
class SharedWork::Loop {
 public:
  Loop(SharedWork& work, std::string name, std::size_t count, const foundation::ParallelOptions& options,
       const ItemRead& on_read)
      : work_(work),
        name_(std::move(name)),
        options_(options),
        on_read_(on_read),
        in_hand_(to_size(foundation::thread_count(options.threads))),
        order_(count, work.part_),
        found_(count) {
    const std::lock_guard lock(work_.holding_);
    read();
  }

  /// The next item to compute; none: all have a result or are being computed here, or another thread stopped the loop.
  std::optional<std::size_t> next() {
    for (;;) {
      if (has_stopped_) return std::nullopt;
      bool own_are_taken = false;
      {
        const std::lock_guard lock(work_.holding_);
        if (Clock::now() >= read_again_) read();
        if (const auto item = untaken()) {
          order_.note_taken(*item);
          return item;
        }
        if (order_.is_over()) return std::nullopt;
        own_are_taken = !std::exchange(own_are_written_, true);
      }
      if (own_are_taken) work_.write();  // others may wait for these
      std::this_thread::sleep_for(between_waits);
      if (std::this_thread::get_id() == caller_) report();
    }
  }

  void compute(std::size_t item, const std::function<std::string(std::size_t item)>& compute) {
    const Clock::time_point begin = Clock::now();
    std::string result = compute(item);
    const std::lock_guard lock(work_.holding_);
    progressed_ = Clock::now();
    work_.longest_ = std::max(work_.longest_, progressed_ - begin);
    ++work_.counts_.computed;
    work_.is_new_ = true;
    work_.mine_[name_][item] = result;
    order_.note_found(item);
    found_[item] = std::move(result);
  }

  /// Ends the waiting of all threads.
  void stop() { has_stopped_ = true; }

  /// On the thread of the caller.
  void report() const {
    const auto count = static_cast<double>(found_.size());
    foundation::report_progress(options_.progress, options_.task, (count - static_cast<double>(missing())) / count);
  }

  [[nodiscard]] std::size_t missing() const {
    const std::lock_guard lock(work_.holding_);
    return order_.missing();
  }

  [[nodiscard]] std::vector<std::string> results() && { return std::move(found_); }

 private:
  [[nodiscard]] std::optional<std::size_t> untaken() {
    if (const auto own = order_.own()) return own;
    const Clock::time_point now = Clock::now();
    if (!own_taken_at_) own_taken_at_ = now;
    const bool is_new = now - *own_taken_at_ < most_between_files + least_between_reads;
    const bool waits = now - progressed_ < std::max<Clock::duration>(least_wait, 2 * work_.longest_) && !work_.ends();
    for (std::uint64_t turn = 1; turn < work_.part_.of; ++turn) {
      const std::uint64_t owner = (work_.part_.number - 1 + turn) % work_.part_.of + 1;
      const bool is_running = running_.contains(owner);
      if (is_new && (is_running || !running_are_known_)) continue;  // what it has done may not be seen here
      if (const auto item = order_.of(owner, waits && is_running ? in_hand_ : 0)) return item;
    }
    return std::nullopt;
  }

  void read() {
    const Clock::time_point begin = Clock::now();
    Loops others;
    const std::vector<StudyPart> parts = work_.read(others);
    for (const Loops* loops : {&std::as_const(work_.mine_), &std::as_const(others)})
      if (const auto known = loops->find(name_); known != loops->end())
        for (const auto& [item, result] : known->second) {
          if (item >= found_.size() || order_.is_found(item)) continue;
          if (!order_.is_taken(item)) ++work_.counts_.read;
          order_.note_found(item);
          found_[item] = result;
          progressed_ = Clock::now();
          if (on_read_) on_read_(item, result);
        }
    if (own_taken_at_) find_running(parts);
    const Clock::time_point end = Clock::now();
    read_again_ = end + std::max<Clock::duration>(least_between_reads, shares_of_reading * (end - begin));
  }

  void find_running(const std::vector<StudyPart>& parts) {
    running_.clear();
    for (const StudyPart& part : parts)
      if (part.of == work_.part_.of && part != work_.part_ && is_worked_on(work_.folder_.handle(), part))
        running_.insert(part.number);
    running_are_known_ = true;
  }

  SharedWork& work_;
  std::string name_;
  foundation::ParallelOptions options_;
  const ItemRead& on_read_;
  std::size_t in_hand_;  ///< that a process may have at once, if its machine is as this one
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> has_stopped_ = false;
  ItemOrder order_;
  std::vector<std::string> found_;
  std::set<std::uint64_t> running_;  ///< parts of other processes, looked for once the own items are taken
  bool running_are_known_ = false;
  Clock::time_point read_again_, progressed_ = Clock::now();
  std::optional<Clock::time_point> own_taken_at_;
  bool own_are_written_ = false;
};

SharedWork::SharedWork(const std::filesystem::path& folder, const StudyPart& part, const StudyIdentity& identity,
                       std::function<bool()> ends)
    : folder_(folder_for(folder, identity, part)),
      damaged_(damaged_manifest(folder_)),
      part_(part),
      ends_(std::move(ends)),
      manifest_(manifest_in(folder_, identity)),
      own_(folder_.handle(), part_, folder_.path()),
      record_{.study = manifest_.hash(), .chunks = ChunkSet(0)},
      mine_(own_results()),
      writer_([this] { write(); }, {}, most_between_files) {}

SharedWork::~SharedWork() {
  try {
    writer_.stop();
    record_.has_ended = true;
    write();
  } catch (...) {  // reported before, where results were computed
  }
}

std::vector<std::string> SharedWork::results(std::size_t count, const foundation::ParallelOptions& options,
                                             const std::function<std::string(std::size_t item)>& compute,
                                             const ItemRead& on_read) {
  const std::string name = fmt::format("{} {} of {} after {}", ++loops_, options.task, count, state_);
  Loop loop(*this, name, count, options, on_read);
  const auto or_stop = [&loop](const auto& work) {
    try {
      work();
    } catch (...) {
      loop.stop();
      throw;
    }
  };
  foundation::ParallelOptions guarded = options;
  guarded.size = 1;
  guarded.progress = [&](std::string_view, double) { or_stop([&] { loop.report(); }); };
  try {
    foundation::parallel_for(loop.missing(), guarded, [&](std::size_t, std::size_t) {
      or_stop([&] {
        if (writer_.is_to_end()) throw foundation::Interrupted();
        if (const auto item = loop.next()) loop.compute(*item, compute);
      });
    });
  } catch (...) {
    if (writer_.is_to_end()) writer_.stop();  // throws why
    try {
      write();
    } catch (const foundation::NotComputable&) {  // the first reason counts
    }
    throw;
  }
  if (writer_.is_to_end()) writer_.stop();
  write();
  std::vector<std::string> all = std::move(loop).results();
  std::string text = name;
  for (const std::string& one : all) text += "\n" + one;
  state_ = project::sha256(text).substr(0, 16);
  return all;
}

std::string SharedWork::stored(const Loops& loops) {
  foundation::StoredWords words;
  words.whole(loops.size());
  for (const auto& [name, items] : loops) {
    words.text(name);
    words.whole(items.size());
    words.end_line();
    for (const auto& [item, result] : items) {
      words.whole(item);
      words.text(result);
      words.end_line();
    }
  }
  return words.words();
}

void SharedWork::restore(std::string_view stored, Loops& loops) {
  foundation::WordReader words(stored);
  for (std::uint64_t left = words.at_most(most_items); left > 0; --left) {
    Items& items = loops[words.text()];
    for (std::uint64_t more = words.at_most(most_items); more > 0; --more) {
      const std::uint64_t item = words.whole();
      items[item] = words.text();
    }
  }
  words.end();
}

SharedWork::Loops SharedWork::own_results() {
  Loops loops;
  const StudyFolder::Content content = folder_.content(manifest_, 0);
  for (const std::string& name : content.damaged)
    if (name == part_.file_name()) damaged_.insert(name);
  for (const auto& [part, record] : content.parts)
    if (part == part_) restore_of(part, record, loops);
  return loops;
}

void SharedWork::restore_of(const StudyPart& part, const PartRecord& record, Loops& loops) {
  try {
    restore(record.results, loops);
  } catch (const foundation::DamagedText&) {
    damaged_.insert(part.file_name());
  }
}

std::vector<StudyPart> SharedWork::read(Loops& others) {
  std::vector<StudyPart> parts;
  const StudyFolder::Content content = folder_.content(manifest_, 0);
  for (const auto& [part, record] : content.parts) {
    parts.push_back(part);
    if (part == part_) continue;
    damaged_.erase(part.file_name());  // it was unreadable only while it was replaced
    restore_of(part, record, others);
  }
  for (const std::string& name : content.damaged)
    if (name != part_.file_name()) damaged_.insert(name);
  return parts;
}

void SharedWork::write() {
  const std::lock_guard writing(writing_);
  {
    const std::lock_guard lock(holding_);
    if (mine_.empty() || (!is_new_ && !record_.has_ended)) return;
    record_.results = stored(mine_);
    record_.computed = counts_.computed;
    is_new_ = false;
  }
  record_.stamp(start_);
  try {
    own_.replace(record_.text());
  } catch (...) {
    const std::lock_guard lock(holding_);
    is_new_ = true;
    throw;
  }
  record_.results.clear();
}

}  // namespace trivet::study
