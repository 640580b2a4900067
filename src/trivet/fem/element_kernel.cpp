// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/element_kernel.h"

#include <Eigen/LU>

#include <cmath>
#include <vector>

#include "trivet/fem/material.h"
#include "trivet/foundation/index.h"

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

namespace {

template <typename Element>
struct ReferenceTables {
  std::vector<Eigen::Matrix<double, 3, Element::nodes>> gradients;
  std::vector<Eigen::Matrix<double, Element::nodes, 1>> values;
  ReferenceTables() {
    for (int p = 0; p < Element::points; ++p) {
      gradients.push_back(Element::gradients(p));
      values.push_back(Element::values(p));
    }
  }
};

template <typename Element>
const ReferenceTables<Element>& tables() {
  static const ReferenceTables<Element> t;
  return t;
}

/// Pressure functions: 1 and the three centred coordinates (hexahedron), 1 (tetrahedron), or the barycentric
/// coordinates.
template <typename Element, int Modes>
Eigen::Matrix<double, Modes, 1> pressure_functions(int point, const Eigen::Vector3d& from_centre, double size) {
  if constexpr (Modes == 1) return Eigen::Matrix<double, 1, 1>(1.0);
  else if constexpr (Element::nodes == 10) return Element::barycentric(point);
  else return Eigen::Vector4d(1, from_centre.x() / size, from_centre.y() / size, from_centre.z() / size);
}

/// One element: geometry and deformation at its points, and the integrals of J − 1 times the pressure functions.
template <typename Element, int Modes>
struct Kernel {
  static constexpr int N = Element::nodes, P = Element::points;
  using Gradients = Eigen::Matrix<double, 3 * P, N>;
  Gradients gradients;  ///< ∂N/∂X: three rows per point
  Eigen::Matrix<double, P, 1> weights;
  std::array<Eigen::Matrix3d, P> deformation;
  std::array<Eigen::Matrix<double, Modes, 1>, P> functions;
  Eigen::Matrix<double, Modes, 3 * N> volume_slope = Eigen::Matrix<double, Modes, 3 * N>::Zero();  ///< G
  Eigen::Matrix<double, Modes, 1> volume_change = Eigen::Matrix<double, Modes, 1>::Zero();
  Eigen::Matrix<double, Modes, Modes> mass = Eigen::Matrix<double, Modes, Modes>::Zero();
  bool inverted = false;

  Kernel(const Eigen::Matrix<double, 3, N>& x, const Eigen::Matrix<double, 3, N>* u) {
    const Eigen::Vector3d centre = x.rowwise().mean();
    const double size = (x.colwise() - centre).cwiseAbs().maxCoeff();
    for (int p = 0; p < P; ++p) {
      const auto at = to_size(p);
      const Eigen::Matrix3d map = x * tables<Element>().gradients[at].transpose();
      const double determinant = map.determinant();
      inverted = inverted || !(determinant > 0);
      const Eigen::Matrix<double, 3, N> g = map.inverse().transpose() * tables<Element>().gradients[at];
      gradients.template middleRows<3>(3 * p) = g;
      weights(p) = Element::weight(p) * determinant;
      deformation[at] = Eigen::Matrix3d::Identity();
      if (u) deformation[at] += *u * g.transpose();
      functions[at] = pressure_functions<Element, Modes>(p, x * tables<Element>().values[at] - centre, size);
      add_volume(p, g);
    }
  }

  void add_volume(int p, const Eigen::Matrix<double, 3, N>& g) {
    const auto at = to_size(p);
    const Eigen::Matrix3d cof = cofactor(deformation[at]);
    const double j = cof.col(0).dot(deformation[at].col(0));
    inverted = inverted || !(j > 0);
    const Eigen::Matrix<double, Modes, 1> weighted = weights(p) * functions[at];
    const Eigen::Matrix<double, N, 3> slope = g.transpose() * cof.transpose();
    volume_slope.noalias() += weighted * Eigen::Map<const Eigen::Matrix<double, 1, 3 * N>>(slope.data());
    volume_change += weighted * (j - 1);
    mass += weighted * functions[at].transpose();
  }

