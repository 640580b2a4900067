// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/parallel_for.h"
#include "trivet/study/shared/part_file.h"
#include "trivet/study/shared/periodic_writer.h"
#include "trivet/study/shared/study_folder.h"
#include "trivet/study/shared/study_manifest.h"

namespace trivet::study {

/// Items of work that any number of processes compute together, through a study folder. All of them run the same
/// program on the same input, so all come to the same loops over items: what one has computed, the others read, and
/// every one ends with the whole result. Why so: docs/decisions/study-folder.md.
class SharedWork {
 public:
  /// @param ends  true if waiting is to end; called on any thread; empty: never
  /// @throws foundation::InvalidInput for a folder of another study, and if another process has the part
  SharedWork(const std::filesystem::path& folder, const StudyPart& part, const StudyIdentity& identity,
             std::function<bool()> ends = {});
  /// Writes what is computed.
  ~SharedWork();
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  /// Called for each item that is read, also if the loop is interrupted later; on any thread, one at a time.
  using ItemRead = std::function<void(std::size_t item, const std::string& result)>;

  /// Results of the items 0 … count − 1 of a loop. Those that the folder has are read. Of the others a process computes
  /// its own ones (StudyPart::has) first, then those of others from their last. For the ones that a running process
  /// computes now it waits twice as long as its own longest item took, at least a second, then computes them too; an
  /// item that two compute is only computed twice. Not from several threads at once.
  /// @param compute  called on any thread
  /// @throws foundation::NotComputable if the file cannot be written, and what `compute` throws
  [[nodiscard]] std::vector<std::string> results(std::size_t count, const foundation::ParallelOptions& options,
                                                 const std::function<std::string(std::size_t item)>& compute,
                                                 const ItemRead& on_read = {});

  struct Counts {
    std::uint64_t read = 0;      ///< items of other processes, also of earlier ones
    std::uint64_t computed = 0;  ///< by this process
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
  [[nodiscard]] const StudyPart& part() const { return part_; }
  /// Names of files that could not be read.
  [[nodiscard]] std::vector<std::string> damaged() const { return {damaged_.begin(), damaged_.end()}; }
  /// False on a file system without locks.
  [[nodiscard]] bool is_locked() const { return own_.is_locked(); }

 private:
  using Items = std::map<std::size_t, std::string>;
  using Loops = std::map<std::string, Items>;
  class Loop;

  static std::string stored(const Loops& loops);
  static void restore(std::string_view words, Loops& loops);
  void restore_of(const StudyPart& part, const PartRecord& record, Loops& loops);
  [[nodiscard]] Loops own_results();
  /// Results of all other parts. @returns parts with a file that can be read
  [[nodiscard]] std::vector<StudyPart> read(Loops& others);
  void write();

  [[nodiscard]] bool ends() const { return writer_.is_to_end() || (ends_ && ends_()); }

  StudyFolder folder_;
  std::set<std::string> damaged_;
  StudyPart part_;
  std::function<bool()> ends_;
  StudyManifest manifest_;
  OwnPart own_;
  PartRecord record_;  ///< of the next file; used by `write`
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex holding_, writing_;
  Loops mine_;  ///< results of this part, also of its earlier processes
  std::size_t loops_ = 0;
  std::string state_;  ///< a hash of all loops before: only loops with the same beginning are the same
  Counts counts_;
  std::chrono::steady_clock::duration longest_{};  ///< item of this process
  bool is_new_ = false;                            ///< something is computed that the file does not have
  PeriodicWriter writer_;
};

}  // namespace trivet::study
