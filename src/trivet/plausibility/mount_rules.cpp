// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/plausibility/rules.h"
#include "trivet/plausibility/unit_slips.h"

namespace trivet::plausibility {
namespace {

/// Two mounts closer than this share of the mass radius and of the distances of the mounts are at one place.
constexpr double same_place = 1e-3;
/// Ratio of a stiffness to the median of its group from which the mount is unusual.
constexpr double unequal = 50;
/// … from which, and up to which, N/m and N/mm were probably confused.
constexpr double thousand_from = 300, thousand_to = 3000;
constexpr double degree = 180 / std::numbers::pi;
/// Factor within which a confusion of degree and radian explains a ratio of rotational stiffnesses.
constexpr double near_degree = 1.2;
/// A mount is not a point: √(rotational / translational stiffness) is some part of its radius. It is too small if it is
/// below all three limits.
constexpr double least_radius = 5e-3;                ///< [m]
constexpr double least_share_of_spread = 4e-3;       ///< of the distance of the mounts from the centre
constexpr double least_share_of_load_radius = 0.08;  ///< of the radius that carries the load at the pressure below
constexpr double pressure = 5e5;                     ///< of rubber under static load [Pa]
using foundation::standard_gravity;

std::string family(const std::string& type) { return type.starts_with("catalogue:") ? "catalogue" : type; }

/// Elements of one family between the same two bodies.
using Group = std::tuple<std::size_t, std::optional<std::size_t>, std::string>;

struct Member {
  std::size_t element = 0;
  const Attachment* attachment = nullptr;
  double translation = 0, rotation = 0;
};

std::map<Group, std::vector<Member>> groups(const model::System& system, const std::vector<BodyPicture>& pictures) {
  std::map<Group, std::vector<Member>> result;
  for (const BodyPicture& picture : pictures)
    for (const Attachment& a : picture.attachments) {
      const model::Element& element = system.elements()[a.element];
      if (element.k.body != picture.body || !a.elastic()) continue;
      result[{picture.body, element.n.body, family(element.type)}].push_back(
          {a.element, &a, a.translation.trace(), a.own_rotation.trace()});
    }
  return result;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::string key(const std::string& type, bool rotation) {
  if (type == "bushing" || type == "three_springs") return rotation ? ".rotation" : ".translation";
  return type == "matrix" || type == "link" || type == "stay" ? ".stiffness" : "";
}

/// Nested coil springs share their place; other mounts of one type hardly do.
bool may_share_place(const model::System& system, const Member& a, const Member& b) {
  return system.elements()[a.element].type == "coil_spring" &&
      std::abs(a.translation - b.translation) > 1e-6 * a.translation;
}

/// Mounts of negligible length: one end determines their place.
bool is_compact(const std::string& type) {
  return type == "bushing" || type == "three_springs" || type.starts_with("rubber_") || type.starts_with("catalogue:");
}

void find_same_places(const model::System& system, const std::vector<BodyPicture>& pictures,
                      std::vector<Member> members, Suspicions& found) {
  const std::size_t body = *system.elements()[members.front().element].k.body;
  const auto picture = std::ranges::find(pictures, body, &BodyPicture::body);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Member& m : members) middle += m.attachment->at / static_cast<double>(members.size());
  double squares = 0;
  for (const Member& m : members)
    squares += (m.attachment->at - middle).squaredNorm() / static_cast<double>(members.size());
  const double near = same_place * std::min(mass_radius(picture->mass), std::sqrt(squares));  // either may be a slip
  std::ranges::stable_sort(
      members, [](const Member& a, const Member& b) { return a.attachment->at.x() < b.attachment->at.x(); });
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = i + 1;
         j < members.size() && members[j].attachment->at.x() - members[i].attachment->at.x() <= near; ++j) {
      const Member &first = members[i].element < members[j].element ? members[i] : members[j],
                   &second = &first == &members[i] ? members[j] : members[i];
      const model::Element &a = system.elements()[first.element], &b = system.elements()[second.element];
      if ((first.attachment->at - second.attachment->at).norm() > near ||
          (!is_compact(a.type) && (a.n.at - b.n.at).norm() > near) || may_share_place(system, first, second))
        continue;
      found.push_back({"same place", "elements." + b.name + ".at",
                       fmt::format("\"{}\" and \"{}\" are both at ({:.4g}, {:.4g}, {:.4g}) m", a.name, b.name,
                                   b.k.at.x(), b.k.at.y(), b.k.at.z()),
                       "two mounts of one kind are usually at different places",
                       "probably copied and not changed, or a sign is missing"});
    }
}

/// One member far from the median of the others.
void find_unequal(const model::System& system, const std::vector<Member>& members, Suspicions& found,
                  std::vector<std::size_t>& blamed) {
  if (members.size() < 2 || !members.front().attachment->typed) return;
  for (const Member& m : members) {
    std::vector<double> others, rotations;
    for (const Member& o : members)
      if (o.element != m.element) others.push_back(o.translation), rotations.push_back(o.rotation);
    const auto [low, high] = std::ranges::minmax_element(others);
    const double usual = median(others), ratio = m.translation / usual;
    const model::Element& element = system.elements()[m.element];
    if (is_scale_in_percent(element.law.scale)) continue;  // reported as such
    const bool stands_out = (ratio > unequal || ratio < 1 / unequal) && *high < unequal * *low;
    if (stands_out && (members.size() > 2 || m.element < members[0].element + members[1].element - m.element)) {
      const double factor = std::max(ratio, 1 / ratio);
      const bool thousand = factor > thousand_from && factor < thousand_to;
      found.push_back(
          {thousand ? "stiffness" : "unequal mounts", "elements." + element.name + key(element.type, false),
           fmt::format("{} (mean of three directions)", foundation::prefixed_exactly(m.translation / 3, "N/m", 6)),
           fmt::format("the others of its kind have {}, {:.3g} times {}",
                       foundation::prefixed_exactly(usual / 3, "N/m", 6), factor, ratio < 1 ? "more" : "less"),
           thousand ? fmt::format("it would be {} if N/m and N/mm were confused",
                                  foundation::prefixed_exactly(m.translation / 3 * (ratio < 1 ? 1e3 : 1e-3), "N/m", 6))
                    : "check its digits and its unit"});
      blamed.push_back(m.element);
      continue;
    }
    const double usual_rotation = median(rotations);
    const auto [least, most] = std::ranges::minmax_element(rotations);
    constexpr double alike = 2;
    if (!(*least > 0) || !(m.rotation > 0) || members.size() < 3 || *most > alike * *least) continue;
    const double turn = usual_rotation / m.rotation / std::max(1e-300, usual / m.translation);
    if (turn > degree / near_degree && turn < degree * near_degree)
      found.push_back(
          {"stiffness per degree", "elements." + element.name + key(element.type, true),
           fmt::format("{} (mean of three directions)", foundation::prefixed_exactly(m.rotation / 3, "N m/rad", 6)),
           fmt::format("the others of its kind have {}",
                       foundation::prefixed_exactly(usual_rotation / 3, "N m/rad", 6)),
           fmt::format("it would be {} if given in N m/deg",
                       foundation::prefixed_exactly(degree * m.rotation / 3, "N m/rad", 6))});
  }
}

std::string and_more(std::size_t count) { return count > 1 ? fmt::format(", and {} more", count - 1) : ""; }

/// `scale` in percent. Adds the elements to `blamed`.
void find_scales(const model::System& system, Suspicions& found, std::vector<std::size_t>& blamed) {
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (is_scale_in_percent(system.elements()[e].law.scale)) blamed.push_back(e);
  if (blamed.empty()) return;
  const model::Element& first = system.elements()[blamed.front()];
  found.push_back({"scale", "elements." + first.name + ".scale",
                   fmt::format("{:.6g}{}", first.law.scale, and_more(blamed.size())),
                   "a factor on stiffness and damping is usually between 0.1 and 10",
                   fmt::format("write \"{:.6g} %\" if percent are meant", first.law.scale)});
}

/// Mounts on the ground whose `from_at` was typed in the frame of the body: in that frame they would be short.
void find_ends_in_another_frame(const model::System& system, const std::vector<BodyPicture>& pictures,
                                Suspicions& found) {
  constexpr double much_shorter = 1.0 / 3;
  for (const BodyPicture& picture : pictures) {
    std::vector<const model::Element*> mounts;
    for (const Attachment& a : picture.attachments) {
      const model::Element& element = system.elements()[a.element];
      if (!is_compact(element.type) || element.k.body != picture.body || element.n.body) continue;
      const double length = model::span(system.bodies(), element.n, element.k).arm.norm(),
                   meant = (element.k.at - element.n.at).norm();
      if (length > mass_radius(picture.mass) && meant < much_shorter * length) mounts.push_back(&element);
    }
    if (mounts.empty()) continue;
    const model::Element& first = *mounts.front();
    found.push_back(
        {"places", "elements." + first.name + ".from_at",
         fmt::format("its ends are {} apart{}",
                     foundation::prefixed(model::span(system.bodies(), first.n, first.k).arm.norm(), "m"),
                     and_more(mounts.size())),
         "from_at is in the frame of the ground, and the body has a position",
         fmt::format("they would be {} apart if the numbers were meant in the frame of \"{}\"",
                     foundation::prefixed((first.k.at - first.n.at).norm(), "m"), system.bodies()[picture.body].name)});
  }
}

/// Stiffnesses of one direction in another unit than the other two; with gravity only the direction of the weight,
/// because guides and bearings are soft in other directions.
void find_mixed_directions(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  constexpr double soft = 0.5;  // machines on mounts hardly have a lower natural frequency of translation [Hz]
  const auto& gravity = system.description().gravity;
  for (const BodyPicture& picture : pictures) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Attachment* first = nullptr;
    bool alike = true;
    for (const Attachment& a : picture.attachments) {
      if (!a.elastic()) continue;
      Eigen::Vector3d k = a.translation.diagonal();
      sum += k;
      if (!first) first = &a;
      std::ranges::sort(k);
      alike = alike && a.typed && k(0) > 0 && k(1) > thousand_from * k(0) && k(1) < thousand_to * k(0);
    }
    if (!first || !alike) continue;
    Eigen::Index softest = 0;
    const double frequency = std::sqrt(sum.minCoeff(&softest) / picture.mass.mass) / (2 * std::numbers::pi);
    constexpr double along = 0.9;
    if (gravity && !gravity->isZero(0)) {
      const Eigen::Vector3d down = system.bodies()[picture.body].pose.rotation.transpose() * gravity->normalized();
      if (std::abs(down(softest)) < along) continue;
    }
    if (frequency >= soft) continue;
    const model::Element& element = system.elements()[first->element];
    const double least = first->translation.diagonal().minCoeff();
    found.push_back(
        {"stiffness", "elements." + element.name + key(element.type, false),
         fmt::format("{} in its softest direction, {} in its stiffest", foundation::prefixed_exactly(least, "N/m", 6),
                     foundation::prefixed_exactly(first->translation.diagonal().maxCoeff(), "N/m", 6)),
         fmt::format("the lowest translation of \"{}\" has {:.3g} Hz", system.bodies()[picture.body].name, frequency),
         fmt::format("the softest would be {} if the number was meant in N/mm; check the other elements too",
                     foundation::prefixed_exactly(1e3 * least, "N/m", 6))});
  }
}

}  // namespace

