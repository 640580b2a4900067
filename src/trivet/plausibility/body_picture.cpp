// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/body_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/model/point_mass.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::plausibility {
namespace {

using foundation::standard_gravity;
/// Share of the largest stiffness or ω² below which a direction counts as unrestrained.
constexpr double hardly_held = 1e-9;
/// Share of the rotational stiffness about an end that is rounding of the part from its translations and arm.
constexpr double rounding = 1e-12;

/// Stiffnesses of these types are numbers with a unit in the project or its files; all others are determined by
/// dimensions or a catalogue, unless their scale changes them much.
bool is_typed(const model::Element& element) {
  constexpr double another = 30;
  static constexpr const char* types[] = {"matrix",   "bushing",  "three_springs", "link",       "stay",
                                          "imported", "measured", "table",         "air_spring", "wire_rope"};
  return std::find(std::begin(types), std::end(types), element.type) != std::end(types) ||
      element.law.scale > another || element.law.scale * another < 1;
}

Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& a) {
  const numerics::SymmetricEigen<Eigen::Matrix3d> eigen =
      numerics::symmetric_eigen(Eigen::Matrix3d(0.5 * (a + a.transpose())));
  const double largest = eigen.values.cwiseAbs().maxCoeff();
  const Eigen::Vector3d inverse =
      eigen.values.unaryExpr([&](double x) { return std::abs(x) > hardly_held * largest ? 1 / x : 0.0; });
  return eigen.vectors * inverse.asDiagonal() * eigen.vectors.transpose();
}

Attachment attachment(const model::Element& element, std::size_t index, bool at_k) {
  const model::End& end = at_k ? element.k : element.n;
  const int first = at_k ? 6 : 0;
  const elements::Matrix12 stiffness = elements::stiffness(element.law);
  const auto block = [&](const elements::Matrix12& m, int i, int j) -> Eigen::Matrix3d {
    return end.axes * m.block<3, 3>(first + 3 * i, first + 3 * j) * end.axes.transpose();
  };
  Attachment result;
  result.element = index;
  result.at = end.at;
  result.translation = block(stiffness, 0, 0);
  result.coupling = block(stiffness, 0, 1);
  result.own_rotation =
      block(stiffness, 1, 1) - result.coupling.transpose() * pseudo_inverse(result.translation) * result.coupling;
  if (result.own_rotation.trace() <= rounding * block(stiffness, 1, 1).trace()) result.own_rotation.setZero();
  result.typed = is_typed(element);
  if (const auto* proportional = std::get_if<elements::ProportionalDamping>(&element.law.damping))
    result.proportional = proportional->factor * (proportional->of_nominal ? 1 / element.law.scale : 1);
  else result.viscous = elements::viscous_damping(element.law).block<3, 3>(first, first).trace();
  if (std::holds_alternative<elements::Viscoelastic>(element.law.damping) && result.elastic()) {
    result.proportional =
        result.viscous / result.translation.trace();  // moduli of the law are multiples of the stiffness
    result.viscous = 0;
  }
  return result;
}

/// Of an element whose N is on modes: a diagonal stiffness, without directions that move with rigid ground.
void add_modes(const model::Description& description, const model::Element& element, Attachment& attachment) {
  if (!element.n.foundation || !element.n.foundation->fixed_directions.isZero(0)) return;
  const model::OnFoundation& on = *element.n.foundation;
  const Eigen::MatrixXd& own = description.foundations[on.foundation].stiffness;
  if (!own.isDiagonal(0) || !(own.diagonal().array() > 0).all()) return;
  const Eigen::Matrix3d k =
      element.n.axes * elements::stiffness(element.law).block<3, 3>(0, 0) * element.n.axes.transpose();
  const auto shape = on.shape.topRows<3>();
  attachment.foundation = on.foundation;
  attachment.over_modes = (shape.transpose() * k * shape).diagonal().cwiseQuotient(own.diagonal());
}

