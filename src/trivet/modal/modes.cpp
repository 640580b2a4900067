// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/modal/motion_words.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

namespace {

/// Relative distance of ω² below which two modes count as one repeated root: round-off of the eigensolver.
constexpr double repeated_within = 1e-10;

using spatial::Vector6;

void describe_bodies(const model::System& system, const assembly::Assembled& assembled,
                     const std::vector<spatial::PrincipalInertia>& principal_inertia, const Eigen::VectorXd& phi,
                     Mode& mode) {
  const auto count = to_index(system.bodies().size());
  mode.shape.resize(6 * count);
  mode.shape_at_centre.resize(6 * count);
  mode.principal_kinetic_energy_share.resize(6 * count);
  double energy = 0;
  for (Eigen::Index b = 0; b < count; ++b) {
    const model::Body& body = system.bodies()[b];
    const Vector6 at_pole = assembled.layout.of_body(to_size(b), phi);
    const Vector6 at_centre = spatial::rigid_motion(body.mass.centre) * at_pole;
    mode.shape.segment<6>(6 * b) = at_pole;
    mode.shape_at_centre.segment<6>(6 * b) = at_centre;
    const spatial::PrincipalInertia& principal = principal_inertia[b];
    Vector6 share;
    share << body.mass.mass * (principal.axes.transpose() * at_centre.head<3>()).array().square(),
        principal.moments.array() * (principal.axes.transpose() * at_centre.tail<3>()).array().square();
    mode.principal_kinetic_energy_share.segment<6>(6 * b) = share;
    energy += share.sum();
    mode.screws.push_back(spatial::screw({at_pole.head<3>(), at_pole.tail<3>()}, body_size(body), body.mass.centre));
  }
  if (energy != 0) mode.principal_kinetic_energy_share /= energy;
}

/// φᵀK_eφ of every element (rows) and mode (columns).
Eigen::MatrixXd strain_energies(const assembly::Assembled& assembled, const Eigen::MatrixXd& shapes) {
  Eigen::MatrixXd energies(to_index(assembled.elements.size()), shapes.cols());
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    const assembly::ElementMap& map = assembled.elements[e];
    const Eigen::MatrixXd motion = map.ends * shapes(map.rows, Eigen::all);
    energies.row(to_index(e)) = motion.cwiseProduct(map.matrices.stiffness * motion).colwise().sum();
  }
  return energies;
}

/// φᵀK_fφ of all foundations.
double foundation_strain_energy(const model::System& system, const assembly::Assembled& assembled,
                                const Eigen::VectorXd& phi) {
  double sum = 0;
  const auto& foundations = system.description().foundations;
  for (std::size_t f = 0; f < foundations.size(); ++f) {
    const Eigen::MatrixXd& stiffness = foundations[f].stiffness;
    const Eigen::VectorXd motion = phi.segment(assembled.layout.foundation_row(f), stiffness.rows());
    sum += motion.dot(stiffness * motion);
  }
  return sum;
}

/// @param momentum  Aφ
/// @param strain    φᵀK_eφ of every element
void share_energy(const model::System& system, const assembly::Assembled& assembled, const Eigen::VectorXd& phi,
                  const Eigen::VectorXd& momentum, const Eigen::VectorXd& strain, Mode& mode) {
  const Eigen::VectorXd share = phi.cwiseProduct(momentum) / phi.dot(momentum);
  const auto bodies = to_index(system.bodies().size());
  mode.kinetic_energy_share.resize(6 * bodies);
  for (Eigen::Index b = 0; b < bodies; ++b)
    mode.kinetic_energy_share.segment<6>(6 * b) = assembled.layout.of_body(to_size(b), share);
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f)
    mode.foundation_kinetic_energy_share +=
        share.segment(assembled.layout.foundation_row(f), system.description().foundations[f].mass.rows()).sum();
  mode.element_kinetic_energy_share.setZero(to_index(assembled.elements.size()));
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    const assembly::ElementMap& map = assembled.elements[e];
    for (std::size_t j = to_size(map.end_columns); j < map.rows.size(); ++j)
      mode.element_kinetic_energy_share(to_index(e)) += share(map.rows[j]);
  }
  // Shares cancel where coordinates couple through the mass: round-off of their sum is that of their magnitudes.
  [[maybe_unused]] constexpr double of_sums = 1e-9;
  assert(std::abs(mode.kinetic_energy_share.sum() + mode.foundation_kinetic_energy_share +
                  mode.element_kinetic_energy_share.sum() - 1) <= of_sums * share.cwiseAbs().sum() &&
         "bodies, foundations and elements share all coordinates, each once");
  if (mode.eigenvalue_squared == 0) return;
  const double in_foundations = foundation_strain_energy(system, assembled, phi), in_elements = std::abs(strain.sum());
  if (in_foundations > 0) mode.foundation_strain_energy_share = in_foundations / (in_foundations + in_elements);
  if (assembled.elements.empty()) return;
  // A foundation mode that moves no mount stores all its energy in the foundation: shares of round-off mean nothing.
  constexpr double round_off = 1e-12;
  // So do those of energies that cancel: of struts under compression against springs.
  if (std::abs(strain.sum()) >
      round_off * std::max(std::abs(mode.eigenvalue_squared * phi.dot(momentum)), strain.cwiseAbs().sum()))
    mode.strain_energy_share = Eigen::VectorXd(strain / strain.sum());
}

