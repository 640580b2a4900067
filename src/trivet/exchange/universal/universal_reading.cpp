// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <vector>

#include "trivet/exchange/text/file_bytes.h"
#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_contents.h"
#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_functions.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::exchange {
namespace {

/// What a set that is not read contains: " (groups)".
std::string_view content_of_set(int type) {
  switch (type) {
    case 71:
    case 780:
      return " (elements)";
    case 2400:
    case 1858:
      return " (description)";
    case 2429:
    case 2430:
    case 2432:
    case 2435:
    case 2452:
    case 2467:
    case 2477:
      return " (groups)";
    case 1707:
    case 1710:
      return " (materials)";
    case 56:
    case 57:
      return " (results at elements)";
    default:
      return "";
  }
}

bool needs_unit(const UniversalAxis& axis) {
  return axis.quantity != UniversalQuantity::unknown && axis.quantity != UniversalQuantity::time &&
      axis.quantity != UniversalQuantity::frequency;
}

/// True if the labels state all units, so that no set 164 is missed.
bool states_units_by_labels(const UniversalFunction& function) {
  for (const UniversalAxis* axis : {&function.abscissa_axis, &function.numerator, &function.denominator})
    if (needs_unit(*axis) && !axis->stated.by_label) return false;
  return true;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Reads the sets of one file, one after another.
class UniversalReader {
 public:
  UniversalReader(std::string_view bytes, const std::string& source) : problems_(source), scanner_(bytes, problems_) {}
  foundation::Expected<UniversalRead> result();

 private:
  void read_set(const UniversalSet& set);
  void read_function(const UniversalSet& set, SetProblems& problems);
  void read_mode(const UniversalSet& set, SetProblems& problems);
  void read_analysis_data(const UniversalSet& set, SetProblems& problems);
  void read_units(const UniversalSet& set, SetProblems& problems);
  void warn_about_units();
  void warn_about_ignored_sets();
  void warn_about_comments();
  [[nodiscard]] UniversalUnits units() const { return file_.units_of_file.value_or(UniversalUnits{}); }
  [[nodiscard]] bool has_quantities() const {
    return !file_.nodes.empty() || !file_.modes.empty() || !file_.functions.empty();
  }

  FileProblems problems_;
  SetScanner scanner_;
  UniversalFile file_;
  std::vector<UniversalSystem> systems_;
  UniversalResponses responses_;
  std::map<std::string, int> ignored_;        ///< what, how often
  std::map<std::string, int> other_results_;  ///< content of set 2414 that is no mode
  bool at_end_ = false;
};

void UniversalReader::read_function(const UniversalSet& set, SetProblems& problems) {
  auto read = read_universal_function(set, file_.units_of_file, problems);
  if (read.function) file_.functions.push_back(std::move(*read.function));
  if (!set.binary) return;
  if (read.end > 0) scanner_.continue_after(set, read.end);
  else at_end_ = true;  // the end of its values is not known
}

void UniversalReader::read_mode(const UniversalSet& set, SetProblems& problems) {
  auto read = read_universal_mode(set, units(), problems);
  if (read.mode) file_.modes.push_back(std::move(*read.mode));
  if (!read.other_content.empty()) ++ignored_["55 with " + read.other_content];
}

void UniversalReader::read_analysis_data(const UniversalSet& set, SetProblems& problems) {
  auto read = read_universal_analysis_mode(set, units(), problems);
  if (read.mode) file_.modes.push_back(std::move(*read.mode));
  if (read.response && !problems.any()) responses_.add(set, *read.response, file_.units_of_file);
  if (!read.other_content.empty()) ++other_results_[read.other_content];
}

void UniversalReader::read_units(const UniversalSet& set, SetProblems& problems) {
  const bool late = has_quantities() && !file_.units_of_file;
  if (auto read = read_universal_units(set, problems)) file_.units_of_file = std::move(*read);
  if (late)
    problems.warning(set.line, "order", "sets with numbers come before it", "set 164 holds for the sets after it",
                     "those before it are read as SI");
}

void UniversalReader::read_set(const UniversalSet& set) {
  SetProblems problems(problems_, set);
  if (set.binary && set.type != 58) {
    problems.error(set.line, "type", in_quotes(set.type_line), "only set 58 has a binary form, 58b",
                   "export the file again as text");
    at_end_ = true;
    return;
  }
  switch (set.type) {
    case 151:
      file_.header = read_universal_header(set, problems);
      break;
    case 164:
      read_units(set, problems);
      break;
    case 15: {
      const auto nodes = read_universal_nodes(set, units(), problems);
      file_.nodes.insert(file_.nodes.end(), nodes.begin(), nodes.end());
      break;
    }
    case 2411: {
      const auto nodes = read_universal_part_nodes(set, units(), problems);
      file_.nodes.insert(file_.nodes.end(), nodes.begin(), nodes.end());
      break;
    }
    case 18:
    case 2420: {
      const auto systems = set.type == 18 ? read_universal_systems(set, units(), problems)
                                          : read_universal_part_systems(set, units(), problems);
      systems_.insert(systems_.end(), systems.begin(), systems.end());
      break;
    }
    case 2412:
      ++ignored_[fmt::format("2412 with {} elements", count_universal_elements(set))];
      break;
    case 2414:
      read_analysis_data(set, problems);
      break;
    case 82:
      if (auto line = read_universal_line(set, problems)) file_.lines.push_back(std::move(*line));
      break;
    case 55:
      read_mode(set, problems);
      break;
    case 58:
      read_function(set, problems);
      break;
    default:
      ++ignored_[fmt::format("{}{}", set.type, content_of_set(set.type))];
  }
}

void UniversalReader::warn_about_units() {
  if (file_.units_of_file || !has_quantities()) return;
  const bool labelled =
      file_.nodes.empty() && file_.modes.empty() && std::ranges::all_of(file_.functions, states_units_by_labels);
  if (!labelled)
    problems_.warning(0, "units", "no set 164", "set 164 states the units of the numbers",
                      "numbers without the label of a known unit are read as SI");
}

void UniversalReader::warn_about_ignored_sets() {
  std::vector<std::string> results;
  for (const auto& [name, count] : other_results_) results.push_back(fmt::format("{} × {}", count, name));
  if (!results.empty())
    problems_.warning(
        0, "sets 2414", foundation::comma_separated(results),
        "displacements, velocities or accelerations of modes and of complex frequency responses at nodes are read",
        "the others are ignored; export modes at nodes, or functions over frequency as set 58");
  if (ignored_.empty()) return;
  std::vector<std::string> names;
  for (const auto& [name, count] : ignored_) names.push_back(count == 1 ? name : fmt::format("{} ({}×)", name, count));
  problems_.warning(
      0, "sets", foundation::comma_separated(names),
      "sets 15, 18, 55 and 2414 (modes; 2414 also frequency responses), 58, 58b, 82, 151, 164, 2411 and 2420 are read",
      "the others are ignored");
}

void UniversalReader::warn_about_comments() {
  if (const auto& comment = scanner_.first_comment())
    problems_.warning(comment->number, "lines between sets", in_quotes(comment->text),
                      "a line outside the sets is a comment", "ignored, like other such lines of the file");
}

foundation::Expected<UniversalRead> UniversalReader::result() {
  bool any_set = false;
  while (!at_end_ && !problems_.enough()) {
    const auto set = scanner_.next();
    if (!set) break;
    any_set = true;
    read_set(*set);
  }
  if (!any_set && !problems_.any())
    problems_.error(0, "universal file", scanner_.found_delimiter() ? "no set after a line with -1" : "no line with -1",
                    "each set of a universal file is between two lines with only -1 in columns 5 and 6",
                    "is this a universal file (.unv, .uff)?");
  for (UniversalFunction& function : responses_.functions(problems_)) file_.functions.push_back(std::move(function));
  if (problems_.any()) return problems_.refused();
  apply_systems(systems_, file_.nodes);
  warn_about_units();
  warn_about_ignored_sets();
  warn_about_comments();
  return UniversalRead{std::move(file_), problems_.all()};
}

}  // namespace

foundation::Expected<UniversalRead> read_universal_text(std::string_view bytes, const std::string& source) {
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  return UniversalReader(bytes, source).result();
}

bool begins_as_universal_file(std::string_view bytes) {
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  const std::size_t first = bytes.find_first_not_of(" \r\n");
  if (first == std::string_view::npos) return false;
  const std::size_t end = std::min(bytes.find_first_of("\r\n", first), bytes.size());
  return is_delimiter(bytes.substr(first, end - first));
}

bool is_universal_file(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  if (ending == ".uff" || ending == ".unv" || ending == ".uf" || ending == ".58") return true;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream stream(path, std::ios::binary);
  constexpr std::size_t enough = 200;
  std::string beginning(enough, '\0');
  stream.read(beginning.data(), static_cast<std::streamsize>(enough));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  return begins_as_universal_file(beginning);
}

foundation::Expected<UniversalRead> read_universal(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path, universal_file_rules);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return read_universal_text(with_line_feeds(*bytes), path.string());
}

}  // namespace trivet::exchange
