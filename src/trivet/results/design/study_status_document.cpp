// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/study_status_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::StudyStatus;

std::string duration_words(double seconds) {
  constexpr double minute = 60, hour = 3600, longest_of_one = 90;
  if (seconds < longest_of_one) return fmt::format("{:.0f} s", seconds);
  if (seconds < longest_of_one * minute) return fmt::format("{:.0f} min", seconds / minute);
  return fmt::format("{:.1f} h", seconds / hour);
}

std::string summary(const StudyStatus& status) {
  const auto running = std::ranges::count(status.parts, StudyStatus::State::running, &StudyStatus::Part::state);
  std::string words =
      fmt::format("{} of {} chunks are done ({:.3g} %), of {} designs; ", status.done, status.chunks,
                  100 * static_cast<double>(status.done) / static_cast<double>(status.chunks), status.designs);
  if (status.done == status.chunks) return words + "the study is complete.";
  if (running == 0) return words + "no process works on it: start its command again to go on.";
  words += fmt::format("{} part{} running", running, running == 1 ? "" : "s");
  if (!status.seconds) return words + ".";
  return words +
      fmt::format(", {} designs/s, about {} left for {}.", foundation::significant(status.rate, 3),
                  duration_words(*status.seconds), running == 1 ? "it" : "them");
}

Table part_table(const StudyStatus& status) {
  using Part = StudyStatus::Part;
  const Rows row(status.parts);
  return {.key = "parts",
          .file = "status.csv",
          .rows = row.size(),
          .columns = {row("part", Kind::number, "part", [](const Part& one) { return one.part.number; }),
                      row("of", Kind::number, "of", [](const Part& one) { return one.part.of; }),
                      row("state", Kind::words, "state", [](const Part& one) { return state_name(one.state); }),
                      row("done", Kind::number, "chunks done", &Part::done),
                      row("missing", Kind::number, "missing", &Part::missing),
                      row("rate", Kind::number, "designs", &Part::rate, {.unit = "1/s", .digits = 3}),
                      row("written_ago", Kind::number, "file written before", &Part::written_ago, {.unit = "s"})},
          .forms = in_json | in_csv | on_screen | on_page};
}

void say_files(const char* what, const std::vector<std::string>& names, Document& document) {
  if (names.empty()) return;
  document.add(Sentence{.parts = {fmt::format("{}: {}.", what, foundation::comma_separated(names))},
                        .forms = on_screen | on_page});
}

}  // namespace

Document study_status_document(const StudyStatus& status) {
  Document document;
  document.add(Sentence{.parts = {status.folder.string() + ": " + summary(status)}, .forms = on_screen | on_page});
  const auto add = [&](const char* name, Json value, const char* unit = "1") {
    document.add(Single{.name = name, .value = std::move(value), .unit = unit});
  };
  add("designs", status.designs);
  add("chunks", status.chunks);
  add("done", status.done);
  add("rate", status.rate, "1/s");
  add("seconds_left", status.seconds ? Json(*status.seconds) : Json(), "s");
  add("damaged", status.damaged);
  add("overlapping", status.overlapping);
  document.add(part_table(status));
  say_files("Damaged, to be computed again", status.damaged, document);
  say_files("Not counted, for others have the same chunks", status.overlapping, document);
  return document;
}

}  // namespace trivet::results
