// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/box_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/foundation/plain_text.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/design/worst_case_parts.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using namespace documents;
using study::BoxCase;
using study::BoxEnd;
using study::BoxNumber;
using study::BoxRange;
using study::BoxRequirement;
using study::BoxStop;
using study::SolutionBox;

/// Towards the number in the file, so that printed ranges are within the box.
enum class Inward { up, down };

double rounded_inward(double value, Inward to, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  const double scaled = value * unit, whole = std::round(scaled);
  constexpr double same = 1e-9;  // 0.85 is no 0.85000000000001
  if (std::abs(scaled - whole) <= same * std::abs(scaled)) return whole / unit;
  return (to == Inward::up ? std::ceil(scaled) : std::floor(scaled)) / unit;
}

constexpr int shown_digits = 5;

std::string end_of_number(const BoxNumber& number, double value, Inward to) {
  return number.unit.after(
      fmt::format("{:.{}g}", rounded_inward(value / number.unit.si, to, shown_digits), shown_digits));
}

struct NumberRow {
  const SolutionBox* box;
  const BoxRange* range;
  const BoxNumber* number;

  [[nodiscard]] std::optional<double> ratio(double value) const {
    return number->given != 0 ? std::optional(value / number->given) : std::nullopt;
  }
};

/// Columns of files about one end of the range of a number.
void add_end_columns(const Rows<NumberRow>& row, const std::string& name, BoxEnd BoxRange::* end,
                     std::vector<Column>& columns) {
  const auto add = [&](const char* key, Kind kind, auto get) {
    columns.push_back(row(name + key, kind, "",
                          [end, get](const NumberRow& one) { return get(*one.box, one.range->*end); },
                          {.forms = in_csv}));
  };
  add("_times", Kind::number, [](const SolutionBox&, const BoxEnd& of) { return of.times; });
  add("_stop", Kind::words, [](const SolutionBox&, const BoxEnd& of) { return study::name(of.stop); });
  add("_stopped_by", Kind::words, [](const SolutionBox& box, const BoxEnd& of) { return box_stop_words(box, of); });
  add("_settings", Kind::words, [](const SolutionBox&, const BoxEnd& of) { return setting_words(of.beyond); });
}

Table number_table(const SolutionBox& box) {
  std::vector<NumberRow> list;
  for (const BoxRange& range : box.ranges)
    for (const BoxNumber& number : range.numbers) list.push_back({&box, &range, &number});
  const Rows row(std::move(list));
  const ColumnOptions data = {.forms = in_json | in_csv}, people = {.forms = for_people};
  const auto value = [&](const char* name, double BoxNumber::* of) {
    return row(name, Kind::quantity, "", [of](const NumberRow& one) { return one.number->*of; }, data);
  };
  const auto ratio = [&](const char* name, double BoxNumber::* of) {
    return row(name, Kind::number, "", [of](const NumberRow& one) { return one.ratio(one.number->*of); }, data);
  };
  std::vector<Column> columns = {
      row("tolerance", Kind::words, "range of", [](const NumberRow& one) { return one.range->name; }),
      row("number", Kind::words, "number", [](const NumberRow& one) { return one.number->path; }),
      row(
          "unit", Kind::words, "", [](const NumberRow& one) { return one.number->si; }, data),
      value("given", &BoxNumber::given),
      value("from", &BoxNumber::from),
      value("to", &BoxNumber::to),
      ratio("factor_from", &BoxNumber::from),
      ratio("factor_to", &BoxNumber::to),
      row(
          "given", Kind::words, "in the file",
          [](const NumberRow& one) { return box_number_words(*one.number, one.number->given); }, people),
      row(
          "from", Kind::words, "from",
          [](const NumberRow& one) { return end_of_number(*one.number, one.number->from, Inward::up); }, people),
      row(
          "to", Kind::words, "to",
          [](const NumberRow& one) { return end_of_number(*one.number, one.number->to, Inward::down); }, people)};
  add_end_columns(row, "lower", &BoxRange::lower, columns);
  add_end_columns(row, "upper", &BoxRange::upper, columns);
  return {.key = "numbers",
          .file = "box.csv",
          .rows = row.size(),
          .columns = std::move(columns),
          .forms = in_json | in_csv | on_screen | on_page};
}

struct EndRow {
  const SolutionBox* box;
  const BoxRange* range;
  bool upper;

  [[nodiscard]] const BoxEnd& end() const { return upper ? range->upper : range->lower; }
  [[nodiscard]] const BoxCase* in() const {
    return end().stop == BoxStop::requirement ? &box->cases[end().in_case] : nullptr;
  }
};

