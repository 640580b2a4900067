// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"

namespace trivet::report {
namespace {

constexpr double between_names = 2;  // between two names [pixels]

/// Width of a character over the font size, at least that of Liberation Sans and DejaVu Sans.
double character_width(char c) {
  if (std::string_view("iIjl.,:;|!'()[] ").find(c) != std::string_view::npos) return 0.40;
  if (std::string_view("frt-/").find(c) != std::string_view::npos) return 0.42;
  if (std::string_view("mMwW@%").find(c) != std::string_view::npos) return 0.99;
  if (c >= 'A' && c <= 'Z') return 0.79;
  return 0.64;
}

struct Leader {
  PixelPoint from, to;
};

/// The names, marks and lines that are there already.
class Occupied {
 public:
  explicit Occupied(const std::vector<Box>& marks) : boxes_(marks) {}

  [[nodiscard]] bool is_free(const Box& box, const Leader& leader) const {
    const auto covers = [&](const Box& other) { return box.overlaps(other); };
    const auto crossed = [&](const Box& name) { return crosses(name, leader.from, leader.to); };
    const auto under = [&](const Leader& line) { return crosses(box, line.from, line.to); };
    return std::ranges::none_of(boxes_, covers) && std::ranges::none_of(names_, covers) &&
        std::ranges::none_of(names_, crossed) && std::ranges::none_of(leaders_, under);
  }
  void add(const Box& name, const Leader& leader) {
    names_.push_back({name.left - between_names, name.top - between_names / 2, name.right + between_names,
                      name.bottom + between_names / 2});
    leaders_.push_back(leader);
  }

 private:
  std::vector<Box> boxes_, names_;
  std::vector<Leader> leaders_;
};

/// The point of a rectangle nearest to a place.
PixelPoint nearest(const Box& box, PixelPoint place) {
  return {std::clamp(place.x, box.left, box.right), std::clamp(place.y, box.top, box.bottom)};
}

}  // namespace

bool crosses(const Box& box, PixelPoint a, PixelPoint b) {
  double from = 0, to = 1;  // the part of the line inside [Liang and Barsky]
  const std::array<std::pair<double, double>, 4> sides = {{{a.x - b.x, a.x - box.left},
                                                           {b.x - a.x, box.right - a.x},
                                                           {a.y - b.y, a.y - box.top},
                                                           {b.y - a.y, box.bottom - a.y}}};
  for (const auto& [slope, room] : sides) {
    if (slope == 0 && room <= 0) return false;
    if (slope < 0) from = std::max(from, room / slope);
    if (slope > 0) to = std::min(to, room / slope);
  }
  return from < to;
}

double text_width(std::string_view text, double font_size) {
  double width = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) width += character_width(c);
    else if (byte >= 0xe0) width += 1;  // the first byte of a character of three or four: it may be wide
    else if (byte >= 0xc0) width += 0.8;
  }
  return width * font_size;
}

std::vector<std::optional<PlacedLabel>> placed_labels(const std::vector<Label>& labels, const Box& area,
                                                      const Obstacles& obstacles, double font_size) {
  constexpr std::array<double, 12> distances = {9, 14, 20, 28, 38, 50, 64, 80, 98, 120, 150, 190};
  constexpr int directions = 16;
  constexpr double nearby = 50;  // a name farther from its place is harder to assign than one on a line to read
  const double height = 1.15 * font_size, ascent = 0.92 * font_size;
  Occupied occupied(obstacles.marks);
  const auto is_struck = [&](const Box& box) {
    return std::ranges::any_of(obstacles.lines,
                               [&](const auto& line) { return crosses(box, line.first, line.second); });
  };
  std::vector<std::optional<PlacedLabel>> result(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const PixelPoint place = labels[i].place;
    const double width = text_width(labels[i].text, font_size);
    std::optional<PlacedLabel> on_a_line;
    for (std::size_t tried = 0; tried < distances.size() * directions && !result[i]; ++tried) {
      // To the right and the left first, then the diagonals, up and down.
      constexpr std::array<int, directions> order = {1, 7, 15, 9, 0, 8, 2, 6, 14, 10, 3, 5, 13, 11, 4, 12};
      const double distance = distances[tried / directions];
      if (on_a_line && distance > nearby) break;
      const double angle = foundation::two_pi * order[tried % directions] / directions;
      const PixelPoint end{place.x + distance * std::cos(angle), place.y - distance * std::sin(angle)};
      const double left = end.x - width * (0.5 - 0.5 * std::clamp(2 * std::cos(angle), -1.0, 1.0));
      const double top = end.y - height / 2;
      const Box box{left, top, left + width, top + height};
      const PixelPoint leader = nearest(box, place);
      if (!area.contains(box) || !occupied.is_free(box, {place, leader})) continue;
      const PlacedLabel here{box, {left, top + ascent}, leader};
      if (!is_struck(box)) result[i] = here;
      else if (!on_a_line) on_a_line = here;
    }
    if (!result[i]) result[i] = on_a_line;
    if (result[i]) occupied.add(result[i]->box, {place, result[i]->leader});
  }
  return result;
}

}  // namespace trivet::report