bool is_scale_in_percent(double scale) { return scale >= 30 && scale <= 300; }

std::vector<std::size_t> judge_mounts(const model::System& system, const std::vector<BodyPicture>& pictures,
                                      Suspicions& found) {
  std::vector<std::size_t> blamed;
  find_scales(system, found, blamed);
  for (const auto& [group, members] : groups(system, pictures)) {
    find_same_places(system, pictures, members, found);
    find_unequal(system, members, found, blamed);
  }
  find_mixed_directions(system, pictures, found);
  find_ends_in_another_frame(system, pictures, found);
  return blamed;
}

void judge_struts(const model::System& system, Suspicions& found) {
  constexpr double longer = 10;
  for (const model::Element& element : system.elements())
    for (const model::DistancePart& part : element.distance_parts) {
      const double between = part.law.distance(Eigen::Vector3d::Zero());
      if (part.law.across || !(part.law.length > longer * between)) continue;
      found.push_back({"places", "elements." + element.name + ".free_length",
                       foundation::prefixed_exactly(part.law.length, "m", 6),
                       fmt::format("its ends are {} apart, so that it is pressed together by most of its length",
                                   foundation::prefixed(between, "m")),
                       "check its unit, and the places of the ends"});
    }
}

void judge_undamped(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  constexpr double equal = 1e-6;
  const auto is_damped = [&](std::size_t e) {
    return !std::holds_alternative<std::monostate>(system.elements()[e].law.damping);
  };
  for (const auto& [group, members] : groups(system, pictures)) {
    const std::optional<std::size_t> body = std::get<0>(group);
    const bool with_dampers = std::ranges::any_of(system.elements(), [&](const model::Element& e) {
      return e.type == "damper" && (e.k.body == body || e.n.body == body);
    });
    const bool are_equal = std::ranges::all_of(members, [&](const Member& m) {
      return std::abs(m.translation - members.front().translation) <= equal * members.front().translation;
    });
    const auto undamped = std::ranges::count_if(members, [&](const Member& m) { return !is_damped(m.element); });
    if (members.size() < 3 || with_dampers || !are_equal || undamped != 1) continue;
    const auto one = std::ranges::find_if(members, [&](const Member& m) { return !is_damped(m.element); });
    found.push_back({"unequal mounts", "elements." + system.elements()[one->element].name, "it has no damping",
                     fmt::format("the {} others of its kind and stiffness have damping", members.size() - 1),
                     "probably a line is missing"});
  }
}

