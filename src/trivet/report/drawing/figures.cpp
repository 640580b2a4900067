// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "trivet/foundation/index.h"
#include "trivet/report/drawing/axis_ticks.h"
#include "trivet/report/drawing/key_lines.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/drawing/plot_panel.h"
#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {
namespace {

/// Position of a panel on the canvas, and its data ranges.
struct Panel {
  double left, top, width, height;
  double x_from, x_to, y_from, y_to;
  bool logarithmic = false;  ///< the ordinate
  PixelPoint at(double x, double y) const {
    const double share = logarithmic ? std::log(std::clamp(y, y_from, y_to) / y_from) / std::log(y_to / y_from)
                                     : (y - y_from) / (y_to - y_from);
    return {left + (x - x_from) / (x_to - x_from) * width, top + height - share * height};
  }
};

/// Amplitudes of curves in several cases.
class Amplitudes {
 public:
  void add(const study::ResponseResult& result, const std::vector<GroupedCurve>& series) {
    for (const GroupedCurve& s : series) {
      std::vector<double>& amplitude = values_.emplace_back();
      for (const auto& value : result.curves.curves[s.curve].value) amplitude.push_back(std::abs(value));
      at_.emplace_back(result.curves.angular_frequency);
    }
  }
  [[nodiscard]] AmplitudeRange range() const {
    std::vector<DrawnAmplitudes> drawn;
    for (std::size_t i = 0; i < at_.size(); ++i) drawn.push_back({at_[i], values_[i]});
    return amplitude_range(drawn);
  }

 private:
  std::vector<std::span<const double>> at_;
  std::vector<std::vector<double>> values_;
};

/// Sets the amplitude axis of a panel: linear from zero, or logarithmic.
void set_amplitude_axis(Panel& panel, const AmplitudeRange& range, double factor) {
  panel.logarithmic = range.is_wide();
  panel.y_from = panel.logarithmic ? 0.8 * factor * range.bottom : 0;
  panel.y_to = (panel.logarithmic ? 1.6 : 1.06) * factor * range.largest;
  if (!(panel.y_to > panel.y_from)) panel.y_to = panel.y_from + 1;
}

std::vector<Tick> amplitude_ticks(const Panel& panel, int wanted) {
  return panel.logarithmic ? decade_ticks(panel.y_from, panel.y_to) : linear_ticks(0, panel.y_to, wanted);
}

/// Along the left side of a panel; a label longer than that in two lines, divided before its unit.
void draw_turned_label(SvgCanvas& canvas, const Panel& p, const std::string& label) {
  constexpr double font = 11, line = 13;
  const std::size_t unit = label.find(" [");
  std::vector<std::string> lines = {label};
  if (unit != std::string::npos && text_width(label, font) > p.height)
    lines = {label.substr(0, unit), label.substr(unit + 1)};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double x = p.left - 40 - line * static_cast<double>(lines.size() - 1 - i), y = p.top + p.height / 2;
    canvas.text({x, y}, lines[i], fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y));
  }
}

/// Frame and ticks. The frequency axis has the unit of the display; the panel has rad/s.
/// @param with_x_label  name the frequency axis
void draw_curve_frame(SvgCanvas& canvas, const Panel& p, const std::vector<Tick>& y_ticks,
                      const project::DisplayUnits& display, bool with_x_label, const std::string& y_label) {
  const double unit = results::shown_frequency(display, 1);
  const std::string x_label = with_x_label ? results::frequency_heading(display) : "";
  const int wanted = std::max(3, static_cast<int>(p.width / 70));
  for (const Tick& tick : linear_ticks(p.x_from * unit, p.x_to * unit, wanted)) {
    const PixelPoint low = p.at(tick.value / unit, p.y_from);
    canvas.line({low.x, p.top}, low, "stroke=\"#e4e4e4\"");
    canvas.text({low.x, low.y + 15}, tick.label, "text-anchor=\"middle\" fill=\"#333\"");
  }
  for (const Tick& tick : y_ticks) {
    const PixelPoint left = p.at(p.x_from, tick.value);
    canvas.line(left, {p.left + p.width, left.y}, "stroke=\"#e4e4e4\"");
    canvas.text({p.left - 6, left.y + 4}, tick.label, "text-anchor=\"end\" fill=\"#333\"");
  }
  canvas.rectangle({p.left, p.top}, p.width, p.height, "fill=\"none\" stroke=\"#333\"");
  if (!x_label.empty()) canvas.text({p.left + p.width / 2, p.top + p.height + 31}, x_label, "text-anchor=\"middle\"");
  draw_turned_label(canvas, p, y_label);
}

