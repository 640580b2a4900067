// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/process_rank.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <system_error>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

std::optional<std::uint64_t> rank_number(std::string_view words) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  if (error != std::errc() || end != words.data() + words.size()) return std::nullopt;
  return number;
}

std::optional<std::uint64_t> number_in(const Environment& environment, const char* name) {
  const char* words = environment(name);
  if (!words || *words == '\0') return std::nullopt;
  const auto number = rank_number(words);
  if (!number)
    throw InvalidInput(
        fmt::format("{} is {}, not a whole number; name the part with --part", name, foundation::quoted(words)));
  return number;
}

struct RankNames {
  const char *rank, *size;
};
/// mpirun in a job of Slurm sets its own; the task of the job is then the same for all of its processes.
constexpr std::array<RankNames, 4> rank_names = {{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                                  {"PMI_RANK", "PMI_SIZE"},
                                                  {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},
                                                  {"SLURM_PROCID", "SLURM_NTASKS"}}};

RankedPart part_at(std::uint64_t index, std::uint64_t of, const std::string& reason) {
  if (of == 0 || index >= of || of > study::most_parts)
    throw InvalidInput(fmt::format("{} name process {} of {}; name the part with --part", reason, index, of));
  return {{index + 1, of}, reason};
}

std::optional<RankedPart> part_of_process(const Environment& environment) {
  for (const auto& [rank, size] : rank_names) {
    const auto index = number_in(environment, rank), of = number_in(environment, size);
    if (index && of) return part_at(*index, *of, fmt::format("{} and {}", rank, size));
  }
  return std::nullopt;
}

std::optional<RankedPart> part_of_array(const Environment& environment) {
  const auto id = number_in(environment, "SLURM_ARRAY_TASK_ID"),
             count = number_in(environment, "SLURM_ARRAY_TASK_COUNT");
  if (!id || !count) return std::nullopt;
  const std::uint64_t least = number_in(environment, "SLURM_ARRAY_TASK_MIN").value_or(0),
                      step = number_in(environment, "SLURM_ARRAY_TASK_STEP").value_or(1);
  if (step == 0 || *id < least || (*id - least) % step != 0 || (*id - least) / step >= *count)
    throw InvalidInput(
        "the numbers of this array of Slurm are not evenly spaced, so they do not name its parts; take "
        "--array=1-N, or name the part with --part");
  return part_at((*id - least) / step, *count, "SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT");
}

}  // namespace

std::string RankedPart::words() const {
  return fmt::format("part {} of {}{}", part.number, part.of, reason.empty() ? "" : " (" + reason + ")");
}

study::StudyPart part_of_words(const std::string& words, const std::string& key) {
  const std::size_t slash = words.find('/');
  const auto number = rank_number(words.substr(0, slash)),
             of = slash == std::string::npos ? std::nullopt : rank_number(words.substr(slash + 1));
  if (!number || !of || *number < 1 || *number > *of || *of > study::most_parts)
    throw InvalidInput(fmt::format(
        "{} {}: give the part and the number of all, at most {}, as in 3/64: the third of 64, which are 1/64 to 64/64",
        key, foundation::quoted(words), study::most_parts));
  return {*number, *of};
}

std::optional<RankedPart> part_of_rank(const Environment& environment) {
  auto process = part_of_process(environment), array = part_of_array(environment);
  if (!array) return process;
  if (!process) return array;
  const auto [own, within] = std::pair(process->part, array->part);
  return part_at((within.number - 1) * own.of + own.number - 1, within.of * own.of,
                 array->reason + ", " + process->reason);
}

}  // namespace trivet::engine
