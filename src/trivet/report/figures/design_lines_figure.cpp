// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/design_lines_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/report/drawing/key_lines.h"
#include "trivet/report/drawing/label_placement.h"
#include "trivet/report/figures/design_axes.h"
#include "trivet/results/design/sample_words.h"

namespace trivet::report {
namespace {

using study::KeptDesign;
using study::KeptDesigns;
using study::Sample;

constexpr double lines_width = 980, axis_left = 300, axis_width = 640, axis_distance = 50, stub = 8, group_gap = 24,
                 above_axes = 40, name_right = axis_left - 18, name_room = name_right - 10, note_height = 15,
                 tick_size = 10.5;
constexpr const char *axis_class = "design-axis", *met_colour = "#0072B2", *violated_colour = "#D55E00",
                     *unjudged_colour = "#555555", *axis_colour = "#222222", *limit_colour = "#a00020";
constexpr const char *of_worst = "stroke=\"#000000\" stroke-width=\"2.2\"",
                     *of_file = "stroke=\"#000000\" stroke-width=\"1.6\" stroke-dasharray=\"6,4\"";

/// Lines of at most a width, broken at spaces.
std::vector<std::string> broken(const std::string& text, double width, double size) {
  std::vector<std::string> lines = {""};
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, to - from);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || text_width(longer, size) <= width) lines.back() = longer;
    else lines.push_back(word);
    from = to + 1;
  }
  return lines;
}

/// What kind of design a line is, and how it is drawn.
struct LineKind {
  const char *verdict, *colour;
  double opacity = 1;
  std::size_t first = 0, further = 0;  ///< designs

  [[nodiscard]] std::string stroke() const {
    return fmt::format("stroke=\"{}\" stroke-width=\"2\"{}", colour,
                       std::string_view(verdict) == "unjudged" ? " stroke-dasharray=\"2,3\"" : "");
  }
};

std::string_view verdict_of(const KeptDesign& one) {
  return !one.is_judged() ? "unjudged" : one.is_met() ? "met" : "violated";
}
bool is_further(const KeptDesign& one) { return one.number >= KeptDesigns::first; }

/// Kinds with their counts, in the order in which they are drawn: the most frequent ones below.
std::vector<LineKind> line_kinds(const Sample& sample) {
  std::vector<LineKind> kinds = {{"met", met_colour}, {"violated", violated_colour}, {"unjudged", unjudged_colour}};
  for (LineKind& kind : kinds) {
    for (const KeptDesign& one : sample.kept.list)
      if (verdict_of(one) == kind.verdict) ++(is_further(one) ? kind.further : kind.first);
    constexpr double inked = 45, least = 0.16, most = 0.75;  // so many lines in full ink give a picture its tone
    kind.opacity =
        std::clamp(inked / static_cast<double>(std::max<std::size_t>(1, kind.first + kind.further)), least, most);
  }
  std::ranges::stable_sort(kinds, std::ranges::greater(), [](const LineKind& one) { return one.first + one.further; });
  return kinds;
}

/// The picture while it is drawn.
class LinesPicture {
 public:
  LinesPicture(const Sample& sample, const DesignLinesAxes& axes)
      : sample_(sample), axes_(axes), kinds_(line_kinds(sample)), key_(lines_width - 60) {
    for (const char* verdict : {"met", "violated", "unjudged"})
      add_to_key(*std::ranges::find(kinds_, std::string_view(verdict),
                                    [](const LineKind& one) { return std::string_view(one.verdict); }));
    key_.add({{{"design of the file"}, {}, {}, of_file}});
    if (sample.worst) key_.add({{{fmt::format("least margin: design {}", sample.worst->number)}, {}, {}, of_worst}});
    double y = 42 + key_.height() + above_axes;
    for (const DesignLinesAxis& one : axes.numbers) place(one, y);
    if (!axes.numbers.empty() && !axes.margins.empty()) y += group_gap;
    for (const DesignLinesAxis& one : axes.margins) place(one, y);
    for (const std::string& note : notes())
      for (std::string& line : broken(note, lines_width - 60, 11)) note_lines_.push_back(std::move(line));
    notes_top_ = y - 18;
    height_ = notes_top_ + note_height * static_cast<double>(note_lines_.size()) + 16;
  }