/// Strokes of curves with their labels.
std::vector<PanelCurve> key_entries(const std::vector<GroupedCurve>& series) {
  std::vector<PanelCurve> entries;
  for (std::size_t i = 0; i < series.size(); ++i) entries.push_back({{series[i].label}, {}, {}, series_stroke(i)});
  return entries;
}

constexpr double key_room = 15;  // above a panel

/// Above its panel, where it covers no curve.
void draw_key_above(SvgCanvas& canvas, const Panel& p, const std::vector<GroupedCurve>& series) {
  KeyLines key(p.width);
  key.add(key_entries(series));
  key.draw(canvas, {p.left, p.top - 4 - key.height()});
}

/// The parts of a curve between the lower and upper edge of its panel, cut at the edges.
std::vector<std::vector<PixelPoint>> pieces_of_curve(const Panel& p, const std::vector<double>& x,
                                                     const Eigen::VectorXd& y) {
  const auto height = [&](double value) { return p.logarithmic ? std::log(value) : value; };
  const auto inside = [&](double value) { return value >= p.y_from && value <= p.y_to; };
  std::vector<std::vector<PixelPoint>> pieces(1);
  for (Eigen::Index k = 0; k < y.size(); ++k) {
    const auto i = to_size(k);
    const bool crosses = k > 0 && inside(y(k)) != inside(y(k - 1)) && std::isfinite(y(k)) && std::isfinite(y(k - 1)) &&
        !(p.logarithmic && std::min(y(k), y(k - 1)) <= 0);
    if (crosses) {
      const double edge = std::max(y(k), y(k - 1)) > p.y_to ? p.y_to : p.y_from;
      const double share = (height(edge) - height(y(k - 1))) / (height(y(k)) - height(y(k - 1)));
      pieces.back().push_back(p.at(x[i - 1] + share * (x[i] - x[i - 1]), edge));
    }
    if (inside(y(k))) pieces.back().push_back(p.at(x[i], y(k)));
    else if (!pieces.back().empty()) pieces.emplace_back();
  }
  return pieces;
}

void draw_amplitudes(SvgCanvas& canvas, const Panel& p, const study::CaseResults& results,
                     const std::vector<GroupedCurve>& series, double factor) {
  const auto& omega = results.response->curves.angular_frequency;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto& values = results.response->curves.curves[series[i].curve].value;
    for (const auto& piece : pieces_of_curve(p, omega, factor * values.cwiseAbs()))
      canvas.polyline(piece, series_stroke(i));
    if (!results.peaks) continue;
    for (const response::Peak& peak : results.peaks->peaks.list) {
      const bool mine =
          results.peaks->peaks.curves[peak.curve].name == results.response->curves.curves[series[i].curve].name;
      if (mine && peak.angular_frequency >= p.x_from && peak.angular_frequency <= p.x_to &&
          factor * peak.amplitude <= p.y_to && factor * peak.amplitude >= p.y_from)
        canvas.circle(p.at(peak.angular_frequency, factor * peak.amplitude), 3,
                      fmt::format("fill=\"white\" stroke=\"{}\" stroke-width=\"1.4\"", series_colour(i)));
    }
  }
  for (const study::LimitResult& limit : results.limits)
    for (std::size_t i = 0; i < series.size(); ++i)
      if (limit.name == results.response->curves.curves[series[i].curve].name && factor * limit.limit <= p.y_to &&
          factor * limit.limit >= p.y_from) {
        canvas.line(p.at(p.x_from, factor * limit.limit), p.at(p.x_to, factor * limit.limit),
                    "stroke=\"#b00020\" stroke-width=\"1.2\" stroke-dasharray=\"10,4\"");
        canvas.text({p.left + p.width * 0.45, p.at(0, factor * limit.limit).y - 4}, "limit " + series[i].label,
                    "fill=\"#b00020\" text-anchor=\"middle\" paint-order=\"stroke\" stroke=\"white\" "
                    "stroke-width=\"4\" stroke-linejoin=\"round\"");
      }
}

