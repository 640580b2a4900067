// SPDX-License-Identifier: BSD-3-Clause
// Mixed displacement–pressure elements, total Lagrangian: Π(u, p) = ∫ W(F) + p (J − 1) − p²/(2κ) dV. A pressure local
// to the element is p = κ Σ ψ M⁻¹ ∫ψ (J − 1): it adds κ Gᵀ M⁻¹ G with G = ∫ψ ∂J/∂u to the tangent, and no pressure
// unknown remains.
#include "trivet/fem/element_kernel.h"

#include <Eigen/LU>
#include <vector>

#include "trivet/fem/hyperelastic.h"
#include "trivet/fem/reference_element.h"
#include "trivet/foundation/index.h"

namespace trivet::fem {
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
