// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/key_lines.h"

#include <algorithm>

namespace trivet::report {
namespace {

constexpr double entry_height = 15, gap = 16;

double sample_width(const std::string& stroke) { return stroke.empty() ? 0 : 24; }

}  // namespace

void KeyLines::add(const std::vector<PanelCurve>& curves) {
  for (const PanelCurve& curve : curves) {
    if (curve.key.empty()) continue;
    std::string text;
    for (const std::string& line : curve.key) text += (text.empty() ? "" : ", ") + line;
    const auto [known, is_new] = texts_.emplace(curve.stroke, text);
    if (is_new) entries_.push_back({curve.stroke, text, place(text)});
    else if (known->second != text) is_ambiguous_ = true;
  }
}

double KeyLines::height() const { return entries_.empty() ? 0 : last_.y + entry_height; }

void KeyLines::draw(SvgCanvas& canvas, PixelPoint corner) const {
  for (const Entry& entry : entries_) {
    const PixelPoint at{corner.x + entry.at.x, corner.y + entry.at.y + 7};
    const double sample = sample_width(entry.stroke);
    if (sample > 0) canvas.line(at, {at.x + sample, at.y}, entry.stroke);
    canvas.text({at.x + (sample > 0 ? sample + 5 : 0), at.y + 4}, entry.text, "");
  }
}

PixelPoint KeyLines::place(const std::string& text) {
  constexpr double of_letter = 5.9;
  const auto letters =
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  const double wide = 29 + of_letter * static_cast<double>(letters);
  if (last_.x > 0 && last_.x + wide > width_) last_ = {0, last_.y + entry_height};
  const PixelPoint at = last_;
  last_.x += wide + gap;
  return at;
}

}  // namespace trivet::report
