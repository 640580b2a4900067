// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// Force or motion that the mounts transmit.
namespace trivet::results {
namespace {

using response::isolation_efficiency;
using response::transmissibility_level;
using study::TransmissibilityResult;

double transmitted(const std::complex<double>& value) { return std::abs(value); }
double transmitted_level(const std::complex<double>& value) { return transmissibility_level(std::abs(value)); }

Curves transmissibility_curves(const TransmissibilityResult& t) {
  Curves curves{.axis = "angular_frequency",
                .unit = "rad/s",
                .points = t.curves.angular_frequency,
                .file = "transmissibility.csv",
                .axis_columns = {"angular_frequency [rad/s]"}};
  for (const response::Curve& c : t.curves.curves)  // "ground" or an element: such a name may be that of another array
    curves.list.push_back({.name = c.name + " transmissibility",
                           .unit = "1",
                           .values = c.value,
                           .csv = {{c.name + " [1]", transmitted}, {c.name + " [dB]", transmitted_level}}});
  return curves;
}

/// A number of each value of a curve.
std::vector<double> of_sizes(const response::Curve& c, double (*number)(double transmissibility)) {
  std::vector<double> numbers;
  for (const auto& value : c.value) numbers.push_back(number(std::abs(value)));
  return numbers;
}

Table transmissibility_table(const TransmissibilityResult& t) {
  using response::Curve;
  const Rows row(t.curves.curves);
  const auto last = [](const Curve& c) { return std::abs(c.value(c.value.size() - 1)); };
  const auto efficiency = [&t](std::size_t i) {
    return t.is_share(i) ? Numbers() : Numbers(of_sizes(t.curves.curves[i], isolation_efficiency));
  };
  const auto last_efficiency = [&t, last](std::size_t i) {
    return t.is_share(i) ? Json() : Json(isolation_efficiency(last(t.curves.curves[i])));
  };
  const auto isolates_from = [&t](std::size_t i) {
    return t.is_share(i) ? std::nullopt : t.crossovers[i].angular_frequency;
  };
  return {
      .key = "results",
      .axis = "result",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "result", &Curve::name),
                  row("unit", Kind::words, "", &Curve::unit, {.forms = in_json}),
                  row.lists("complex", "", "", {}, &Curve::value, {.forms = in_json}),
                  row.lists("level_db", "", "", {}, [](const Curve& c) { return of_sizes(c, transmissibility_level); },
                            {.forms = in_json}),
                  row.lists("isolation_efficiency", "", "", {}, efficiency, {.forms = in_json}),
                  row("highest_in_band", Kind::number, "highest |T| in the band",
                      [&t](std::size_t i) { return t.in_band[i].amplitude; }),
                  row("highest_in_band_at", Kind::frequency, "at",
                      [&t](std::size_t i) { return t.in_band[i].angular_frequency; }),
                  row("level", Kind::number, "level",
                      [&t](std::size_t i) { return transmissibility_level(t.in_band[i].amplitude); },
                      {.unit = "dB", .digits = 4, .forms = for_people}),
                  row("highest", Kind::number, "at any frequency",
                      [&t](std::size_t i) { return t.peaks.curves[i].highest; }, {.forms = in_arrays | for_people}),
                  row("highest_at", Kind::frequency, "at", [&t](std::size_t i) { return t.peaks.curves[i].highest_at; },
                      {.forms = in_arrays | for_people}),
                  row("isolates_from", Kind::frequency, "isolates from", isolates_from),
                  row("last", Kind::number, "at the end of the band", last, {.digits = 4, .forms = for_people}),
                  row("last_level", Kind::number, "level there",
                      [last](const Curve& c) { return transmissibility_level(last(c)); },
                      {.unit = "dB", .digits = 4, .forms = on_page}),
                  row("last_efficiency", Kind::share, "efficiency there", last_efficiency, {.forms = for_people})},
      .arrays = {
          {"result", "name"}, "highest", "highest_at", "highest_in_band", "highest_in_band_at", "isolates_from"}};
}

Table transmissibility_peaks(const response::Peaks& peaks) {
  using response::Peak;
  const Rows row(peaks.list);
  return {
      .key = "peaks",
      .axis = "peak",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "", [&peaks](const Peak& peak) { return peaks.curves[peak.curve].name; }),
                  row("angular_frequency", Kind::frequency, "", &Peak::angular_frequency),
                  row("amplitude", Kind::number, "", &Peak::amplitude),
                  row("nearest_mode", Kind::number, "", &Peak::nearest_mode)},
      .forms = for_programs};
}

/// One curve at one of the single frequencies.
struct TransmittedAt {
  std::size_t curve, place;
};

Table transmitted_at(const TransmissibilityResult& t) {
  std::vector<TransmittedAt> list;
  for (std::size_t i = 0; i < t.at.angular_frequency.size(); ++i)
    for (std::size_t c = 0; c < t.at.curves.size(); ++c) list.push_back({c, i});
  const auto size = [&t](const TransmittedAt& one) {
    return std::abs(t.at.curves[one.curve].value(static_cast<Eigen::Index>(one.place)));
  };
  const auto efficiency = [&t, size](const TransmittedAt& one) {
    return t.is_share(one.curve) ? Json() : Json(isolation_efficiency(size(one)));
  };
  const Rows row(std::move(list));
  return {.key = "at",
          .axis = "single",
          .title = "At single frequencies",
          .rows = row.size(),
          .columns = {row("angular_frequency", Kind::frequency, "f",
                          [&t](const TransmittedAt& one) { return t.at.angular_frequency[one.place]; }),
                      row("name", Kind::words, "result",
                          [&t](const TransmittedAt& one) { return t.at.curves[one.curve].name; }),
                      row("transmissibility", Kind::number, "|T|", size),
                      row("level_db", Kind::number, "level",
                          [size](const TransmittedAt& one) { return transmissibility_level(size(one)); },
                          {.unit = "dB", .digits = 4}),
                      row("isolation", Kind::share, "isolation", efficiency)}};
}

Document transmissibility_document(const project::Case&, const study::CaseResults& results) {
  const TransmissibilityResult& t = *results.transmissibility;
  const std::string shares = t.curves.curves.size() > 1 && t.is_share(1)
      ? "the force of a single mount is only a share; isolation is that of the total force on the ground"
      : "";
  Document document{{{Single{.name = "of", .value = t.words}},
                     {Sentence{.parts = {"Transmissibility: " + t.words}}},
                     {transmissibility_curves(t)},
                     {transmissibility_table(t)},
                     {Sentence{.parts = {shares}, .place = Sentence::Place::note}},
                     {transmissibility_peaks(t.peaks)}}};
  if (!t.at.angular_frequency.empty()) document.add(transmitted_at(t));
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter transmissibility_results = {.document = transmissibility_document,
                                               .files = {"transmissibility.csv"}};

}  // namespace trivet::results