void judge_rotation(const model::System& system, const BodyPicture& picture, Suspicions& found) {
  double translation = 0, rotation = 0, squares = 0;
  int mounts = 0;
  const Attachment* first = nullptr;
  for (const Attachment& a : picture.attachments) {
    if (!a.typed || !a.elastic()) continue;
    if (!first && a.own_rotation.trace() > 0) first = &a;
    translation += a.translation.trace();
    rotation += a.own_rotation.trace();
    squares += (a.at - picture.mass.centre).squaredNorm();
    ++mounts;
  }
  if (!first || mounts < 2 || !(rotation > 0)) return;
  const model::Element& element = system.elements()[first->element];
  if (element.type != "bushing") return;  // for a matrix, the rest about the elastic centre may be rounding
  const double radius = std::sqrt(rotation / translation), spread = std::sqrt(squares / mounts);
  const double load_radius = std::sqrt(picture.mass.mass * standard_gravity / (mounts * std::numbers::pi * pressure));
  if (radius >= least_radius || radius >= least_share_of_spread * spread ||
      radius >= least_share_of_load_radius * load_radius)
    return;
  const std::string small = fmt::format(
      "√(rotational / translational stiffness) is {:.2g} mm; usual is a fraction of the radius of the mount, {:.2g} mm "
      "for this load",
      1e3 * radius, 1e3 * load_radius);
  // Too much translational stiffness has the same effect.
  if (oddness(features(picture, {.stiffness = 1e-3})) < oddness(features(picture, {}))) {
    const double mean = first->translation.trace() / 3;
    found.push_back({"stiffness", "elements." + element.name + ".translation",
                     fmt::format("{} (mean of three directions)", foundation::prefixed_exactly(mean, "N/m", 6)), small,
                     fmt::format("it would be {} if the number is in N/m and its unit N/mm a slip",
                                 foundation::prefixed_exactly(1e-3 * mean, "N/m", 6))});
    return;
  }
  found.push_back({"stiffness per degree", "elements." + element.name + ".rotation",
                   fmt::format("{} (mean of three directions)",
                               foundation::prefixed_exactly(first->own_rotation.trace() / 3, "N m/rad", 6)),
                   small,
                   fmt::format("it would be {} if given in N m/deg",
                               foundation::prefixed_exactly(degree * first->own_rotation.trace() / 3, "N m/rad", 6))});
}

}  // namespace trivet::plausibility
