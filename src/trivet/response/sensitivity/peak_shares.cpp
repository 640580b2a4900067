// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/sensitivity/peak_shares.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/model/element_directions.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Vector12c = Eigen::Matrix<Complex, 12, 1>;

/// Undamped modes in all coordinates, numbered as in modal::modes.
struct AllModes {
  std::vector<Eigen::Index> massive;
  numerics::GeneralizedModes raw;
  Eigen::MatrixXd shapes;
};

AllModes all_modes(const assembly::Assembled& assembled) {
  const numerics::MassiveSystem massive = numerics::massive_system(assembled.matrices);
  AllModes result;
  result.massive = numerics::massive_rows(assembled.matrices.A);
  result.raw = numerics::generalized_modes(massive.K, massive.A, assembled.matrices.symmetric);
  result.shapes = massive.recovery * result.raw.shapes;
  return result;
}

/// Adds the inner coordinates of frequency-dependent elements, from their nearest linear system.
VectorXcd with_inner(const assembly::Assembled& assembled, const VectorXcd& known, double omega) {
  const Eigen::Index n = known.size(), rest = assembled.matrices.size() - n;
  VectorXcd all(n + rest);
  all.head(n) = known;
  if (rest == 0) return all;
  const MatrixXcd z = assembled.matrices.at(omega);
  const MatrixXcd inner = z.bottomRightCorner(rest, rest);
  const VectorXcd load = z.bottomLeftCorner(rest, n) * known;
  all.tail(rest) = -numerics::lu_solution(inner, load);
  return all;
}

void share_among_modes(const assembly::Assembled& assembled, const Dynamics& dynamics, const VectorXcd& q, double omega,
                       PeakShares& result) {
  const double size = std::norm(result.value);
  if (size == 0) return;
  const AllModes modes = all_modes(assembled);
  const VectorXcd all = with_inner(assembled, q, omega);
  const Eigen::VectorXd unit = numerics::unit_scale(assembled.matrices).cwiseInverse();
  const Eigen::VectorXd weight = unit(modes.massive);
  const Eigen::MatrixXd basis = weight.asDiagonal() * Eigen::MatrixXd(modes.shapes(modes.massive, Eigen::all));
  const VectorXcd wanted = weight.asDiagonal() * VectorXcd(all(modes.massive));
  const VectorXcd amplitude = numerics::smallest_solution(basis.cast<Complex>(), wanted);
  result.beyond_modes = 1;
  for (Eigen::Index k = 0; k < amplitude.size(); ++k) {
    const VectorXcd shape = modes.shapes.col(k).head(q.size()).cast<Complex>();
    const Complex part = dynamics.channel[0].cwiseProduct(shape).sum() * amplitude(k);
    result.modes.push_back({static_cast<int>(k) + 1, part, (part * std::conj(result.value)).real() / size});
    result.beyond_modes -= result.modes.back().share;
  }
}

/// zᴴ M z of a symmetric M: real.
double form(const VectorXcd& z, const Eigen::MatrixXd& matrix) { return z.dot(matrix.cast<Complex>() * z).real(); }

struct ElementEnergy {
  double stored = 0;      // [J]
  double dissipated = 0;  // [W]
  spatial::Vector6 by_direction = spatial::Vector6::Zero();
};

