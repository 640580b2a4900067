// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/reference_element.h"

#include <cmath>

namespace trivet::fem {
namespace {

std::array<int, 3> gauss_index(int point) { return {point % 3, point / 3 % 3, point / 9}; }
double gauss_place(int i) { return (i - 1) * std::sqrt(0.6); }
double gauss_weight(int i) { return i == 1 ? 8.0 / 9 : 5.0 / 9; }

double parabola(int node, double x) {
  return node == 0 ? 0.5 * x * (x - 1) : node == 1 ? 1 - x * x : 0.5 * x * (x + 1);
}
double parabola_slope(int node, double x) { return node == 0 ? x - 0.5 : node == 1 ? -2 * x : x + 0.5; }

}  // namespace

const std::array<std::array<int, 3>, 27>& Hex27::lattice() {
  static constexpr std::array<std::array<int, 3>, 27> places{
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2},  // corners
       {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {2, 2, 1}, {0, 2, 1},
       {1, 0, 2}, {0, 1, 2}, {2, 1, 2}, {1, 2, 2},                                     // edges
       {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {1, 1, 1}}};  // faces, centre
  return places;
}

Eigen::Matrix<double, 3, 27> Hex27::gradients(int point) {
  const auto g = gauss_index(point);
  Eigen::Matrix<double, 3, 27> result;
  for (int a = 0; a < 27; ++a)
    for (int d = 0; d < 3; ++d) {
      double product = 1;
      for (int k = 0; k < 3; ++k) {
        const int node = lattice()[a][k];
        const double x = gauss_place(g[k]);
        product *= k == d ? parabola_slope(node, x) : parabola(node, x);
      }
      result(d, a) = product;
    }
  return result;
}

Eigen::Matrix<double, 27, 1> Hex27::values(int point) {
  const auto g = gauss_index(point);
  Eigen::Matrix<double, 27, 1> result;
  for (int a = 0; a < 27; ++a) {
    result(a) = 1;
    for (std::size_t k = 0; k < 3; ++k) result(a) *= parabola(lattice()[a][k], gauss_place(g[k]));
  }
  return result;
}

double Hex27::weight(int point) {
  const auto g = gauss_index(point);
  return gauss_weight(g[0]) * gauss_weight(g[1]) * gauss_weight(g[2]);
}

const std::array<std::array<int, 2>, 6>& Tet10::edges() {
  static constexpr std::array<std::array<int, 2>, 6> corners{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
  return corners;
}

Eigen::Vector4d Tet10::barycentric(int point) {
  const double inner = (5 - std::sqrt(5.0)) / 20;
  Eigen::Vector4d l = Eigen::Vector4d::Constant(inner);
  l(point) = 1 - 3 * inner;
  return l;
}

Eigen::Matrix<double, 10, 1> Tet10::values(int point) {
  const Eigen::Vector4d l = barycentric(point);
  Eigen::Matrix<double, 10, 1> n;
  n.head<4>() = l.array() * (2 * l.array() - 1);
  for (int e = 0; e < 6; ++e) n(4 + e) = 4 * l(edges()[e][0]) * l(edges()[e][1]);
  return n;
}

Eigen::Matrix<double, 3, 10> Tet10::gradients(int point) {
  const Eigen::Vector4d l = barycentric(point);
  Eigen::Matrix<double, 3, 4> slope;  // of the barycentric coordinates: corner 0 at the origin, 1 … 3 on the axes
  slope << Eigen::Vector3d::Constant(-1), Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, 10> result;
  for (int a = 0; a < 4; ++a) result.col(a) = (4 * l(a) - 1) * slope.col(a);
  for (int e = 0; e < 6; ++e) {
    const auto [a, b] = edges()[e];
    result.col(4 + e) = 4 * (l(a) * slope.col(b) + l(b) * slope.col(a));
  }
  return result;
}

double Tet10::weight(int) { return 1.0 / 24; }

}  // namespace trivet::fem