void draw_phases(SvgCanvas& canvas, const Panel& p, const study::CaseResults& results,
                 const std::vector<GroupedCurve>& series) {
  const auto& omega = results.response->curves.angular_frequency;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Eigen::VectorXd& phase = results.response->phase[series[i].curve];
    std::vector<PixelPoint> points;
    double last = 0;
    for (std::size_t k = 0; k < omega.size(); ++k) {
      const double degrees = phase(to_index(k)) * 180 / std::numbers::pi;
      if (!std::isfinite(degrees)) continue;
      if (!points.empty() && std::abs(degrees - last) > 270) {  // the phase wraps at ±180°
        canvas.polyline(points, series_stroke(i));
        points.clear();
      }
      points.push_back(p.at(omega[k], degrees));
      last = degrees;
    }
    canvas.polyline(points, series_stroke(i));
  }
}

std::pair<double, double> phase_range(const study::CaseResults& results, const std::vector<GroupedCurve>& series) {
  double low = -180, high = 180;
  for (const GroupedCurve& s : series)
    for (const double phase : results.response->phase[s.curve])
      if (std::isfinite(phase)) {
        low = std::min(low, std::floor(phase * 180 / std::numbers::pi / 90 + 1e-9) * 90);
        high = std::max(high, std::ceil(phase * 180 / std::numbers::pi / 90 - 1e-9) * 90);
      }
  return {low, high};
}

std::string quantity_of(const study::ResponseResult& result, const std::vector<GroupedCurve>& series) {
  return quantity_name(result.curves.curves[series.front().curve].unit);
}

/// Adds the amplitudes of all curves, to find the largest of each kind.
void add_amplitudes(const study::ResponseResult& result, results::LargestOfKind& largest) {
  for (const response::Curve& curve : result.curves.curves)
    for (const auto& value : curve.value) largest.add(curve.unit, std::abs(value));
}

/// A panel of curves that are round-off has no prefix.
UnitPrefix amplitude_prefix(double largest, const results::LargestOfKind& of_kind, const study::CaseResults& results,
                            const std::vector<GroupedCurve>& series) {
  const std::string& unit = results.response->curves.curves[series.front().curve].unit;
  return unit_prefix(of_kind.shown(unit, largest), results::amplitude_unit(results.display, unit));
}

bool is_drawable(const study::CaseResults& results) {
  return results.response && results.response->curves.angular_frequency.size() >= 2;
}

/// The case with the same curves as the base model (for example the first of a series), if there is one.
const study::CaseResults* repeating_case(const std::vector<study::CaseResults>& cases) {
  const auto base = std::ranges::find_if(
      cases, [](const study::CaseResults& results) { return results.case_name.empty() && is_drawable(results); });
  if (base == cases.end()) return nullptr;
  const auto same = [](const response::Curve& a, const response::Curve& b) {
    return a.name == b.name && a.value.size() == b.value.size() && a.value == b.value;
  };
  const auto& curves = base->response->curves.curves;
  const auto found = std::ranges::find_if(cases, [&](const study::CaseResults& other) {
    if (&other == &*base || !is_drawable(other) ||
        other.response->curves.angular_frequency != base->response->curves.angular_frequency)
      return false;
    const auto& others = other.response->curves.curves;
    return std::equal(curves.begin(), curves.end(), others.begin(), others.end(), same);
  });
  return found == cases.end() ? nullptr : &*found;
}