Table end_table(const SolutionBox& box) {
  std::vector<EndRow> list;
  for (const BoxRange& range : box.ranges)
    for (const bool upper : {false, true}) list.push_back({&box, &range, upper});
  const Rows row(std::move(list));
  const ColumnOptions data = {.forms = in_json}, people = {.forms = for_people};
  return {.key = "ends",
          .rows = row.size(),
          .columns = {row("tolerance", Kind::words, "end of", [](const EndRow& one) { return one.range->name; }),
                      row("end", Kind::words, "", [](const EndRow& one) { return one.upper ? "upper" : "lower"; }),
                      row(
                          "draw", Kind::number, "", [](const EndRow& one) { return one.end().draw; }, data),
                      row(
                          "relative", Kind::yes_no, "", [](const EndRow& one) { return one.range->relative; }, data),
                      row(
                          "deviation", Kind::words, "deviation",
                          [](const EndRow& one) { return box_end_words(*one.range, one.end()); }, people),
                      row("times", Kind::number, "of the tolerance", [](const EndRow& one) { return one.end().times; },
                          {.digits = 4}),
                      row(
                          "stop", Kind::words, "", [](const EndRow& one) { return study::name(one.end().stop); }, data),
                      row(
                          "case", Kind::words, "",
                          [](const EndRow& one) { return one.in() ? Json(one.in()->case_name) : Json(); }, data),
                      row(
                          "requirement", Kind::words, "",
                          [](const EndRow& one) {
                            return one.in() ? Json(one.in()->requirements[one.end().requirement].given.words_at_level())
                                            : Json();
                          },
                          data),
                      row(
                          "reason", Kind::words, "", [](const EndRow& one) { return one.end().reason; }, data),
                      row(
                          "stopped_by", Kind::words, "stopped by",
                          [](const EndRow& one) { return box_stop_words(*one.box, one.end()); }, people),
                      row(
                          "is_corner", Kind::yes_no, "", [](const EndRow& one) { return one.end().is_corner; }, data),
                      row(
                          "beyond", Kind::words, "",
                          [](const EndRow& one) {
                            return one.end().beyond.empty() ? Json() : numbers_json(one.end().beyond);
                          },
                          data),
                      row(
                          "settings", Kind::words, "",
                          [](const EndRow& one) { return setting_words(one.end().beyond); }, data)},
          .forms = in_json | on_screen | on_page};
}

struct CheckedRow {
  const BoxCase* in;
  const BoxRequirement* of;
};

Table requirement_table(const SolutionBox& box) {
  std::vector<CheckedRow> list;
  for (const BoxCase& one : box.cases)
    for (const BoxRequirement& of : one.requirements) list.push_back({&one, &of});
  const Rows row(std::move(list));
  const ColumnOptions data = {.forms = in_json}, shown = {.digits = 5};
  return {.key = "requirements",
          .rows = row.size(),
          .columns = {row(
                          "case", Kind::words, "", [](const CheckedRow& one) { return one.in->case_name; }, data),
                      row(
                          "kind", Kind::words, "",
                          [](const CheckedRow& one) { return study::name(one.of->given.kind); }, data),
                      row(
                          "requirement", Kind::words, "",
                          [](const CheckedRow& one) { return one.of->given.words_at_level(); }, data),
                      row("requirement", Kind::words, "requirement",
                          [](const CheckedRow& one) {
                            return requirement_words(one.of->given, one.in->display) + in_case_words(one.in->case_name);
                          },
                          {.forms = for_people}),
                      row(
                          "margin", Kind::number, "margin in the file",
                          [](const CheckedRow& one) { return json::number(one.of->given.margin); }, shown),
                      row(
                          "least_margin", Kind::number, "least in the box",
                          [](const CheckedRow& one) { return json::number(one.of->least_margin); }, shown),
                      row(
                          "at_corner", Kind::yes_no, "", [](const CheckedRow& one) { return one.of->at_corner; }, data),
                      row("at", Kind::words, "at",
                          [](const CheckedRow& one) { return one.of->at_corner ? "a corner" : "inside"; },
                          {.forms = for_people})},
          .forms = in_json | on_screen | on_page};
}

