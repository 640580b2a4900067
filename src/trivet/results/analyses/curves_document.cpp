// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/curves_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/project/text/display_units.h"
#include "trivet/project/text/level.h"
#include "trivet/results/format/quantity_name.h"
#include "trivet/results/format/result_writer.h"

namespace trivet::results {
namespace {

using response::CurveModel;
using response::Peak;
using study::CaseResults;

/// With the level at which amplitudes are shown, so that a program that draws them does not choose another one.
Json drawn_results(const study::ResponseResult& found, const project::DisplayUnits& display) {
  Json list = Json::array();
  for (std::size_t c = 0; c < found.curves.curves.size(); ++c) {
    const std::string& unit = found.curves.curves[c].unit;
    Json& result = list.emplace_back(json::drawn_curve(found, c));
    result["kind"] = quantity_name(unit);
    const bool has_level = !documents::amplitude_unit(display, unit).level.empty();
    const project::Level level = project::shown_level(display, unit);
    result["level"] = has_level ? Json(project::level_ending(level)) : Json(nullptr);
    result["level_factor"] = has_level ? project::level_factor(level) : 1;
  }
  return list;
}

Json drawn_models(const project::Case& variant, const study::ResponseResult& found) {
  Json model{{"excitations", excited_names(variant, "response")}};
  model.update(json::curve_model(found));
  return Json::array({std::move(model)});
}

/// Phase of a curve at the frequency of its peak; none outside the model, and where it is not defined.
std::optional<double> phase_at(const CurveModel& model, const Peak& peak) {
  const Eigen::VectorXcd values = model.at({peak.angular_frequency});
  const std::complex<double> value = values(static_cast<Eigen::Index>(peak.curve));
  return std::isfinite(std::abs(value)) && value != 0.0 ? std::optional(std::arg(value)) : std::nullopt;
}

Json exact_peaks(const CaseResults& results) {
  Json list = Json::array();
  if (!results.peaks) return list;
  const response::Peaks& found = results.peaks->peaks;
  for (const Peak& peak : found.list)
    list.push_back({{"result", found.curves[peak.curve].name},
                    {"angular_frequency", peak.angular_frequency},
                    {"amplitude", json::number(peak.amplitude)},
                    {"phase", json::optional(phase_at(*results.response->model, peak))},
                    {"nearest_mode", json::optional(peak.nearest_mode)},
                    {"unbounded", std::isinf(peak.amplitude)}});
  return list;
}

/// Results that are round-off of their load at all frequencies.
Json names_of_vanishing(const CaseResults& results) {
  Json list = Json::array();
  if (!results.peaks) return list;
  for (const response::CurveSummary& curve : results.peaks->peaks.curves)
    if (curve.vanishes) list.push_back(curve.name);
  return list;
}

Json natural_frequencies(const CaseResults& results) {
  std::vector<double> list;
  for (const modal::Mode& mode : results.modes.list)
    if (mode.angular_frequency.value_or(0) > 0) list.push_back(*mode.angular_frequency);
  return json::list(list);
}

Json drawn_limits(const CaseResults& results) {
  Json list = Json::array();
  for (const study::LimitResult& limit : results.limits)
    list.push_back({{"result", limit.name},
                    {"unit", limit.unit},
                    {"limit", limit.limit},
                    {"in_band", json::number(limit.in_band)},
                    {"in_band_at", limit.in_band_at},
                    {"met", limit.met}});
  return list;
}

Json drawn_lines(const CaseResults& results) {
  Json list = Json::array();
  for (const study::LimitLineResult& one : results.limit_lines) {
    Json exceeded = Json::array();
    for (const assembly::Band& band : one.comparison.exceeded) exceeded.push_back({band.from, band.to});
    list.push_back({{"name", one.line.name},
                    {"result", one.of},
                    {"unit", one.line.unit},
                    {"rms", one.line.rms},
                    {"angular_frequency", json::list(one.line.angular_frequency)},
                    {"limit", json::list(one.line.limit)},
                    {"least_margin", json::number(one.comparison.least_margin)},
                    {"at", one.comparison.least_margin_at},
                    {"exceeded", std::move(exceeded)}});
  }
  return list;
}

/// The largest amplitude of a curve in the band: at one of its ends or at a maximum.
struct Highest {
  std::string name, unit;
  double amplitude = 0, at = 0;
};

std::vector<Highest> highest_in_band(const study::ResponseResult& found) {
  const CurveModel& model = *found.model;
  const Eigen::MatrixXcd ends = model.at({model.band.from, model.band.to});
  std::vector<Highest> list;
  for (std::size_t c = 0; c < found.curves.curves.size(); ++c) {
    Highest highest{found.curves.curves[c].name, found.curves.curves[c].unit};
    const auto include = [&](double omega, double amplitude) {
      if (std::isfinite(amplitude) && amplitude > highest.amplitude) highest.amplitude = amplitude, highest.at = omega;
    };
    for (const response::Extremum& extremum : found.extrema[c])
      if (extremum.maximum) include(extremum.angular_frequency, extremum.amplitude);
    include(model.band.from, std::abs(ends(static_cast<Eigen::Index>(c), 0)));
    include(model.band.to, std::abs(ends(static_cast<Eigen::Index>(c), 1)));
    list.push_back(highest);
  }
  return list;
}

Table highest_table(const study::ResponseResult& found) {
  const Rows row(highest_in_band(found));
  return {.title = "Characteristics",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "result", &Highest::name), row("unit", Kind::words, "", &Highest::unit),
                      row("amplitude", Kind::amplitude, "largest in the band", &Highest::amplitude),
                      row("at", Kind::frequency, "at", &Highest::at)},
          .forms = for_people};
}

Sentence model_sentence(const study::ResponseResult& found) {
  const CurveModel& model = *found.model;
  Eigen::Index nodes = 0;
  for (const response::ModelPiece& piece : model.pieces) nodes += piece.fit.nodes.size();
  return {.parts = {"Rational model from ", Quantity{model.band.from, "rad/s", Kind::frequency}, " to ",
                    Quantity{model.band.to, "rad/s", Kind::frequency},
                    fmt::format(": {} nodes in {} piece{} from {} solves; largest relative error at {} tested "
                                "frequencies {:.1e}; --json has it",
                                nodes, model.pieces.size(), model.pieces.size() == 1 ? "" : "s", model.solves,
                                model.tests, model.worst_error)}};
}

}  // namespace

Document curves_document(const project::Case& variant, const CaseResults& results) {
  const study::ResponseResult& found = *results.response;
  const CurveModel& model = *found.model;
  Document document;
  document.add(Single{"band", {model.band.from, model.band.to}});
  document.add(Single{"results", drawn_results(found, results.display)});
  document.add(Single{"vanishing", names_of_vanishing(results)});
  document.add(Single{"models", drawn_models(variant, found)});
  document.add(Single{"peaks", exact_peaks(results)});
  document.add(Single{"natural", natural_frequencies(results)});
  document.add(Single{"limits", drawn_limits(results)});
  document.add(Single{"lines", drawn_lines(results)});
  document.add(Single{"interpolation_error", model.worst_error});
  document.add(Single{"solves", model.solves});
  document.add(highest_table(found));
  document.add(model_sentence(found));
  document.add(warnings_part(results));
  return document;
}

}  // namespace trivet::results