  [[nodiscard]] std::string svg(const std::string& title) const {
    SvgCanvas canvas(lines_width, height_);
    canvas.text({lines_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
    key_.draw(canvas, {30, 36});
    for (const LineKind& kind : kinds_)
      for (const bool further : {false, true}) draw_lines(canvas, kind, further);
    draw_marked(canvas);
    draw_headings(canvas);
    for (const PlacedAxis& one : placed_) draw_axis(canvas, one);
    double y = notes_top_ + 6;
    for (const std::string& line : note_lines_) canvas.text({30, y += note_height}, line, "fill=\"#444\"");
    return canvas.svg(title);
  }

 private:
  struct PlacedAxis {
    const DesignLinesAxis* axis;
    double y;
  };

  void place(const DesignLinesAxis& axis, double& y) {
    placed_.push_back({&axis, y});
    y += axis_distance;
  }

  void add_to_key(const LineKind& kind) {
    if (kind.first + kind.further == 0) return;
    const std::string_view verdict = kind.verdict;
    std::string words = verdict == "met" ? "meets every requirement"
        : verdict == "violated"          ? "violates at least one"
                                         : "cannot be judged";
    words += fmt::format(": {} of the first {}", kind.first, first_designs());
    if (kind.further > 0) words += fmt::format(", {} later", kind.further);
    key_.add({{{words}, {}, {}, kind.stroke()}});
  }

  [[nodiscard]] std::size_t first_designs() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(sample_.kept.list, [](const KeptDesign& one) { return !is_further(one); }));
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> list = {
        fmt::format("A line is a design. The first {} designs are a sample of all {}; their numbers are in JSON.",
                    first_designs(), sample_.request.designs)};
    const bool later = std::ranges::any_of(kinds_, [](const LineKind& one) { return one.further > 0; });
    if (later)
      list.front() += fmt::format(
          " Later ones are drawn because they do not meet all requirements (the first {} of them), or have the least "
          "or the largest margin.",
          KeptDesigns::failing);
    list.insert(list.end(), axes_.notes.begin(), axes_.notes.end());
    return list;
  }

  /// Until the first axis on which the design has no value.
  template <typename Value>
  [[nodiscard]] std::vector<PixelPoint> line(const Value& value) const {
    std::vector<PixelPoint> points;
    for (const PlacedAxis& one : placed_) {
      const double at = value(*one.axis);
      if (std::isnan(at)) break;
      points.push_back({x_of(*one.axis, at), one.y});
    }
    if (points.size() == 1) points.push_back({points[0].x, points[0].y + stub});  // a line of one point is not seen
    return points;
  }
  static double x_of(const DesignLinesAxis& axis, double value) { return axis_left + axis_width * axis.share(value); }

  void draw_lines(SvgCanvas& canvas, const LineKind& kind, bool further) const {
    if ((further ? kind.further : kind.first) == 0) return;
    canvas.begin_group(fmt::format("data-verdict=\"{}\"{} {} stroke-opacity=\"{:.2f}\"", kind.verdict,
                                   further ? " data-further=\"\"" : "", kind.stroke(), kind.opacity));
    for (std::size_t i = 0; i < sample_.kept.list.size(); ++i) {
      const KeptDesign& one = sample_.kept.list[i];
      if (verdict_of(one) != kind.verdict || is_further(one) != further) continue;
      canvas.polyline(line([i](const DesignLinesAxis& axis) { return axis.values[i]; }), "stroke-width=\"1.1\"");
    }
    canvas.end_group();
  }

  void draw_marked(SvgCanvas& canvas) const {
    canvas.polyline(line([](const DesignLinesAxis& axis) { return axis.given; }), of_file);
    if (!sample_.worst) return;
    const auto worst = std::ranges::find(sample_.kept.list, sample_.worst->number, &KeptDesign::number);
    if (worst == sample_.kept.list.end()) return;
    const auto i = static_cast<std::size_t>(worst - sample_.kept.list.begin());
    canvas.polyline(line([i](const DesignLinesAxis& axis) { return axis.values[i]; }), of_worst);
  }

  void draw_headings(SvgCanvas& canvas) const {
    const auto heading = [&](double axis_y, const char* words) {
      canvas.text({30, axis_y - 22}, words, "font-weight=\"bold\" font-size=\"12\"");
    };
    if (!axes_.numbers.empty()) heading(placed_.front().y, "Drawn numbers");
    if (!axes_.margins.empty()) heading(placed_[axes_.numbers.size()].y, "Margins: red is the limit 1, more is met");
  }