std::size_t requirement_count(const SolutionBox& box) {
  std::size_t count = 0;
  for (const BoxCase& one : box.cases) count += one.requirements.size();
  return count;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string check_words(const SolutionBox& box) {
  const study::BoxCheck& check = box.check;
  std::string words =
      fmt::format("{} corners and {} designs inside were judged",
                  check.all_corners ? "All " + grouped(check.corners) : grouped(check.corners), grouped(check.inside));
  if (check.models > 0) words += fmt::format(", {} of them also by assembled models", grouped(check.models));
  words += check.violations == 0 ? ": none violates a requirement."
                                 : fmt::format(": {} VIOLATE a requirement.", grouped(check.violations));
  if (check.repeats > 0)
    words += fmt::format(" {} earlier box{} had violations there, and the ranges were determined again without these.",
                         check.repeats, check.repeats == 1 ? "" : "es");
  return words;
}

std::string box_verdict_words(const SolutionBox& box) {
  const std::size_t count = requirement_count(box);
  if (box.check.violations > 0)
    return fmt::format("NOT VERIFIED: {} of the designs judged within these ranges violate a requirement.",
                       grouped(box.check.violations));
  return fmt::format("Box: within these ranges every design that was judged meets {}.",
                     count == 1 ? "the requirement" : fmt::format("all {} requirements", count));
}

/// How the tolerances of the file compare with the box.
std::string tolerance_words(const SolutionBox& box) {
  std::vector<std::string> beyond;
  for (const BoxRange& one : box.ranges)
    if (!one.has_tolerance()) beyond.push_back(one.name);
  const std::string times = fmt::format("All together may be {:.4g} times as wide as in the file.",
                                        rounded_inward(box.all_times, Inward::down, 4));
  if (beyond.empty()) return "The tolerances of the file are within the box. " + times;
  return fmt::format("The tolerances of the file are NOT all within the box: {}. {}",
                     foundation::comma_separated(beyond), times);
}

std::string method_words(const SolutionBox& box) {
  static_assert(study::box_step == 1e-6);
  const bool given_up = std::ranges::any_of(box.ranges, [](const BoxRange& one) {
    return one.lower.stop == BoxStop::not_determined || one.upper.stop == BoxStop::not_determined;
  });
  return fmt::format(
      "All ends moved outward together, in proportion to the tolerances, until one was stopped, and the others went "
      "on. "
      "So no end{} can be moved further alone by a millionth of its tolerance (or of its range, if that is wider) "
      "without a violation; a box with a larger volume may exist. The worst designs were searched ({} designs): a "
      "search, not a proof. Printed ends are rounded "
      "inward.{}",
      given_up ? " except those that are not determined" : "", grouped(box.searched),
      box.correlated ? " Correlations of the tolerances do not restrict a box." : "");
}

void add_singles(const SolutionBox& box, Document& document) {
  const auto add = [&](const char* name, Json value) { document.add(Single{.name = name, .value = std::move(value)}); };
  const study::BoxCheck& check = box.check;
  add("verified", check.violations == 0);
  add("all_times", box.all_times);
  add("most", box.request.most);
  add("drawn", box.draws);
  add("step", study::box_step);
  add("corners", check.corners);
  add("all_corners", check.all_corners);
  add("inside", check.inside);
  add("models", check.models);
  add("violations", check.violations);
  add("repeats", check.repeats);
  add("searched", box.searched);
}

}  // namespace

std::string box_number_words(const BoxNumber& number, double value) { return number.unit.words(value, 6); }

std::string box_end_words(const BoxRange& range, const BoxEnd& end) {
  const Inward to = &end == &range.lower ? Inward::up : Inward::down;
  constexpr int digits = 4;
  if (range.relative) return fmt::format("{:+.4g} %", rounded_inward(100 * (end.draw - 1), to, digits));
  const study::FileUnit& unit = range.numbers.front().unit;
  return unit.after(fmt::format("{:+.4g}", rounded_inward(end.draw / unit.si, to, digits)));
}

std::string box_stop_words(const SolutionBox& box, const BoxEnd& end) {
  if (end.stop == BoxStop::no_model) return "no model beyond: " + end.reason;
  if (end.stop == BoxStop::most) return fmt::format("nothing up to ×{:g}", box.request.most);
  if (end.stop == BoxStop::not_determined) return "not determined: the search was given up here";
  const BoxCase& in = box.cases[end.in_case];
  return requirement_words(in.requirements[end.requirement].given, in.display) + in_case_words(in.case_name);
}

Document box_document(const SolutionBox& box, const foundation::Problems& warnings) {
  Document document;
  const auto say = [&](std::string words, unsigned forms = on_screen | on_page) {
    document.add(Sentence{.parts = {std::move(words)}, .forms = forms});
  };
  say(box_verdict_words(box), for_people);
  say(tolerance_words(box), for_people);
  add_singles(box, document);
  document.add(number_table(box));
  document.add(end_table(box));
  document.add(requirement_table(box));
  say(check_words(box));
  for (const BoxCase& one : box.cases)
    if (!one.no_kernels.empty())
      say(fmt::format("{}designs assembled one by one: {}.",
                      one.case_name.empty() ? "All " : "Case " + one.case_name + ": all ", one.no_kernels));
  say(method_words(box));
  document.add(Single{.name = "warnings", .value = json::warnings(warnings)});
  return document;
}

}  // namespace trivet::results
