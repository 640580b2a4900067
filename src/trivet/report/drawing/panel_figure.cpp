// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/panel_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>

#include "trivet/report/drawing/svg_canvas.h"

namespace trivet::report {
namespace {

constexpr double canvas_width = 980, title_height = 40, key_line = 15, between_keys = 5;

constexpr double widest_text = 36;  // characters that fit next to a panel

double key_height(const std::vector<PanelCurve>& curves) {
  double height = 0;
  for (const PanelCurve& curve : curves)
    if (!curve.key.empty()) height += key_line * static_cast<double>(curve.key.size()) + between_keys;
  return height;
}

void draw_title(SvgCanvas& canvas, const std::string& title) {
  canvas.text({canvas_width / 2, 22}, title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"bold\"");
}

Figure one_panel(const std::string& title, const std::string& file_name, const PanelRow& row) {
  constexpr double left = 78, width = 640, height = 150, below = 46, to_key = 18;
  SvgCanvas canvas(canvas_width, title_height + std::max(height + below, key_height(row.curves) + 16));
  draw_title(canvas, title);
  draw_row(canvas, {{left, title_height}, width, height, row.x, row.y}, row);
  draw_key(canvas, {left + width + to_key, title_height}, row.curves);
  return {title, file_name, canvas.svg(title)};
}

/// Strokes with their texts in lines of a limited width.
class KeyLines {
 public:
  explicit KeyLines(double width) : width_(width) {}

  void add(const std::vector<PanelCurve>& curves) {
    for (const PanelCurve& curve : curves) {
      if (curve.key.empty()) continue;
      std::string text;
      for (const std::string& line : curve.key) text += (text.empty() ? "" : ", ") + line;
      const auto [known, is_new] = texts_.emplace(curve.stroke, text);
      if (is_new) entries_.push_back({curve.stroke, text, place(text)});
      else if (known->second != text) is_ambiguous_ = true;
    }
  }
  [[nodiscard]] bool is_ambiguous() const { return is_ambiguous_; }  ///< has one stroke two meanings?
  [[nodiscard]] double height() const { return entries_.empty() ? 0 : last_.y + line_height; }

  void draw(SvgCanvas& canvas, PixelPoint corner) const {
    for (const Entry& entry : entries_) {
      const PixelPoint at{corner.x + entry.at.x, corner.y + entry.at.y + 7};
      const double sample = sample_width(entry.stroke);
      if (sample > 0) canvas.line(at, {at.x + sample, at.y}, entry.stroke);
      canvas.text({at.x + (sample > 0 ? sample + 5 : 0), at.y + 4}, entry.text, "");
    }
  }

 private:
  struct Entry {
    std::string stroke, text;
    PixelPoint at;
  };
  static constexpr double line_height = 15, gap = 16;

  static double sample_width(const std::string& stroke) { return stroke.empty() ? 0 : 24; }
  /// Where the next entry begins, in a new line if this one has no room for it.
  PixelPoint place(const std::string& text) {
    constexpr double of_letter = 5.9;
    const auto letters =
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    const double wide = 29 + of_letter * static_cast<double>(letters);
    if (last_.x > 0 && last_.x + wide > width_) last_ = {0, last_.y + line_height};
    const PixelPoint at = last_;
    last_.x += wide + gap;
    return at;
  }

  double width_;
  std::map<std::string, std::string> texts_;
  std::vector<Entry> entries_;
  PixelPoint last_;
  bool is_ambiguous_ = false;
};

KeyLines key_of(const std::vector<PanelRow>& panels, double width) {
  KeyLines key(width);
  for (const PanelRow& panel : panels) key.add(panel.curves);
  return key;
}

Figure grid(const std::string& title, const std::string& file_name, const std::vector<PanelRow>& panels) {
  constexpr double left = 64, right = 14, below = 44, name_height = 18, to_panel = 6;
  const KeyLines common = key_of(panels, canvas_width - left - right);
  const std::size_t columns = panels.size() > 2 && !common.is_ambiguous() ? 3 : 2;
  const double pitch = canvas_width / static_cast<double>(columns), width = pitch - left - right,
               height = columns == 3 ? 110 : 160;
  const bool are_named = std::ranges::any_of(panels, [](const PanelRow& panel) { return !panel.title.empty(); });
  std::vector<KeyLines> keys;
  for (const PanelRow& panel : panels) keys.push_back(key_of({panel}, width));
  double key_above = 0;  // of the panels, if each has its own
  if (common.is_ambiguous())
    for (const KeyLines& key : keys) key_above = std::max(key_above, key.height());
  const double above = (are_named ? name_height : 0) + key_above + to_panel;
  const double head = title_height + (common.is_ambiguous() ? 0 : common.height()), row_height = above + height + below;
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  SvgCanvas canvas(canvas_width, head + row_height * static_cast<double>(rows));
  draw_title(canvas, title);
  if (!common.is_ambiguous()) common.draw(canvas, {left, title_height - 6});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double top = head + row_height * static_cast<double>(i / columns);
    if (i > 0 && i % columns == 0) canvas.permit_break(top);
    const PixelPoint corner{pitch * static_cast<double>(i % columns) + left, top + above};
    if (!panels[i].title.empty())
      canvas.text({corner.x, top + name_height - 5}, panels[i].title, "font-weight=\"bold\"");
    if (common.is_ambiguous()) keys[i].draw(canvas, {corner.x, corner.y - to_panel - keys[i].height()});
    draw_row(canvas, {corner, width, height, panels[i].x, panels[i].y}, panels[i]);
  }
  return {title, file_name, canvas.svg(title), canvas.strips(title)};
}

}  // namespace

void draw_key(SvgCanvas& canvas, PixelPoint corner, const std::vector<PanelCurve>& curves) {
  double y = corner.y + 10;
  for (const PanelCurve& curve : curves) {
    if (curve.key.empty()) continue;
    canvas.line({corner.x, y}, {corner.x + 28, y}, curve.stroke);
    for (const std::string& text : curve.key) {
      const double size = std::clamp(11 * widest_text / static_cast<double>(text.size()), 6.0, 11.0);
      canvas.text({corner.x + 34, y + 4}, text,
                  fmt::format("font-size=\"{:.1f}\" fill=\"{}\"", size, &text == &curve.key.front() ? "#000" : "#444"));
      y += key_line;
    }
    y += between_keys;
  }
}

Figure panel_figure(const std::string& title, const std::string& file_name, const std::vector<PanelRow>& panels) {
  return panels.size() == 1 ? one_panel(title, file_name, panels.front()) : grid(title, file_name, panels);
}

}  // namespace trivet::report