void mark_repeated(std::vector<Mode>& list) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    const double a = list[i - 1].eigenvalue_squared, b = list[i].eigenvalue_squared;
    if (a != 0 && std::abs(b - a) <= repeated_within * std::max(std::abs(a), std::abs(b)))
      list[i - 1].repeated = list[i].repeated = true;
  }
}

void warn(const numerics::GeneralizedModes& raw, Modes& result) {
  const auto growing = std::ranges::count_if(result.list, [](const Mode& m) { return m.eigenvalue_squared < 0; });
  if (growing > 0)
    result.warnings.warning(
        "modes", fmt::format("{} of the ω² values {} negative", growing, growing == 1 ? "is" : "are"),
        "such a motion grows exponentially and has no natural frequency", "no steady vibration exists for this model");
  if (raw.complex_pairs > 0)
    result.warnings.warning("modes", fmt::format("{} pairs of ω² are complex", raw.complex_pairs),
                            "an unsymmetric or indefinite system need not have undamped modes",
                            "they are not listed here; see the roots");
}

}  // namespace

namespace {

/// ω² of a motion whose strain energies cancel but for round-off is zero.
double without_round_off(double lambda, double norm, const Eigen::VectorXd& strain) {
  constexpr double round_off = 1e-14;  // of sums of some ten entries
  return std::abs(lambda * norm) <= round_off * strain.cwiseAbs().sum() ? 0 : lambda;
}

/// @param shapes  of `raw` in all coordinates
Modes described(const model::System& system, const assembly::Assembled& assembled,
                const numerics::GeneralizedModes& raw, const Eigen::MatrixXd& shapes) {
  const Eigen::MatrixXd momentum = assembled.matrices.A * shapes, strain = strain_energies(assembled, shapes);
  assert(shapes.rows() == assembled.layout.size() && shapes.cols() == raw.lambda.size());
  assert(std::ranges::is_sorted(raw.lambda) && "modes are numbered by ascending ω²");
  std::vector<spatial::PrincipalInertia> principal;
  for (const model::Body& body : system.bodies()) principal.push_back(spatial::principal_inertia(body.mass));
  Modes result;
  result.route = raw.route;
  for (Eigen::Index i = 0; i < raw.lambda.size(); ++i) {
    Mode& mode = result.list.emplace_back();
    mode.number = static_cast<int>(i) + 1;
    assert(std::abs(raw.norm(i)) == 1 && "φᵀAφ is 1, or −1 for an indefinite mass matrix");
    mode.eigenvalue_squared = without_round_off(raw.lambda(i), raw.norm(i), strain.col(i));
    if (mode.eigenvalue_squared >= 0) mode.angular_frequency = std::sqrt(mode.eigenvalue_squared);
    mode.modal_mass = raw.norm(i);
    mode.coordinates = shapes.col(i);
    describe_bodies(system, assembled, principal, mode.coordinates, mode);
    share_energy(system, assembled, mode.coordinates, momentum.col(i), strain.col(i), mode);
    mode.name = mode_name(system, mode);
  }
  mark_repeated(result.list);
  warn(raw, result);
  return result;
}

}  // namespace

