// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "trivet/engine/command.h"
#include "trivet/engine/process_rank.h"
#include "trivet/study/shared/shared_work.h"

namespace trivet::engine {

// Commands that many processes share: `-o STUDY` and `--part K/N`.

/// @param files  endings of files that the command writes instead
[[nodiscard]] Key study_key(const std::string& about, const std::string& files = ".json, .csv, .html or .txt");
[[nodiscard]] Key part_key();

/// The folder that the key `output` names. @throws foundation::InvalidInput for a new one with the ending of a file,
/// and for a part without a folder
[[nodiscard]] std::optional<std::filesystem::path> study_folder(const Task& task);

/// The part of this process, by the key `part` or its rank. @throws foundation::InvalidInput
[[nodiscard]] RankedPart part_of(const Task& task);

/// The command that does the rest of this one.
[[nodiscard]] std::string same_command(const Task& task);

/// Writes JSON and tables into the folder: every process that ends with the whole result writes the same bytes.
void write_result_files(const std::filesystem::path& folder, const Result& result);

/// The remark that a file system has no locks.
[[nodiscard]] std::string without_locks(const std::filesystem::path& folder);

/// "2 files (part-1-of-3, part-2-of-3)"
[[nodiscard]] std::string files_words(const std::vector<std::string>& names);
/// The remark that files were damaged.
[[nodiscard]] std::string damaged_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Work shared through the folder that the task names; null: it names none.
/// @param further  what the result depends on besides the project, for the identity of the study
/// @param ends  see study::SharedWork  @throws foundation::InvalidInput
[[nodiscard]] std::unique_ptr<study::SharedWork> shared_work(const Task& task, const study::StudyIdentity& further,
                                                             const std::function<bool()>& ends);

/// The remark that one of several processes does the work of all, without a folder.
void note_unshared(const Task& task, Result& result);

/// Progress of a task that throws Interrupted once a signal is to end the shared work.
[[nodiscard]] foundation::Progress shared_progress(const Task& task, const study::SharedWork* shared);

/// In place of a result, within a handler of Interrupted: says how to go on. @throws it again if no signal ended the
/// work
[[nodiscard]] Result ended_study(const Task& task, const study::SharedWork* shared);

/// States what was read and computed, and writes the result files if the result is whole, or else how to go on.
/// @param shared  null: `note_unshared`
void add_shared(const study::SharedWork* shared, const Task& task, Result& result);

}  // namespace trivet::engine
