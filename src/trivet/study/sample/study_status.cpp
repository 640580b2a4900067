// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/study_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/sample/sample_manifest.h"
#include "trivet/study/shared/study_folder.h"

namespace trivet::study {
namespace {

StudyStatus::Part status_of(const StudyFolder& folder, const StudyPart& part, const PartRecord& record,
                            const ChunkSet& all) {
  StudyStatus::Part found{.part = part, .done = record.chunks.size()};
  const bool runs = is_worked_on(folder.handle(), part);
  found.state = runs     ? StudyStatus::State::running
      : record.has_ended ? StudyStatus::State::ended
                         : StudyStatus::State::stopped;
  for (std::uint64_t chunk = 0; chunk < all.chunks(); ++chunk)
    if (part.has(chunk) && !all.holds(chunk)) ++found.missing;
  if (record.milliseconds > 0)
    found.rate = 1e3 * static_cast<double>(record.computed) / static_cast<double>(record.milliseconds);
  const auto now =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch());
  const auto at = static_cast<std::int64_t>(record.written_at);
  found.written_ago = static_cast<std::uint64_t>(std::max<std::int64_t>(0, now.count() - at));  // of another clock
  return found;
}

/// "optimize"
std::string command_of(const StudyManifest& manifest) {
  for (const auto& [key, value] : manifest.identity)
    if (key == "command") return value;
  return "";
}

}  // namespace

StudyStatus study_status(const std::filesystem::path& path) {
  const StudyFolder folder = StudyFolder::found(path);
  const auto manifest = folder.manifest();
  if (!manifest)
    throw foundation::InvalidInput(
        fmt::format("study folder {}: study.txt is damaged; the command that made it writes it again", path.string()));
  const auto fixed = FixedBySample::read(manifest->fixed);
  if (!fixed)
    throw foundation::InvalidInput(fmt::format(
        "study folder {}: it is of trivet {}, which has no chunks of designs; its processes show how far they are",
        path.string(), command_of(*manifest)));
  const StudyFolder::Content content = folder.content(*manifest, fixed->chunks.count());
  StudyStatus status{.folder = path,
                     .designs = fixed->chunks.designs,
                     .chunks = fixed->chunks.count(),
                     .done = content.chunks.size(),
                     .damaged = content.damaged,
                     .overlapping = content.overlapping};
  for (const auto& [part, record] : content.parts)
    status.parts.push_back(status_of(folder, part, record, content.chunks));
  std::ranges::sort(status.parts, [](const auto& one, const auto& other) {
    return std::pair(one.part.of, one.part.number) < std::pair(other.part.of, other.part.number);
  });
  for (const StudyStatus::Part& one : status.parts) {
    if (one.state != StudyStatus::State::running || !one.rate || *one.rate == 0) continue;
    status.rate += *one.rate;
    const double left = static_cast<double>(one.missing * fixed->chunks.size) / *one.rate;
    status.seconds = std::max(status.seconds.value_or(0), left);
  }
  return status;
}

const char* state_name(StudyStatus::State state) {
  switch (state) {
    case StudyStatus::State::running:
      return "running";
    case StudyStatus::State::ended:
      return "ended";
    case StudyStatus::State::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace trivet::study
