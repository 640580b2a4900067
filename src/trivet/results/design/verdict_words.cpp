// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/verdict_words.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/requirements/band_words.h"

namespace trivet::results {
namespace {

using study::RequirementResult;
using study::ShownValue;

/// "60.7 % (T = 0.393, 8.11 dB)", or "amplified: T = 6.41, isolation -16.1 dB".
std::string isolation_cell(double transmissibility) {
  constexpr double percent = 100;
  const double level = response::isolation_level(transmissibility);
  if (transmissibility > 1) return fmt::format("amplified: T = {:.4g}, isolation {:.3g} dB", transmissibility, level);
  return fmt::format("{:.4g} % (T = {:.4g}, {:.3g} dB)", percent * response::isolation_efficiency(transmissibility),
                     transmissibility, level);
}

/// "2.557 of 3.12 µm/s rms (81.94 %)"
std::string level_on_line(const RequirementResult& r, const project::DisplayUnits& display) {
  const std::string share = fmt::format("{:.4g} %", 100 * *r.value);
  DisplayUnit unit = display_unit(display, r.on_line->unit);
  unit.level = r.on_line->rms ? " rms" : " 0-p";
  const UnitPrefix prefix = unit_prefix(r.on_line->limit, unit);  // of both: a level is compared with its limit
  const auto text = [&](double value) { return foundation::significant(value * prefix.factor) + " " + prefix.unit; };
  return fmt::format("{} of {} ({})", text(*r.value * r.on_line->limit), text(r.on_line->limit), share);
}

/// Words of the requirement with its band in the unit of [display].
std::string with_shown_band(const std::string& words, const RequirementResult& r,
                            const project::DisplayUnits& display) {
  const std::string in_hertz = study::hertz_words(r.band);
  const std::size_t at = words.rfind(in_hertz);
  if (display.frequency.empty() || at == std::string::npos || at == 0 || words[at - 1] != ' ') return words;
  const auto number = [&](double omega) { return fmt::format("{:.5g}", shown_frequency(display, omega)); };
  const std::string shown = number(r.band.from) +
      (r.band.from < r.band.to ? " … " + number(r.band.to) : std::string()) + " " + frequency_unit(display);
  return words.substr(0, at) + shown + words.substr(at + in_hertz.size());
}

}  // namespace

Kind kind_of_numbers(const RequirementResult& r) {
  const ShownValue shown = study::requirement_row(r.kind).shown;
  if (shown == ShownValue::frequency) return Kind::frequency;
  return shown == ShownValue::amplitude ? Kind::amplitude : Kind::quantity;
}

DisplayUnit requirement_unit(const RequirementResult& r, const project::DisplayUnits& display) {
  const Kind kind = kind_of_numbers(r);
  if (study::requirement_row(r.kind).shown == ShownValue::rms) return root_mean_square_unit(display, r.unit);
  if (kind == Kind::frequency) return {frequency_unit(display), "", shown_frequency(display, 1), false};
  if (kind == Kind::amplitude) {
    project::DisplayUnits at_level = display;
    at_level.level = r.level_for_people(display);
    return amplitude_unit(at_level, r.unit);
  }
  DisplayUnit unit = display_unit(display, r.unit);
  if (*r.level()) unit.level = std::string(" ") + r.level();
  return unit;
}

std::string bound_words(const RequirementResult& r, const project::DisplayUnits& display) {
  const std::string scope = with_shown_band(r.words.scope, r, display);
  if (!r.has_bound_in_units()) return r.words.bound + scope;
  return "≤ " + value_text(r.allowed, requirement_unit(r, display)) + scope;
}

std::string requirement_words(const RequirementResult& r, const project::DisplayUnits& display) {
  const std::string judged = with_shown_band(r.words.judged, r, display);
  return judged + (r.words.bound.empty() ? with_shown_band(r.words.scope, r, display) : " " + bound_words(r, display));
}

std::string value_words(const RequirementResult& r, double value, const project::DisplayUnits& display) {
  if (std::isinf(value)) return "∞";
  switch (study::requirement_row(r.kind).shown) {
    case ShownValue::share_of_line:
    case ShownValue::share:
      return fmt::format("{:.4g} %", 100 * value);
    case ShownValue::isolation:
      return isolation_cell(value);
    case ShownValue::count:
      return fmt::format("{:g}", value);
    case ShownValue::frequency:
      return shown_quantity({.value = value, .kind = Kind::frequency}, display);
    case ShownValue::number:
      return fmt::format("{:.5g}", value);
    case ShownValue::sum:
      return fmt::format("{:.6g} {}", value * requirement_unit(r, display).factor, requirement_unit(r, display).unit);
    default:
      return value_text(without_round_off(value, r.allowed), requirement_unit(r, display));
  }
}

std::string judged_value(const RequirementResult& r, const project::DisplayUnits& display) {
  if (!r.value) return "";
  const bool has_line = study::requirement_row(r.kind).shown == ShownValue::share_of_line && r.on_line;
  return has_line && std::isfinite(*r.value) ? level_on_line(r, display) : value_words(r, *r.value, display);
}

std::string judged_place(const RequirementResult& r, const project::DisplayUnits& display) {
  std::string text;
  if (r.angular_frequency) text = shown_quantity({.value = *r.angular_frequency, .kind = Kind::frequency}, display);
  if (r.time) text = fmt::format("{:.5g} s", *r.time);
  if (!r.detail.empty()) text += (text.empty() ? "" : ", ") + r.detail;
  return text;
}

const char* verdict_word(const RequirementResult& result) {
  if (!result.value) return "NOT JUDGED";
  return result.met() ? "met" : "VIOLATED";
}

std::vector<std::size_t> by_margin(const study::CaseVerdict& judged) {
  std::vector<std::size_t> order(judged.results.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const RequirementResult &x = judged.results[a], &y = judged.results[b];
    return x.value.has_value() == y.value.has_value() ? x.margin < y.margin : !x.value.has_value();
  });
  return order;
}

}  // namespace trivet::results