/// `ground`: motion of the ground, empty if it is at rest.
ElementEnergy energy(const model::System& system, std::size_t e, const assembly::ElementMap& map,
                     const std::optional<Jet<elements::Matrix12c>>& jet, const VectorXcd& q, const VectorXcd& ground,
                     double omega) {
  ElementEnergy result;
  model::ElementDirections directions = model::element_directions(system.bodies(), system.elements()[e]);
  Vector12c ends = Vector12c::Zero();
  for (Eigen::Index j = 0; j < map.end_columns; ++j) ends += map.ends.col(j).head<12>() * q(map.rows[j]);
  if (ground.size() > 0) ends += map.moved_by_ground(ground).head<12>();
  const auto at_centre = [&](const spatial::Matrix6& of_k) -> spatial::Matrix6 {
    const spatial::Matrix6 from_centre = numerics::inverse(spatial::Matrix6(directions.deformation.rightCols<6>()));
    return from_centre.transpose() * of_k * from_centre;
  };
  const auto& laws = system.elements()[e].law.nonlinear;
  if (jet) {
    const elements::Matrix12c& d = (*jet)[0];
    result.stored = 0.25 * form(ends, d.real());
    result.dissipated = 0.5 * omega * ends.dot(d * ends).imag();
    directions.stiffness = at_centre(d.bottomRightCorner<6, 6>().real());
  } else {
    if (laws) directions.stiffness += at_centre(laws->tangent.bottomRightCorner<6, 6>());
    VectorXcd all = map.coordinates(q);
    all.head<12>() = ends;
    result.stored = 0.25 * form(all, map.matrices.stiffness);
    result.dissipated = 0.5 * omega * (form(all, map.matrices.loss) + omega * form(all, map.matrices.damping));
  }
  const Eigen::Matrix<Complex, 6, 1> deformation = directions.deformation.cast<Complex>() * ends,
                                     force = directions.stiffness.cast<Complex>() * deformation;
  result.by_direction = 0.25 * deformation.conjugate().cwiseProduct(force).real();
  return result;
}

/// Stored energy [J] and dissipated power [W] of the foundations' own springs and dashpots.
std::array<double, 2> foundation_energy(const model::System& system, const assembly::Layout& layout, const VectorXcd& q,
                                        double omega) {
  std::array<double, 2> sum = {0, 0};
  const auto& foundations = system.description().foundations;
  for (std::size_t i = 0; i < foundations.size(); ++i) {
    const VectorXcd p = q.segment(layout.foundation_row(i), foundations[i].stiffness.rows());
    sum[0] += 0.25 * form(p, foundations[i].stiffness);
    sum[1] += 0.5 * omega * omega * form(p, foundations[i].damping);
  }
  return sum;
}

/// Power of Rayleigh or modal damping, ½ω² vᴴBv with v = q + x, the motion relative to the one that the ground
/// prescribes, B x = B_g g.
double system_damping_power(const model::System& system, const assembly::Assembled& assembled, const VectorXcd& q,
                            const VectorXcd& ground, double omega) {
  if (std::holds_alternative<std::monostate>(system.description().damping)) return 0;
  model::Description without = system.description();
  without.damping = std::monostate{};
  const assembly::Assembled plain = assembly::assemble(model::System::checked(std::move(without)).value());
  const Eigen::Index n = q.size();
  const Eigen::MatrixXd own = (assembled.matrices.B - plain.matrices.B).topLeftCorner(n, n);
  VectorXcd beyond = q;
  if (ground.size() > 0) {
    const VectorXcd from_ground = (assembled.ground.B - plain.ground.B).topRows(n) * ground;
    beyond += numerics::smallest_solution(own.cast<Complex>(), from_ground);
  }
  return 0.5 * omega * omega * form(beyond, own);
}

/// q in all rows of `dynamics`, and y; if y is unbounded, the mode and 0.
struct PeakMotion {
  VectorXcd coordinates;
  Complex value;
};

PeakMotion moved(const assembly::Assembled& assembled, const Dynamics& dynamics, const PeakPlace& place) {
  if (place.unbounded_mode)
    return {all_modes(assembled).shapes.col(*place.unbounded_mode - 1).head(dynamics.load[0].size()).cast<Complex>(),
            0};
  const Motion found = motion(dynamics);
  return {found.coordinates[0], found.value[0]};
}

Dynamics looked_at(const model::System& system, const assembly::Assembled& assembled, const SensitivityRequest& request,
                   const PeakPlace& place, const ElementJets& jets) {
  if (!(place.angular_frequency > 0)) throw foundation::InvalidInput("peak_shares: the angular frequency must be > 0");
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, request.channels, request.quantity);
  return dynamics(assembled, channels.at(place.channel), request.load(system, assembled), place.angular_frequency,
                  jets);
}

}  // namespace