  /// Adds force and tangent without the dependence of the pressure on the displacement.
  void add_solid(const Material& material, const Eigen::Matrix<double, Modes, 1>& pressure, bool deformed,
                 ElementSystem& system) const {
    std::array<StressAndTangent, P> law;
    for (std::size_t p = 0; p < P; ++p)
      law[p] = !deformed && p > 0 ? law[0] : stress_and_tangent(material, deformation[p], functions[p].dot(pressure));
    Gradients scaled;
    for (int i = 0; i < 3; ++i) {
      scaled.setZero();
      for (int p = 0; p < P; ++p)
        scaled.template middleRows<3>(3 * p) = weights(p) * gradients.template middleRows<3>(3 * p);
      Eigen::Matrix<double, 3 * P, 1> stress;
      for (int p = 0; p < P; ++p) stress.template segment<3>(3 * p) = law[p].stress.row(i).transpose();
      system.force.segment<N>(i * N).noalias() += scaled.transpose() * stress;
      for (int j = i; j < 3; ++j) {
        for (int p = 0; p < P; ++p) {
          Eigen::Matrix3d block;  // A_iIjJ for this i and j
          for (int I = 0; I < 3; ++I)
            for (int J = 0; J < 3; ++J) block(I, J) = law[p].tangent(i + 3 * I, j + 3 * J);
          scaled.template middleRows<3>(3 * p) = (weights(p) * block) * gradients.template middleRows<3>(3 * p);
        }
        Eigen::Matrix<double, N, N> part;
        part.noalias() = gradients.transpose() * scaled;
        system.tangent.block<N, N>(i * N, j * N) += part;
        if (j > i) system.tangent.block<N, N>(j * N, i * N) += part.transpose();
      }
    }
  }
};

template <typename Element, int Modes>
ElementSystem condensed_pressure(const Eigen::Matrix3Xd& nodes, const Material& material,
                                 const Eigen::Matrix3Xd* displacement) {
  constexpr int N = Element::nodes;
  const Eigen::Matrix<double, 3, N> x = nodes, u = displacement ? *displacement : Eigen::Matrix3Xd::Zero(3, N);
  const Kernel<Element, Modes> kernel(x, displacement ? &u : nullptr);
  constexpr Eigen::Index all = 3 * Eigen::Index{N};
  ElementSystem system{Eigen::MatrixXd::Zero(all, all), Eigen::VectorXd::Zero(all), kernel.inverted};
  if (kernel.inverted) return system;
  const Eigen::Matrix<double, Modes, Modes> inverse = kernel.mass.inverse();
  const Eigen::Matrix<double, Modes, 1> pressure = material.bulk_modulus * inverse * kernel.volume_change;
  kernel.add_solid(material, pressure, displacement != nullptr, system);
  const Eigen::Matrix<double, Modes, 3 * N> stiff = material.bulk_modulus * inverse * kernel.volume_slope;
  system.tangent.noalias() += kernel.volume_slope.transpose() * stiff;
  return system;
}

/// Taylor–Hood: the pressures of the corners remain unknowns, p-rows ∫ψ (J − 1) − M p/κ.
ElementSystem continuous_pressure(const Eigen::Matrix3Xd& nodes, const Material& material,
                                  const Eigen::Matrix3Xd* displacement, const Eigen::Vector4d& pressure) {
  const Eigen::Matrix<double, 3, 10> x = nodes, u = displacement ? *displacement : Eigen::Matrix3Xd::Zero(3, 10);
  const Kernel<Tet10, 4> kernel(x, displacement ? &u : nullptr);
  ElementSystem system{Eigen::MatrixXd::Zero(34, 34), Eigen::VectorXd::Zero(34), kernel.inverted};
  if (kernel.inverted) return system;
  kernel.add_solid(material, pressure, displacement != nullptr, system);
  system.tangent.topRightCorner<30, 4>() = kernel.volume_slope.transpose();
  system.tangent.bottomLeftCorner<4, 30>() = kernel.volume_slope;
  system.tangent.bottomRightCorner<4, 4>() = -kernel.mass / material.bulk_modulus;
  system.force.tail<4>() = kernel.volume_change - kernel.mass * pressure / material.bulk_modulus;
  return system;
}

template <typename Element>
ElementVolume volume(const Eigen::Matrix3Xd& nodes) {
  ElementVolume result{0, 1e300};
  for (int p = 0; p < Element::points; ++p) {
    const Eigen::Matrix3d map = nodes * tables<Element>().gradients[p].transpose();
    result.volume += Element::weight(p) * map.determinant();
    result.smallest_determinant = std::min(result.smallest_determinant, map.determinant());
  }
  return result;
}

}  // namespace

ElementSystem element_system(Mesh::Kind kind, TetPressure tet_pressure, const Eigen::Matrix3Xd& nodes,
                             const Material& material, const Eigen::Matrix3Xd* displacement,
                             const Eigen::Vector4d* pressure) {
  if (kind == Mesh::Kind::hex27) return condensed_pressure<Hex27, 4>(nodes, material, displacement);
  if (tet_pressure == TetPressure::constant) return condensed_pressure<Tet10, 1>(nodes, material, displacement);
  return continuous_pressure(nodes, material, displacement,
                             pressure ? *pressure : Eigen::Vector4d(Eigen::Vector4d::Zero()));
}

ElementVolume element_volume(Mesh::Kind kind, const Eigen::Matrix3Xd& nodes) {
  return kind == Mesh::Kind::hex27 ? volume<Hex27>(nodes) : volume<Tet10>(nodes);
}

}  // namespace trivet::fem