/// Strokes of the first groups of all cases; translations and rotations have the same: "x, θx".
KeyLines common_key(const std::vector<const study::CaseResults*>& cases, double width) {
  KeyLines key(width);
  for (const study::CaseResults* results : cases) {
    const CurveGroup group = curve_groups(curve_names(results->response->curves.curves)).front();
    std::vector<PanelCurve> entries = key_entries(group.upper);
    for (const PanelCurve& lower : key_entries(group.lower)) {
      const auto same = std::ranges::find(entries, lower.stroke, &PanelCurve::stroke);
      if (same == entries.end()) entries.push_back(lower);
      else same->key.push_back(lower.key.front());
    }
    key.add(entries);
  }
  return key;
}

Figure group_figure(const study::CaseResults& results, const results::LargestOfKind& of_kind, const CurveGroup& group) {
  const study::ResponseResult& result = *results.response;
  const double row_height = 200, panel_width = 400;
  std::vector<const std::vector<GroupedCurve>*> rows;
  for (const auto* series : {&group.upper, &group.lower})
    if (!series->empty()) rows.push_back(series);
  constexpr double head = 50, below = 52;
  SvgCanvas canvas(980, head + 6 + static_cast<double>(rows.size()) * (row_height + below));
  const std::string title = group.name + (results.case_name.empty() ? "" : ", " + results.case_name);
  canvas.text({490, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<GroupedCurve>& series = *rows[r];
    const double top = head + static_cast<double>(r) * (row_height + below);
    const AmplitudeRange range = drawn_range(result, series);
    const UnitPrefix unit = amplitude_prefix(range.largest, of_kind, results, series);
    Panel amplitude{66, top, panel_width, row_height, result.band.from, result.band.to, 0, 1};
    set_amplitude_axis(amplitude, range, unit.factor);
    draw_curve_frame(
        canvas, amplitude, amplitude_ticks(amplitude, 5), results.display, true,
        fmt::format("{} [{}]{}", quantity_of(result, series), unit.unit, amplitude.logarithmic ? ", log" : ""));
    draw_amplitudes(canvas, amplitude, results, series, unit.factor);
    draw_key_above(canvas, amplitude, series);
    const auto [low, high] = phase_range(results, series);
    const Panel phase{556, top, panel_width, row_height, result.band.from, result.band.to, low, high};
    draw_curve_frame(canvas, phase, angle_ticks(low, high), results.display, true, "phase [°]");
    draw_phases(canvas, phase, results, series);
  }
  return {title, file_part(group.name) + ".svg", canvas.svg("Amplitude and phase of " + title)};
}

}  // namespace

AmplitudeRange drawn_range(const study::ResponseResult& result, const std::vector<GroupedCurve>& series) {
  Amplitudes amplitudes;
  amplitudes.add(result, series);
  return amplitudes.range();
}

std::string Figure::html() const {
  return strips.empty() ? svg : std::accumulate(strips.begin(), strips.end(), std::string());
}

std::vector<Figure> characteristics(const study::CaseResults& results) {
  std::vector<Figure> result;
  if (!is_drawable(results)) return result;
  results::LargestOfKind of_kind;
  add_amplitudes(*results.response, of_kind);
  for (const CurveGroup& group : curve_groups(curve_names(results.response->curves.curves))) {
    result.push_back(group_figure(results, of_kind, group));
    // Numbered, because different names may give the same safe file name.
    result.back().file_name = fmt::format("{:02}-{}", result.size(), result.back().file_name);
  }
  return result;
}