double alignment(const model::System& system, const assembly::Assembled& assembled, const SensitivityRequest& request,
                 const PeakPlace& place) {
  const Dynamics at = looked_at(system, assembled, request, place, element_jets(assembled, place.angular_frequency));
  const VectorXcd q = moved(assembled, at, place).coordinates;
  const Eigen::VectorXd unit = numerics::unit_scale(assembled.matrices).head(q.size());
  const double most = (unit.asDiagonal() * at.channel[0]).norm() * (unit.cwiseInverse().asDiagonal() * q).norm();
  return most > 0 ? std::abs(at.channel[0].cwiseProduct(q).sum()) / most : 0;
}

PeakShares peak_shares(const model::System& system, const assembly::Assembled& assembled,
                       const SensitivityRequest& request, const PeakPlace& place) {
  const double omega = place.angular_frequency;
  const ElementJets jets = element_jets(assembled, omega);
  const Dynamics at = looked_at(system, assembled, request, place, jets);
  PeakShares result;
  const auto [q, value] = moved(assembled, at, place);
  result.value = value;
  share_among_modes(assembled, at, q, omega, result);

  const assembly::Loading loading = request.load(system, assembled);
  const VectorXcd ground = place.unbounded_mode || loading.motion.vanishes() ? VectorXcd() : loading.motion.at(omega);
  std::vector<ElementEnergy> energies;
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    energies.push_back(energy(system, e, assembled.elements[e], jets[e], q, ground, omega));
    result.strain_energy += energies.back().stored;
    result.dissipated_power += energies.back().dissipated;
  }
  const Eigen::Index n = q.size();
  const double geometric = 0.25 * form(q, assembled.of_levers.topLeftCorner(n, n));
  const auto [in_foundations, by_foundations] = foundation_energy(system, assembled.layout, q, omega);
  const double by_system = system_damping_power(system, assembled, q, ground, omega);
  result.strain_energy += geometric + in_foundations;
  result.dissipated_power += by_system + by_foundations;
  const auto share = [](double part, double whole) { return whole == 0 ? 0.0 : part / whole; };
  for (const ElementEnergy& e : energies) {
    ElementShare& element = result.elements.emplace_back();
    element.stored = share(e.stored, result.strain_energy);
    element.dissipated = share(e.dissipated, result.dissipated_power);
    for (int j = 0; j < 6; ++j) element.by_direction(j) = share(e.by_direction(j), result.strain_energy);
  }
  result.geometric = share(geometric, result.strain_energy);
  result.in_foundations = share(in_foundations, result.strain_energy);
  result.system_damping = share(by_system, result.dissipated_power);
  result.by_foundations = share(by_foundations, result.dissipated_power);
  return result;
}

namespace {

/// Σ of the positive and −Σ of the negative energies, over their sum.
std::array<double, 2> stored_and_given_back(const PeakShares& shares) {
  const double sign = shares.strain_energy < 0 ? -1 : 1;
  std::array<double, 2> sum = {0, 0};
  const auto add = [&](double share) { sum[share * sign > 0 ? 0 : 1] += std::abs(share); };
  for (const ElementShare& one : shares.elements) add(one.stored);
  add(shares.geometric);
  add(shares.in_foundations);
  return sum;
}

}  // namespace

double given_back(const PeakShares& shares) {
  const auto [stored, returned] = stored_and_given_back(shares);
  return stored > 0 ? returned / stored : 0;
}

PeakShares of_positive_parts(PeakShares shares) {
  const double energy_sign = shares.strain_energy < 0 ? -1 : 1, power_sign = shares.dissipated_power < 0 ? -1 : 1;
  const double stored = stored_and_given_back(shares)[0];
  double dissipated =
      std::max(0.0, power_sign * shares.system_damping) + std::max(0.0, power_sign * shares.by_foundations);
  for (const ElementShare& one : shares.elements) dissipated += std::max(0.0, power_sign * one.dissipated);
  const double energy = stored > 0 ? energy_sign / stored : 1, power = dissipated > 0 ? power_sign / dissipated : 1;
  for (ElementShare& one : shares.elements) {
    one.stored *= energy;
    one.by_direction *= energy;
    one.dissipated *= power;
  }
  for (double* of_energy : {&shares.geometric, &shares.in_foundations}) *of_energy *= energy;
  for (double* of_power : {&shares.system_damping, &shares.by_foundations}) *of_power *= power;
  return shares;
}

}  // namespace trivet::response
