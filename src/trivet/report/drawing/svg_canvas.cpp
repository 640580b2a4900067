// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace trivet::report {
namespace {

std::string path_of(const std::vector<std::vector<PixelPoint>>& rings) {
  std::string path;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      path +=
          fmt::format("{}{:.2f} {:.2f}{}", i == 0 ? "M" : "L", ring[i].x, ring[i].y, i + 1 == ring.size() ? "Z" : "");
  return path;
}

/// Hash of a text (FNV-1a) as an identifier that is safe in a reference.
std::string identifier(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("clip-{:016x}", hash);
}

/// Heights between which a picture shows a canvas.
struct Range {
  double from, to;
};

std::string picture(double width, Range y, std::string_view description, std::string_view body) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 {0} {1} {2}\" width=\"{1}\" height=\"{2}\" role=\"img\" "
      "font-family=\"Liberation Sans, Arial, sans-serif\" font-size=\"11\">\n<title>{3}</title>\n"
      "<rect{4} width=\"{1}\" height=\"{2}\" fill=\"white\"/>\n{5}</svg>\n",
      y.from, width, y.to - y.from, escaped(description), y.from > 0 ? fmt::format(" y=\"{}\"", y.from) : "", body);
}

}  // namespace

std::string fitting(const std::string& text, double width, double size) {
  constexpr double letter = 0.56;  // mean width over size
  const auto most = static_cast<std::size_t>(std::max(4.0, width / (letter * size)));
  std::string cut;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (starts && ++letters > most - 1 && i + 1 < text.size()) return cut + "…";
    cut += text[i];
  }
  return cut;
}

void SvgCanvas::line(PixelPoint a, PixelPoint b, std::string_view style) {
  body_ +=
      fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", a.x, a.y, b.x, b.y, style);
}

void SvgCanvas::polyline(const std::vector<PixelPoint>& points, std::string_view style) {
  if (points.size() < 2) return;
  std::string list;
  for (const PixelPoint& p : points) list += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
  body_ += fmt::format("<polyline fill=\"none\" points=\"{}\" {}/>\n", list, style);
}

void SvgCanvas::area(const std::vector<std::vector<PixelPoint>>& rings, std::string_view style) {
  const std::string path = path_of(rings);
  if (!path.empty()) body_ += fmt::format("<path fill-rule=\"evenodd\" d=\"{}\" {}/>\n", path, style);
}

void SvgCanvas::begin_clip(const std::vector<std::vector<PixelPoint>>& rings, std::string_view name) {
  const std::string id = identifier(name);
  body_ += fmt::format(
      "<clipPath id=\"{0}\"><path clip-rule=\"evenodd\" d=\"{1}\"/></clipPath>\n<g clip-path=\"url(#{0})\">\n", id,
      path_of(rings));
}

void SvgCanvas::end_clip() { end_group(); }

void SvgCanvas::begin_group(std::string_view attributes) { body_ += fmt::format("<g {}>\n", attributes); }

void SvgCanvas::end_group() { body_ += "</g>\n"; }

void SvgCanvas::circle(PixelPoint centre, double radius, std::string_view style) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", centre.x, centre.y, radius, style);
}

void SvgCanvas::rectangle(PixelPoint corner, double width, double height, std::string_view style) {
  body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n", corner.x, corner.y,
                       width, height, style);
}

void SvgCanvas::text(PixelPoint at, std::string_view content, std::string_view attributes) {
  body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", at.x, at.y, attributes, escaped(content));
}

void SvgCanvas::permit_break(double y) { breaks_.push_back({y, body_.size()}); }

std::string SvgCanvas::svg(std::string_view description) const {
  return picture(width_, {0, height_}, description, body_);
}

std::vector<std::string> SvgCanvas::strips(std::string_view description) const {
  std::vector<Break> ends = breaks_;
  ends.push_back({height_, body_.size()});
  std::vector<std::string> pictures;
  Break start;
  for (const Break& end : ends) {
    pictures.push_back(picture(width_, {start.y, end.y}, description,
                               std::string_view(body_).substr(start.length, end.length - start.length)));
    start = end;
  }
  return pictures;
}

}  // namespace trivet::report