/// Largest over all modes of the foundations below a body; none without such a foundation.
std::optional<double> stiffness_over_floor(const BodyPicture& picture, const Slip& undone) {
  std::map<std::size_t, Eigen::VectorXd> sums;
  for (const Attachment& a : picture.attachments) {
    if (!a.foundation) continue;
    Eigen::VectorXd& sum = sums[*a.foundation];
    if (sum.size() == 0) sum.setZero(a.over_modes.size());
    sum += (a.typed ? undone.stiffness : 1) * a.over_modes;
  }
  std::optional<double> largest;
  for (const auto& [foundation, sum] : sums) largest = std::max(largest.value_or(0), sum.maxCoeff());
  return largest;
}

bool is_whole(const model::Body& body) {
  return body.has_inertia && body.mass.mass > 0 && !model::is_point_mass(body) &&
      std::ranges::all_of(body.free, [](bool f) { return f; });
}

spatial::MassProperties undone_mass(const BodyPicture& picture, const Slip& undone) {
  const Eigen::Vector3d centre = undone.centre * picture.mass.centre;
  if (picture.inertia_about_pole)
    return spatial::from_inertia_about_pole(undone.mass * picture.mass.mass, centre,
                                            undone.inertia * spatial::inertia_about_pole(picture.mass));
  return {undone.mass * picture.mass.mass, centre, undone.inertia * picture.mass.inertia_about_centre};
}

/// Stiffness of all attachments about the centre of mass.
spatial::Matrix6 stiffness_at(const BodyPicture& picture, const Eigen::Vector3d& centre, const Slip& undone) {
  spatial::Matrix6 sum = spatial::Matrix6::Zero();
  for (const Attachment& a : picture.attachments) {
    const double k = a.typed ? undone.stiffness : 1, s = undone.places;
    // arms inside an element were typed in the same unit as its place
    spatial::Matrix6 own;
    own.topLeftCorner<3, 3>() = k * a.translation;
    own.topRightCorner<3, 3>() = k * s * a.coupling;
    own.bottomLeftCorner<3, 3>() = own.topRightCorner<3, 3>().transpose();
    own.bottomRightCorner<3, 3>() = (a.typed ? undone.rotation : 1) * a.own_rotation;
    if (!a.coupling.isZero(0))
      own.bottomRightCorner<3, 3>() += k * s * s * a.coupling.transpose() * pseudo_inverse(a.translation) * a.coupling;
    const spatial::Matrix6 lever = spatial::rigid_motion(s * a.at - centre);
    sum += lever.transpose() * own * lever;
  }
  return sum;
}

/// Positive eigenvalues of K φ = λ M φ, restrained directions only.
std::vector<double> held_eigenvalues(const Eigen::MatrixXd& k, const Eigen::MatrixXd& m) {
  const Eigen::VectorXd eigenvalues = numerics::symmetric_eigen(Eigen::MatrixXd(0.5 * (k + k.transpose())), m).values;
  std::vector<double> held;
  for (const double lambda : eigenvalues)
    if (lambda > hardly_held * eigenvalues.maxCoeff()) held.push_back(lambda);
  return held;
}

double natural_hertz(double lambda) { return std::sqrt(lambda) / (2 * std::numbers::pi); }

}  // namespace

spatial::Matrix6 stiffness_about_centre(const BodyPicture& picture) {
  return stiffness_at(picture, picture.mass.centre, {});
}

double mass_radius(const spatial::MassProperties& mass) {
  return std::sqrt(std::abs(mass.inertia_about_centre.trace()) / (2 * mass.mass));
}