Figure overview(const std::string& title, const std::vector<study::CaseResults>& cases) {
  constexpr std::size_t columns = 3, most_cases = 12;
  constexpr double left_room = 70;
  const double width = 270, height = 120, column_pitch = 340;
  const study::CaseResults* const as_base = repeating_case(cases);
  std::vector<const study::CaseResults*> shown;
  for (const study::CaseResults& results : cases)
    if (is_drawable(results) && shown.size() < most_cases && !(results.case_name.empty() && as_base))
      shown.push_back(&results);
  const std::size_t used_columns = std::max<std::size_t>(1, std::min(columns, shown.size()));
  const std::size_t rows = (shown.size() + columns - 1) / columns;
  const double canvas_width =
      std::max(36 + column_pitch * static_cast<double>(used_columns), 40 + 9.0 * static_cast<double>(title.size()));
  const bool one_panel_each = std::ranges::all_of(shown, [](const study::CaseResults* results) {
    return curve_groups(curve_names(results->response->curves.curves)).front().lower.empty();
  });
  const KeyLines key = common_key(shown, canvas_width - left_room - 20);
  const bool are_keys_above = key.is_ambiguous();  // of the panels: their strokes mean different curves
  const double head = 44 + (are_keys_above ? 0 : key.height()), above = are_keys_above ? key_room : 0;
  const double panel_pitch = height + above + 28, row_pitch = (one_panel_each ? 1 : 2) * panel_pitch + 54;
  SvgCanvas canvas(canvas_width, head + row_pitch * static_cast<double>(rows));
  canvas.text({canvas_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"15\" font-weight=\"bold\"");
  if (!are_keys_above) key.draw(canvas, {left_room, 34});
  // One scale for all, so that the cases can be compared.
  std::array<Amplitudes, 2> amplitudes;
  results::LargestOfKind of_kind;
  for (const study::CaseResults* results : shown) {
    add_amplitudes(*results->response, of_kind);
    const CurveGroup group = curve_groups(curve_names(results->response->curves.curves)).front();
    amplitudes[0].add(*results->response, group.upper);
    amplitudes[1].add(*results->response, group.lower);
  }
  const std::array<AmplitudeRange, 2> ranges = {amplitudes[0].range(), amplitudes[1].range()};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const study::CaseResults& results = *shown[i];
    const CurveGroup group = curve_groups(curve_names(results.response->curves.curves)).front();
    const std::size_t row = i / columns, column = i % columns;
    if (row > 0 && column == 0) canvas.permit_break(head + row_pitch * static_cast<double>(row));
    const double left = left_room + column_pitch * static_cast<double>(column),
                 top = head + 22 + above + row_pitch * static_cast<double>(row);
    const std::string name = (results.case_name.empty() ? "Base model" : results.case_name) +
        (&results == as_base ? " = base model: " : ": ") + group.name;
    constexpr double font = 12, wider = 1.12;  // bold letters
    const double size = font * std::min(1.0, (width + 50) / (wider * text_width(name, font)));
    canvas.text({left + width / 2, top - 8 - above}, name,
                fmt::format("text-anchor=\"middle\" font-size=\"{:.1f}\" font-weight=\"bold\"", size));
    for (const auto& [series, part] : {std::pair{&group.upper, 0}, std::pair{&group.lower, 1}}) {
      if (series->empty()) continue;
      const AmplitudeRange& range = ranges[part];
      const UnitPrefix unit = amplitude_prefix(range.largest, of_kind, results, *series);
      Panel panel{
          left, top + part * panel_pitch, width, height, results.response->band.from, results.response->band.to, 0, 1};
      set_amplitude_axis(panel, range, unit.factor);
      draw_curve_frame(canvas, panel, amplitude_ticks(panel, 4), results.display, part == 1 || group.lower.empty(),
                       fmt::format("{} [{}]{}", quantity_of(*results.response, *series), unit.unit,
                                   panel.logarithmic ? ", log" : ""));
      draw_amplitudes(canvas, panel, results, *series, unit.factor);
      if (are_keys_above) draw_key_above(canvas, panel, *series);
    }
  }
  const std::string description = "Amplitude characteristics of " + title;
  return {title, "overview.svg", canvas.svg(description), canvas.strips(description)};
}

}  // namespace trivet::report
