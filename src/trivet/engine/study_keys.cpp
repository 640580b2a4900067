// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/study_keys.h"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>
#include <utility>

#include "trivet/engine/key_reader.h"
#include "trivet/engine/names.h"
#include "trivet/foundation/interruption.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/results/files/whole_file.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;
namespace fs = std::filesystem;

}  // namespace

Key study_key(const std::string& about, const std::string& files) {
  return {.name = "output",
          .kind = KeyKind::file,
          .about = about + "; or a file for the result whose ending chooses the form: " + files,
          .short_name = "o",
          .value = "STUDY"};
}

Key part_key() {
  return {.name = "part",
          .kind = KeyKind::text,
          .about =
              "compute this part of the study folder: 3/64; by default the rank among the processes of mpirun, of "
              "srun or of an array of Slurm",
          .value = "K/N"};
}

std::optional<fs::path> study_folder(const Task& task) {
  if (!task.keys.has("output")) {
    if (task.keys.has("part"))
      throw InvalidInput(fmt::format("{}: parts share a study folder; name it with {}", task.keys.written("part"),
                                     task.keys.written("output")));
    return std::nullopt;
  }
  fs::path folder = task.keys.text("output");
  std::error_code none;
  if (folder.has_extension() && !fs::exists(folder, none))
    throw InvalidInput(fmt::format(
        "{} {}: this command writes no {} file, and the name of a new study folder has no ending; name another",
        task.keys.written("output"), folder.string(), folder.extension().string()));
  return folder;
}

std::string same_command(const Task& task) {
  std::string words = "trivet " + task.command.name + " " + project_word(*task.project);
  for (const std::string& setting : task.settings) words += " --set " + shell_word(setting);
  if (!task.request.case_name.empty()) words += " --case " + shell_word(task.request.case_name);
  for (const auto& [key, value] : task.request.keys)
    if (key != "time-limit")
      words += " --" + key + (std::holds_alternative<bool>(value) ? "" : " " + shell_word(text_of(value)));
  return words;
}

RankedPart part_of(const Task& task) {
  if (task.keys.has("part"))
    return {part_of_words(task.keys.text("part"), task.keys.written("part")), task.keys.written("part")};
  return part_of_rank([](const char* name) -> const char* { return std::getenv(name); }).value_or(RankedPart());
}

void write_result_files(const fs::path& folder, const Result& result) {
  const auto write = [&](const std::string& name, const Writer& form) {
    const results::WholeFile file(folder / name, [](const fs::path&) { return std::string(); });
    file.publish(whole(form));
  };
  write("result.json", result.json);
  for (const auto& [name, table] : result.tables) write(name, table);
}

std::string files_words(const std::vector<std::string>& names) {
  return fmt::format("{} file{} ({})", names.size(), names.size() == 1 ? "" : "s", foundation::comma_separated(names));
}

std::string without_locks(const fs::path& folder) {
  return folder.string() + ": this file system has no locks: two processes with the same part are not noticed";
}

std::string damaged_files(const fs::path& folder, const std::vector<std::string>& names) {
  return fmt::format("{}: {} cannot be read: damaged; what it had is computed again", folder.string(),
                     files_words(names));
}

std::unique_ptr<study::SharedWork> shared_work(const Task& task, const study::StudyIdentity& further,
                                               const std::function<bool()>& ends) {
  const auto folder = study_folder(task);
  if (!folder) return nullptr;
  study::StudyIdentity identity = study::study_identity(task.command.name, *task.project);
  identity.insert(identity.end(), further.begin(), further.end());
  const auto ends_now = [ends, ends_study = task.request.ends_study] {
    return (ends && ends()) || (ends_study && ends_study());
  };
  static_cast<void>(ends_now());  // from now on signals end the study
  return std::make_unique<study::SharedWork>(*folder, part_of(task).part, identity, ends_now);
}

foundation::Progress shared_progress(const Task& task, const study::SharedWork* shared) {
  if (!shared || !task.request.ends_study) return task.progress;
  return [&task](std::string_view what, double fraction) {
    if (task.request.ends_study()) throw foundation::Interrupted();
    foundation::report_progress(task.progress, what, fraction);
  };
}

Result ended_study(const Task& task, const study::SharedWork* shared) {
  if (!shared || !task.request.ends_study || !task.request.ends_study()) throw;
  Result result;
  result.complete = false;
  result.failure = shared->folder().string() + ": ended by a signal; what was computed is kept";
  result.go_on = same_command(task);
  return result;
}

void note_unshared(const Task& task, Result& result) {
  try {
    const RankedPart part = part_of(task);
    if (part.part.of > 1)
      result.remarks.push_back(fmt::format("{}: every process computes all of it; {} STUDY shares the work",
                                           part.words(), task.keys.written("output")));
  } catch (const InvalidInput&) {  // ranks that contradict each other matter only to a study
  }
}

void add_shared(const study::SharedWork* shared, const Task& task, Result& result) {
  if (!shared) return note_unshared(task, result);
  const auto [read, computed] = shared->counts();
  if (!shared->damaged().empty()) result.remarks.push_back(damaged_files(shared->folder(), shared->damaged()));
  result.remarks.push_back(fmt::format("{}: {} results of others or of earlier runs were read; {} computed {}",
                                       shared->folder().string(), read, part_of(task).words(), computed));
  if (!shared->is_locked()) result.remarks.push_back(without_locks(shared->folder()));
  if (result.complete) write_result_files(shared->folder(), result);
  else result.go_on = same_command(task);
}

}  // namespace trivet::engine
