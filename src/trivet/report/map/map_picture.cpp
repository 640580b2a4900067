// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/map/map_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace trivet::report {
namespace {

constexpr double letter = 6.1;  // approximate width of a character of 11 pixels

bool is_inside(const PlotPanel& panel, const Box& b) {
  return b.left >= panel.corner.x + 2 && b.right <= panel.corner.x + panel.width - 2 && b.top >= panel.corner.y + 2 &&
      b.bottom <= panel.corner.y + panel.height - 2;
}

}  // namespace

double width_of(const std::string& text) {
  return letter * static_cast<double>(std::ranges::count_if(text, [](char c) {
           return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
         }));
}

std::vector<PixelPoint> MapPicture::line(const design::MapLine& places) const {
  std::vector<PixelPoint> points;
  for (const design::MapPlace& p : places) points.push_back(at(p));
  return points;
}

std::vector<std::vector<PixelPoint>> MapPicture::rings(const std::vector<design::MapLine>& lines) const {
  std::vector<std::vector<PixelPoint>> all;
  for (const design::MapLine& ring : lines) all.push_back(line(ring));
  return all;
}

bool MapPicture::is_free(const Box& box) const {
  return is_inside(panel, box) && std::ranges::none_of(taken, [&](const Box& t) { return t.overlaps(box); });
}

void Key::heading(const std::string& text) {
  at_.y += 8;
  canvas_.text({at_.x, at_.y}, text, "font-weight=\"bold\"");
  at_.y += 18;
}

void Key::patch(const std::string& style, const std::string& text, const std::string& second) {
  canvas_.rectangle({at_.x, at_.y - 9}, 22, 13, style);
  add_text(text, second);
}

void Key::region(const std::string& colour, bool infeasible, bool feasible, const std::string& text,
                 const std::string& second) {
  const PixelPoint corner{at_.x, at_.y - 9};
  canvas_.rectangle(corner, 22, 13, fmt::format("fill=\"{}\"", colour));
  if (feasible) canvas_.rectangle({corner.x + (infeasible ? 11 : 0), corner.y}, infeasible ? 11 : 22, 13, lighter);
  patch("fill=\"none\" stroke=\"#777\"", text, second);
}

void Key::stroke(const std::string& style, const std::string& text) {
  canvas_.line({at_.x, at_.y - 3}, {at_.x + 22, at_.y - 3}, style);
  add_text(text, "");
}

void Key::add_text(const std::string& text, const std::string& second) {
  const double size = std::clamp(11 * 225 / width_of(text), 7.0, 11.0);
  canvas_.text({at_.x + 30, at_.y + 1}, text, fmt::format("font-size=\"{:.1f}\"", size));
  if (!second.empty()) canvas_.text({at_.x + 30, at_.y + 14}, second, "fill=\"#555\" font-size=\"10\"");
  at_.y += second.empty() ? 18 : 32;
}

}  // namespace trivet::report
