// SPDX-License-Identifier: BSD-3-Clause
#include "support/stl_shapes.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>

namespace trivet::test {

Triangles box_triangles(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const auto corner = [&](int bits) -> Eigen::Vector3d {
    return {bits & 1 ? high.x() : low.x(), bits & 2 ? high.y() : low.y(), bits & 4 ? high.z() : low.z()};
  };
  constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Triangles triangles;
  for (const auto& f : faces) {
    triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
    triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
  }
  return triangles;
}

Triangles turned(Triangles triangles) {
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

Triangles together(Triangles first, const Triangles& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string stl_text(const Triangles& triangles) {
  std::string text = "solid part of a test\n";
  for (const Triangle& triangle : triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const Eigen::Vector3d& p : triangle) text += fmt::format("      vertex {} {} {}\n", p.x(), p.y(), p.z());
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid part of a test\n";
}

std::string stl_binary(const Triangles& triangles) {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // some programs begin their binary files so
  const auto append = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  append(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const Eigen::Vector3d& p : triangle)
      for (int i = 0; i < 3; ++i) append(static_cast<float>(p(i)));
    append(std::uint16_t{0});
  }
  return bytes;
}

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace trivet::test
