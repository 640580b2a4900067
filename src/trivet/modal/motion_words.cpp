// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/motion_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/modal/modes.h"

namespace trivet::modal {
namespace {

constexpr double along_axis = 0.985;  // cosine of 10°: a direction this close gets the name of the axis
constexpr double pure = 0.98;         // share of the energy from which "mostly" is omitted
constexpr double translation_dominates = 0.9;
constexpr double inside_elements = 0.5;  // share of the kinetic energy in internal coordinates of elements

/// A coordinate for reading: three decimals, never "-0.000".
std::string coordinate(double value) { return fmt::format("{:.3f}", std::abs(value) < 5e-4 ? 0.0 : value); }

std::string triple(const Eigen::Vector3d& v) {
  return fmt::format("({}, {}, {})", coordinate(v.x()), coordinate(v.y()), coordinate(v.z()));
}

std::string guided_name(const Eigen::VectorXd& share, const Eigen::VectorXd& shape) {
  Eigen::Index largest = 0;
  share.maxCoeff(&largest);
  const bool turns = largest >= 3;
  return fmt::format(
      "{}{} {}", shape.cwiseAbs().sum() - std::abs(shape(largest)) > 1e-9 * std::abs(shape(largest)) ? "mostly " : "",
      turns ? "rotation about" : "translation along", std::string(1, "xyz"[largest % 3]));
}

/// "motion of seat 1, seat 2": the nodes that carry most of the kinetic energy, of the mass of their elements; else "".
std::string motion_of_nodes(const model::System& system, const Mode& mode) {
  std::vector<double> shares;
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    shares.push_back(system.bodies()[b].is_node ? mode.kinetic_energy_share.segment<6>(6 * to_index(b)).sum() : 0);
  if (!(std::accumulate(shares.begin(), shares.end(), 0.0) > inside_elements)) return "";
  constexpr double much = 0.5;  // of the largest share
  constexpr int most_names = 4;
  const double largest = std::ranges::max(shares);
  std::string names;
  int moving = 0;
  for (std::size_t b = 0; b < shares.size(); ++b)
    if (shares[b] > much * largest && ++moving <= most_names)
      names += (names.empty() ? "" : ", ") + system.bodies()[b].name;
  return "motion of " + names + (moving > most_names ? fmt::format(" and {} more nodes", moving - most_names) : "");
}

}  // namespace

double body_size(const model::Body& body) {
  if (body.is_node) return 1;
  const double largest = spatial::inertia_about_pole(body.mass).diagonal().maxCoeff();
  const double radius = std::sqrt(std::max(largest, 0.0) / body.mass.mass);
  return radius > 0 && std::isfinite(radius) ? radius : 1;
}

std::string direction_words(const Eigen::Vector3d& direction) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(direction(i)) >= along_axis) return std::string(1, "xyz"[i]);
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return triple(direction(largest) < 0 ? Eigen::Vector3d(-direction) : direction);
}

std::string motion_words(const spatial::Screw& screw, double size) {
  if (screw.pure_translation) return "translation along " + direction_words(screw.direction);
  const std::string axis = fmt::format("about {} through {} m", direction_words(screw.direction), triple(screw.point));
  if (std::abs(screw.pitch) > 0.5 * size) return fmt::format("screw motion {}, pitch {:.3g} m/rad", axis, screw.pitch);
  return "rotation " + axis;
}

std::string mode_name(const model::System& system, const Mode& mode) {
  if (mode.foundation_kinetic_energy_share > inside_elements) return "motion of the foundation";
  if (mode.element_kinetic_energy_share.sum() > inside_elements) {
    std::string names;
    for (std::size_t e = 0; e < system.elements().size(); ++e)
      if (mode.element_kinetic_energy_share(to_index(e)) > 0.2 * mode.element_kinetic_energy_share.sum())
        names += (names.empty() ? "" : ", ") + system.elements()[e].name;
    return "surging inside " + names;
  }
  if (const std::string frame = motion_of_nodes(system, mode); !frame.empty()) return frame;
  const auto bodies = std::ranges::count_if(system.bodies(), [](const model::Body& body) { return !body.is_node; });
  Eigen::Index leader = 0;
  double best = -1;
  for (Eigen::Index b = 0; b < bodies; ++b) {
    const double share = mode.principal_kinetic_energy_share.segment<6>(6 * b).cwiseAbs().sum();
    if (share > best + 1e-9) {
      best = share;
      leader = b;
    }
  }
  const model::Body& body = system.bodies()[leader];
  const Eigen::VectorXd share = mode.principal_kinetic_energy_share.segment<6>(6 * leader);
  const spatial::Screw& screw = mode.screws[leader];
  const double translation = share.head<3>().sum() / share.sum();
  const bool guided = std::ranges::find(body.free, false) != body.free.end();
  std::string words;
  if (guided) {
    words = guided_name(mode.kinetic_energy_share.segment<6>(6 * leader), mode.shape.segment<6>(6 * leader));
  } else if (translation >= translation_dominates) {
    const Eigen::Vector3d direction = mode.shape_at_centre.segment<3>(6 * leader).normalized();
    words = (translation >= pure ? "translation along " : "mostly translation along ") + direction_words(direction);
  } else {
    words = motion_words(screw, body_size(body));
    if (!words.starts_with("screw")) words = "mostly " + words;
  }
  if (bodies > 1) words = body.name + ": " + words;
  if (mode.eigenvalue_squared == 0) words += " (free)";
  if (mode.eigenvalue_squared < 0) words += " (grows)";
  return words;
}

}  // namespace trivet::modal