Modes modes(const model::System& system, const assembly::Assembled& assembled) {
  const numerics::MassiveSystem massive = numerics::massive_system(assembled.matrices);
  const numerics::GeneralizedModes raw =
      numerics::generalized_modes(massive.K, massive.A, assembled.matrices.symmetric);
  const bool all_massive = massive.A.rows() == assembled.matrices.A.rows();
  return described(system, assembled, raw, all_massive ? raw.shapes : massive.recovery * raw.shapes);
}

Modes lowest_modes(const model::System& system, const assembly::Assembled& assembled, Eigen::Index count) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  if (m.symmetric && to_index(numerics::massive_rows(m.A).size()) == m.size())
    if (const auto raw = numerics::lowest_modes(m.K, m.A, count)) {
      Modes result = described(system, assembled, *raw, raw->shapes);
      result.lowest_only = true;
      return result;
    }
  return modes(system, assembled);
}

Modes modes(const model::System& system) { return modes(system, assembly::assemble(system)); }

std::optional<int> nearest_mode(const Modes& modes, double omega, Eigen::Index n) {
  const Mode* best = nullptr;
  for (const Mode& mode : modes.list)
    if (mode.angular_frequency &&
        (!best || std::abs(*mode.angular_frequency - omega) < std::abs(*best->angular_frequency - omega)))
      best = &mode;
  const bool incomplete = to_index(modes.list.size()) < n;
  if (!best || (incomplete && std::abs(*best->angular_frequency - omega) > 0.01 * omega)) return std::nullopt;
  return best->number;
}

Eigen::VectorXcd modal_forces(const Modes& modes, const Eigen::VectorXcd& forces) {
  Eigen::VectorXcd result(to_index(modes.list.size()));
  for (Eigen::Index m = 0; m < result.size(); ++m) {
    const Eigen::VectorXd& phi = modes.list[m].coordinates;
    result(m) = {phi.dot(forces.real()), phi.dot(forces.imag())};
  }
  return result;
}

bool has_rigid_motion(const Modes& modes) {
  return std::ranges::any_of(modes.list, [](const Mode& m) { return m.eigenvalue_squared == 0; });
}

double highest_natural_frequency(const model::System& system, const assembly::Assembled& assembled) {
  double highest = 0;
  for (const Mode& mode : modes(system, assembled).list)
    highest = std::max(highest, std::sqrt(std::abs(mode.eigenvalue_squared)));
  return highest > 0 ? highest : 1;
}

namespace {

/// Energy of the foundations over the magnitude of that of all elements; infinite if the elements have none.
double foundations_to_elements(const Mode& mode) {
  return mode.foundation_strain_energy_share / (1 - mode.foundation_strain_energy_share);
}

}  // namespace

Eigen::VectorXd stored_energy(const Mode& mode) {
  if (!mode.strain_energy_share || mode.strain_energy_share->size() == 0) return {};
  const double sign = mode.eigenvalue_squared < 0 ? -1 : 1;  // of the sum, over which the shares are
  const Eigen::VectorXd energies = sign * *mode.strain_energy_share;
  const double in_elements = energies.cwiseMax(0).sum();
  if (!(in_elements > 0)) return {};
  // The largest positive energy is one of the terms of their sum.
  assert(energies.maxCoeff() <= in_elements && "no element stores more than all together");
  return energies / (in_elements + foundations_to_elements(mode));
}

std::optional<MostStrained> most_strained(const Mode& mode) {
  const Eigen::VectorXd energies = stored_energy(mode);
  if (energies.size() == 0) {
    if (mode.foundation_strain_energy_share > 0) return MostStrained{.in_foundations = true, .share = 1};
    return std::nullopt;
  }
  constexpr double same_share = 5e-4, round_off = 1e-9;
  const double share = energies.maxCoeff();
  Eigen::Index most = 0;  // the first of equal ones, whatever their rounding
  while (energies(most) < share - round_off) ++most;
  const double given_back = -energies.cwiseMin(0).sum();
  const double in_foundations = 1 - energies.cwiseMax(0).sum();
  if (in_foundations > share)
    return MostStrained{.in_foundations = true, .share = in_foundations, .given_back = given_back};
  const auto alike = ((energies.array() - share).abs() < same_share).count() - 1;
  return MostStrained{
      .element = to_size(most), .share = share, .alike = static_cast<int>(alike), .given_back = given_back};
}

std::string given_back_words(double given_back) {
  return given_back < noticeably_given_back ? "" : fmt::format(", {:.3g} % of it given back", 100 * given_back);
}

}  // namespace trivet::modal