std::vector<BodyPicture> pictures(const model::System& system, const std::vector<bool>& inertia_about_pole,
                                  const std::vector<bool>& from_solids) {
  std::vector<BodyPicture> result;
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const model::Body& body = system.bodies()[b];
    if (!is_whole(body)) continue;
    BodyPicture& picture = result.emplace_back();
    picture.body = b;
    picture.mass = body.mass;
    picture.inertia_about_pole = b < inertia_about_pole.size() && inertia_about_pole[b];
    picture.from_solids = b < from_solids.size() && from_solids[b];
    picture.allowed = !spatial::violated_bounds(body.mass).empty();
    for (const model::Point& point : body.points) picture.points.push_back(point.at);
  }
  const auto picture_of = [&](const std::optional<std::size_t>& body) -> BodyPicture* {
    if (!body) return nullptr;
    const auto found = std::lower_bound(result.begin(), result.end(), *body,
                                        [](const BodyPicture& p, std::size_t b) { return p.body < b; });
    return found != result.end() && found->body == *body ? &*found : nullptr;
  };
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    if (element.is_foundation) continue;
    if (BodyPicture* picture = picture_of(element.k.body)) {
      picture->attachments.push_back(attachment(element, e, true));
      add_modes(system.description(), element, picture->attachments.back());
    }
    if (BodyPicture* picture = picture_of(element.n.body))
      picture->attachments.push_back(attachment(element, e, false));
  }
  for (const model::Excitation& excitation : system.description().excitations)
    if (BodyPicture* picture = picture_of(excitation.action.body)) picture->points.push_back(excitation.action.at);
  for (const model::ConstantForce& force : system.description().constant_forces)
    if (BodyPicture* picture = picture_of(force.body)) picture->points.push_back(force.at);
  return result;
}

Features features(const BodyPicture& picture, const Slip& undone) {
  Features found;
  const spatial::MassProperties mass = undone_mass(picture, undone);
  if (!picture.allowed && !spatial::violated_bounds(mass).empty()) {
    found.possible = false;
    return found;
  }
  const double radius = mass_radius(mass);
  if (!(radius > 0) || !std::isfinite(radius)) return found;
  found.density = mass.mass / std::pow(2 * radius, 3);

  double squares = 0, typed_damping = 0, stiffness_damping = 0;
  int attached = 0;
  for (const Attachment& a : picture.attachments) {
    typed_damping += undone.damping * a.viscous;
    stiffness_damping += a.proportional * (a.typed ? undone.stiffness : 1) * a.translation.trace();
    squares += (undone.places * a.at - mass.centre).squaredNorm();
    ++attached;
  }
  if (attached > 0) found.spread = std::sqrt(squares / attached) / radius;
  found.over_floor = stiffness_over_floor(picture, undone);
  std::vector<double> distances;
  for (const Eigen::Vector3d& point : picture.points) distances.push_back((undone.points * point - mass.centre).norm());
  if (!distances.empty()) {
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                     distances.end());
    found.reach = distances[distances.size() / 2] / radius;
  }

  const spatial::Matrix6 k = stiffness_at(picture, mass.centre, undone);
  const double held = k.topLeftCorner<3, 3>().trace();
  if (!(held > 0) || !k.allFinite()) return found;
  const std::vector<double> translations =
      held_eigenvalues(k.topLeftCorner<3, 3>() / mass.mass, Eigen::Matrix3d::Identity());
  if (translations.empty()) return found;
  double logarithms = 0;
  for (const double lambda : translations) logarithms += std::log(lambda);
  const double square = std::exp(logarithms / static_cast<double>(translations.size()));
  found.frequency = natural_hertz(square);
  found.sag = standard_gravity / square / (2 * radius);
  const double directions = static_cast<double>(translations.size());
  const double damping = typed_damping + stiffness_damping;
  if (damping > 0) found.damping_ratio = damping / (2 * directions * mass.mass * std::sqrt(square));
  found.lever = std::sqrt(k.bottomRightCorner<3, 3>().trace() / 2 / (held / directions)) / radius;
  found.lowest = natural_hertz(translations.front());
  found.highest = natural_hertz(translations.back());
  if (!spatial::violated_bounds(mass).empty()) return found;
  spatial::Matrix6 m = spatial::Matrix6::Zero();
  m.topLeftCorner<3, 3>() = mass.mass * Eigen::Matrix3d::Identity();
  m.bottomRightCorner<3, 3>() = mass.inertia_about_centre;
  const std::vector<double> all = held_eigenvalues(k, m);
  if (!all.empty()) {
    found.lowest = natural_hertz(std::ranges::min(all));
    found.highest = natural_hertz(std::ranges::max(all));
  }
  return found;
}

}  // namespace trivet::plausibility
