// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/model/element_results.h"

/// A model with some elements replaced by three springs.
namespace trivet::results {
namespace {

using study::HighestPeak;
using study::ModeComparison;
using study::PeakComparison;

Json difference_words(const std::optional<double>& difference) {
  if (!difference) return nullptr;
  constexpr double round_off = 1e-9, one_decimal = 0.01;
  if (std::abs(*difference) < round_off) return "0 %";
  return std::abs(*difference) < one_decimal ? fmt::format("{:+.2g} %", 100 * *difference)
                                             : fmt::format("{:+.1f} %", 100 * *difference);
}

Table mode_comparison(const study::Simplification& simple) {
  const Rows row(simple.modes);
  const auto difference = [](const ModeComparison& mode) {
    return study::relative_difference(mode.full, mode.simplified);
  };
  const auto simplified = [](const ModeComparison& mode) {
    return mode.simplified && *mode.simplified == 0 ? Json("0 (free)") : cell(mode.simplified);
  };
  return {.key = "modes",
          .rows = row.size(),
          .columns = {row("mode", Kind::number, "mode", &ModeComparison::number),
                      row("name", Kind::words, "", &ModeComparison::name, {.forms = in_json}),
                      row("angular_frequency", Kind::frequency, "ω", &ModeComparison::full),
                      row("simplified_angular_frequency", Kind::frequency, "", &ModeComparison::simplified),
                      row("simplified", Kind::frequency, "three springs", simplified, {.forms = for_people}),
                      row("relative_difference", Kind::share, "", difference),
                      row("difference", Kind::number, "difference",
                          [=](const ModeComparison& mode) { return difference_words(difference(mode)); },
                          {.forms = for_people}),
                      row("likeness", Kind::number, "MAC", &ModeComparison::similarity, {.digits = 3}),
                      row("name", Kind::words, "motion", &ModeComparison::name, {.forms = for_people})}};
}

Table peak_comparison(const study::Simplification& simple) {
  const Rows row(simple.peaks);
  using Peak = std::optional<HighestPeak> PeakComparison::*;
  const auto of = [](const PeakComparison& one, Peak peak, double HighestPeak::* member) {
    return one.*peak ? std::optional((*(one.*peak)).*member) : std::nullopt;
  };
  const auto number = [&](Kind kind, const char* heading, Peak peak, double HighestPeak::* member) {
    return row(heading, kind, heading, [=](const PeakComparison& one) { return of(one, peak, member); },
               {.forms = for_people});
  };
  const auto difference = [&](double HighestPeak::* member) {
    const auto words = [=](const PeakComparison& one) {
      return difference_words(study::relative_difference(of(one, &PeakComparison::full, member),
                                                         of(one, &PeakComparison::simplified, member)));
    };
    return row("difference", Kind::number, "difference", words, {.forms = for_people});
  };
  const auto object = [&](const char* name, Peak peak) {
    const auto numbers = [=](const PeakComparison& one) {
      return one.*peak ? Json{{"angular_frequency", json::number((one.*peak)->angular_frequency)},
                              {"amplitude", json::number((one.*peak)->amplitude)}}
                       : Json();
    };
    return row(name, Kind::words, "", numbers, {.forms = in_json});
  };
  return {.key = "peaks",
          .rows = row.size(),
          .columns = {
              row("name", Kind::words, "highest peak of", &PeakComparison::name),
              row("unit", Kind::words, "", &PeakComparison::unit), object("peak", &PeakComparison::full),
              object("simplified_peak", &PeakComparison::simplified),
              row("simplified_vanishes", Kind::yes_no, "", &PeakComparison::vanishes, {.forms = in_json}),
              number(Kind::frequency, "ω", &PeakComparison::full, &HighestPeak::angular_frequency),
              number(Kind::frequency, "three springs", &PeakComparison::simplified, &HighestPeak::angular_frequency),
              difference(&HighestPeak::angular_frequency),
              number(Kind::amplitude, "amplitude", &PeakComparison::full, &HighestPeak::amplitude),
              number(Kind::amplitude, "three springs", &PeakComparison::simplified, &HighestPeak::amplitude),
              difference(&HighestPeak::amplitude)}};
}

}  // namespace

Group simplification_group(const study::Simplification& simple) {
  Group group{.key = "simplification",
              .parts = {{Words{.key = "replaced", .list = simple.replaced}},
                        {Words{.key = "left_out", .list = simple.left_out}},
                        {mode_comparison(simple)},
                        {Words{.key = "free_motions", .list = simple.free_motions}}},
              .title = fmt::format(
                  "{} replaced by three springs in this model\n(only the translational stiffness of K along the local "
                  "axes{}{})",
                  fmt::join(simple.replaced, ", "),
                  simple.left_out.empty() ? "" : "; also neglected: ", fmt::join(simple.left_out, ", "))};
  const auto note = [&](std::vector<std::variant<std::string, Quantity>> words) {
    group.parts.push_back({Sentence{.parts = std::move(words), .place = Sentence::Place::note}});
  };
  for (const std::string& motion : simple.free_motions) note({"with three springs " + motion});
  if (simple.inner_modes > 0)
    note({fmt::format("{} further modes are mostly inside elements, from ", simple.inner_modes),
          Quantity{simple.first_inner_mode.value_or(nothing), "rad/s", Kind::frequency}, " on; they are not compared"});
  group.parts.push_back({peak_comparison(simple)});
  group.parts.push_back({Single{"no_peaks", simple.no_peaks}});
  if (!simple.no_peaks.empty()) note({"no peaks compared: " + simple.no_peaks});
  for (const PeakComparison& peak : simple.peaks)
    if (peak.vanishes || (peak.full && !peak.simplified))
      note({fmt::format("{}: no {} with three springs", peak.name, peak.vanishes ? "motion" : "peak")});
  return group;
}

}  // namespace trivet::results