  /// Its name as it is read out: with the detail if the name does not say which axis it is.
  [[nodiscard]] std::string spoken_name(const DesignLinesAxis& axis) const {
    const bool is_ambiguous = std::ranges::count(axes_.numbers, axis.name, &DesignLinesAxis::name) > 1;
    return axis.detail.empty() || !(axis.of_margins || is_ambiguous) ? axis.name : axis.name + " " + axis.detail;
  }

  void draw_axis(SvgCanvas& canvas, const PlacedAxis& placed) const {
    const DesignLinesAxis& axis = *placed.axis;
    const double y = placed.y, right = axis_left + axis_width;
    canvas.line(
        {axis_left, y}, {right, y},
        fmt::format(
            "class=\"{}\" stroke=\"#222\" stroke-width=\"1.4\" data-name=\"{}\" data-unit=\"{}\" data-from=\"{}\" "
            "data-to=\"{}\" data-end=\"{}\"{}",
            axis_class, escaped(spoken_name(axis)), escaped(axis.unit), axis.scale.from, axis.scale.to,
            axis.end_of_scale(), axis.scale.logarithmic ? " data-logarithmic=\"\"" : ""));
    draw_name(canvas, y, axis);
    std::vector<Box> taken;
    const auto tick = [&](double value, const std::string& label, const char* colour, double anchor = 0.5) {
      const double x = x_of(axis, value), width = text_width(label, tick_size) + 8, start = x - anchor * width;
      const Box box{start, y, start + width, y + 1};
      if (std::ranges::any_of(taken, [&](const Box& one) { return one.overlaps(box); })) return;
      taken.push_back(box);
      canvas.line({x, y - 4}, {x, y + 4}, fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", colour));
      canvas.text({start + width / 2, y + 17}, label,
                  fmt::format("text-anchor=\"middle\" font-size=\"{}\" fill=\"{}\" stroke=\"#fff\" stroke-width=\"3\" "
                              "paint-order=\"stroke\"",
                              tick_size, colour));
    };
    const double size = std::max(std::abs(axis.scale.from), std::abs(axis.scale.to));
    const int digits =
        std::clamp(static_cast<int>(std::ceil(3 + std::log10(size / (axis.scale.to - axis.scale.from)))), 4, 12);
    const auto end_words = [digits](double value) { return fmt::format("{:.{}g}", value, digits); };
    tick(axis.scale.from, end_words(axis.scale.from), axis_colour, 0);
    if (axis.has_infinite) tick(foundation::infinity, "∞", axis_colour, 1);
    tick(axis.scale.to, end_words(axis.scale.to), axis_colour, axis.has_infinite ? 0.5 : 1);
    if (axis.of_margins && axis.scale.from <= 1 && axis.scale.to >= 1) {
      const double x = x_of(axis, 1);
      canvas.line({x, y - 9}, {x, y + 9}, fmt::format("stroke=\"{}\" stroke-width=\"3\"", limit_colour));
      tick(1, "1", limit_colour);
    }
    for (const Tick& one : axis.scale.ticks(6))
      if (!one.label.empty()) tick(one.value, one.label, axis_colour);
  }

  static void draw_name(SvgCanvas& canvas, double y, const DesignLinesAxis& axis) {
    const std::string unit = axis.unit.empty() ? "" : " [" + axis.unit + "]";
    canvas.text({name_right, y - (axis.detail.empty() ? -4 : 2)},
                fitting(axis.name, name_room - 6.5 * static_cast<double>(unit.size()), 12) + unit,
                "text-anchor=\"end\" font-size=\"12\"");
    if (!axis.detail.empty())
      canvas.text({name_right, y + 12}, fitting(axis.detail, name_room, 10.5),
                  "text-anchor=\"end\" font-size=\"10.5\" fill=\"#555\"");
  }

  const Sample& sample_;
  const DesignLinesAxes& axes_;
  std::vector<LineKind> kinds_;
  KeyLines key_;
  std::vector<PlacedAxis> placed_;
  std::vector<std::string> note_lines_;
  double notes_top_ = 0, height_ = 0;
};

}  // namespace

std::optional<Figure> design_lines_figure(const Sample& sample, const std::optional<project::DisplayUnits>& display) {
  const DesignLinesAxes axes = design_lines_axes(sample, display);
  if (axes.numbers.size() + axes.margins.size() < 2) return std::nullopt;
  const std::string title = "Designs: drawn numbers and margins";
  return Figure{title, "designs.svg", LinesPicture(sample, axes).svg(title)};
}

bool has_design_lines(const std::string& page) {
  return page.find(fmt::format("class=\"{}\"", axis_class)) != std::string::npos;
}

}  // namespace trivet::report
