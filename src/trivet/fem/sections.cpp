// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet::fem {
namespace {

std::vector<double> with_midpoints(const std::vector<double>& ends) {
  std::vector<double> all{ends.front()};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    all.push_back(0.5 * (ends[i - 1] + ends[i]));
    all.push_back(ends[i]);
  }
  return all;
}

std::array<int, 9> lattice(auto node) {
  std::array<int, 9> quad{};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) quad[i + 3 * j] = node(i, j);
  return quad;
}

/// Factor on the radius of nodes on a circle, so that `around` parabolic arcs keep the polar moment of area, which
/// determines the torsional stiffness.
double radius_factor(int around) {
  const double half = std::numbers::pi / around, sagitta = 1 - std::cos(half);
  double moment = 0;  // ∫ r² (x dy − y dx) over half an arc, Gauss–Legendre
  constexpr std::array<double, 5> places{-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                                         0.906179845938664};
  constexpr std::array<double, 5> weights{0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                          0.236926885056189};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = places[i], x = 1 - sagitta * t * t, y = std::sin(half) * t;
    moment += weights[i] * (x * x + y * y) * (x * std::sin(half) + y * 2 * sagitta * t);
  }
  return std::pow(2 * half / moment, 0.25);
}

/// Bulged square of half width b in a circle of radius R: b (s (1 + β (1 − t²)), t (1 + β (1 − s²))).
Eigen::Vector2d core_point(double radius, double s, double t) {
  constexpr double half_width = 0.42, bulge = 0.25;
  return half_width * radius * Eigen::Vector2d(s * (1 + bulge * (1 - t * t)), t * (1 + bulge * (1 - s * s)));
}

}  // namespace

std::vector<double> graded_to_one(int count, double smallest) {
  std::vector<double> places;
  const auto last = [&](double gamma) { return 1 - std::tanh(gamma * (1 - 1.0 / count)) / std::tanh(gamma); };
  double low = 1e-3, high = 40;
  const bool uniform = count == 1 || smallest >= last(low);
  for (int i = 0; i < 60 && !uniform; ++i) (last(0.5 * (low + high)) > smallest ? low : high) = 0.5 * (low + high);
  for (int i = 0; i <= count; ++i) {
    const double x = static_cast<double>(i) / count;
    places.push_back(uniform ? x : std::tanh(low * x) / std::tanh(low));
  }
  return places;
}

std::vector<double> graded_to_both(int count, double smallest) {
  const std::vector<double> half = graded_to_one(count / 2, 2 * smallest);
  std::vector<double> places;
  for (auto it = half.rbegin(); it != half.rend(); ++it) places.push_back(0.5 - 0.5 * *it);
  for (std::size_t i = 1; i < half.size(); ++i) places.push_back(0.5 + 0.5 * half[i]);
  return places;
}

Section rectangle(const std::vector<double>& x, const std::vector<double>& y) {
  Section section;
  const std::vector<double> xs = with_midpoints(x), ys = with_midpoints(y);
  const int nx = static_cast<int>(xs.size()), ny = static_cast<int>(ys.size());
  section.points.resize(2, Eigen::Index{nx} * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) section.points.col(i + nx * j) << xs[i], ys[j];
  for (int j = 0; j + 2 < ny; j += 2)
    for (int i = 0; i + 2 < nx; i += 2)
      section.quads.push_back(lattice([&](int a, int b) { return i + a + nx * (j + b); }));
  return section;
}

Section disc(double radius, int core, const std::vector<double>& to_rim) {
  const int side = 2 * core + 1, around = 8 * core;
  const std::vector<double> levels = with_midpoints(to_rim);
  const int layers = static_cast<int>(levels.size()) - 1;
  Section section;
  section.points.resize(2, side * side + layers * around);
  const auto parameter = [&](int i) { return -1 + 2.0 * i / (side - 1); };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) section.points.col(i + side * j) = core_point(radius, parameter(i), parameter(j));
  for (int j = 0; j + 2 < side; j += 2)
    for (int i = 0; i + 2 < side; i += 2)
      section.quads.push_back(lattice([&](int a, int b) { return i + a + side * (j + b); }));

  // Once around the core, counter-clockwise from its corner (−1, −1).
  std::vector<int> boundary;
  for (int i = 0; i < side - 1; ++i) boundary.push_back(i);
  for (int i = 0; i < side - 1; ++i) boundary.push_back(side - 1 + side * i);
  for (int i = side - 1; i > 0; --i) boundary.push_back(i + side * (side - 1));
  for (int i = side - 1; i > 0; --i) boundary.push_back(side * i);
  const auto node = [&](int layer, int t) {
    t %= around;
    return layer == 0 ? boundary[t] : side * side + (layer - 1) * around + t;
  };
  for (int t = 0; t < around; ++t) {
    const double angle = -0.75 * std::numbers::pi + 2 * std::numbers::pi * t / around;
    const Eigen::Vector2d inside = section.points.col(node(0, t)),
                          rim = radius * radius_factor(around / 2) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    for (int layer = 1; layer <= layers; ++layer)
      section.points.col(node(layer, t)) = inside + levels[layer] * (rim - inside);
  }
  for (int t = 0; t < around; t += 2)
    for (int layer = 0; layer < layers; layer += 2)
      section.quads.push_back(lattice([&](int a, int b) { return node(layer + a, t + b); }));
  return section;
}

Section ring(double inner_radius, double outer_radius, int around, const std::vector<double>& to_outside) {
  const std::vector<double> levels = with_midpoints(to_outside);
  const int layers = static_cast<int>(levels.size()), count = 2 * around;
  Section section;
  section.points.resize(2, Eigen::Index{layers} * count);
  const auto node = [&](int layer, int t) { return layer * count + t % count; };
  for (int t = 0; t < count; ++t) {
    const double angle = 2 * std::numbers::pi * t / count;
    for (int layer = 0; layer < layers; ++layer)
      section.points.col(node(layer, t)) = radius_factor(around) *
          (inner_radius + levels[layer] * (outer_radius - inner_radius)) *
          Eigen::Vector2d(std::cos(angle), std::sin(angle));
    section.inner.push_back(node(0, t));
    section.outer.push_back(node(layers - 1, t));
  }
  for (int t = 0; t < count; t += 2)
    for (int layer = 0; layer + 2 < layers; layer += 2)
      section.quads.push_back(lattice([&](int a, int b) { return node(layer + a, t + b); }));
  return section;
}

}  // namespace trivet::fem
