// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/panel_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "trivet/report/drawing/key_lines.h"
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
