// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/plausibility/rules.h"
#include "trivet/response/machinery/load_sharing.h"

namespace trivet::plausibility {
namespace {

/// Without a static load in the file the load of a mount is an estimate; above this share of its highest it is
/// reported.
constexpr double overload_without_gravity = 2;
/// Larger systems are not solved for this check: 600 coordinates take 0.3 s.
constexpr Eigen::Index most_rated_coordinates = 600;

bool has_range(const model::Element& element) {
  return element.rating &&
      std::ranges::any_of(element.rating->load, [](const auto& range) { return range.has_value(); });
}

/// Loads of all mounts at rest; none without a static load, a unique position of rest, or in too large a system.
std::optional<std::vector<response::RatedLoad>> loads_at_rest(const model::System& system,
                                                              const assembly::AssembledOnce& assembled) {
  const model::Description& all = system.description();
  if (!(all.gravity && !all.gravity->isZero(0)) && all.constant_forces.empty()) return std::nullopt;
  try {
    if ((*assembled).layout.size() > most_rated_coordinates) return std::nullopt;
    return response::rated_loads(system, *assembled);
  } catch (const foundation::NotComputable&) {
    return std::nullopt;
  } catch (const foundation::InvalidInput&) {
    return std::nullopt;
  }
}

/// What to do about a load outside its range.
const char* remedy_of(double load, const Eigen::Vector2d& range, bool along_axis) {
  if (along_axis && load < 0 && range(0) >= 0)
    return "turn its axis if the machine presses on it, or use a mount that carries tension";
  const bool too_small = load >= 0 ? load < range(0) : load > range(1);
  if (too_small) return "use a smaller mount, or fewer of them";
  return along_axis ? "use a larger mount, or more of them"
                    : "support the machine in this direction, or use a mount that carries more there";
}

/// The mount outside its ranges, with all directions in which it is.
void judge_rated_mount(const model::Element& element, const Eigen::Vector3d& loads, Suspicions& found) {
  std::string finding, ranges, remedy;
  for (const Eigen::Index direction : {2, 0, 1}) {
    const auto& range = element.rating->load[direction];
    const double load = loads(direction);
    if (!range || response::is_within(load, *range)) continue;
    const char* axis = model::coordinate_names[direction];
    const std::string separator = finding.empty() ? "" : ", ";
    finding += separator + fmt::format("{} along {}", foundation::prefixed_exactly(load, "N", 5), axis);
    if (direction == 2 && load < 0) finding += " (tension)";
    ranges += separator + fmt::format("{} along {}", foundation::prefixed_range((*range)(0), (*range)(1), "N"), axis);
    if (remedy.empty()) remedy = remedy_of(load, *range, direction == 2);
  }
  if (!finding.empty())
    found.push_back({"rated load", "elements." + element.name + ".type", std::move(finding),
                     fmt::format("its mount \"{}\" carries {} at rest", element.rating->mount, ranges),
                     std::move(remedy), true});
}

/// Weight on a mount if it is shared by stiffness [N].
double estimated_load(const std::vector<BodyPicture>& pictures, std::size_t e, const model::Element& element) {
  for (const BodyPicture& picture : pictures) {
    double all = 0, own = 0;
    for (const Attachment& a : picture.attachments) {
      all += a.translation.trace();
      if (a.element == e && element.k.body == picture.body) own = a.translation.trace();
    }
    if (own > 0) return picture.mass.mass * foundation::standard_gravity * own / all;
  }
  return 0;
}

/// Without a static load: the mount that would carry far too much.
void judge_estimated_loads(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  const model::Element* worst = nullptr;
  double worst_ratio = overload_without_gravity;
  for (std::size_t e = 0; e < system.elements().size(); ++e) {
    const model::Element& element = system.elements()[e];
    if (!element.rating || !element.rating->load[2] || !((*element.rating->load[2])(1) > 0)) continue;
    const double ratio = estimated_load(pictures, e, element) / (*element.rating->load[2])(1);
    if (ratio <= worst_ratio) continue;
    worst_ratio = ratio;
    worst = &element;
  }
  if (!worst) return;
  const double highest = (*worst->rating->load[2])(1);
  found.push_back(
      {"rated load", "elements." + worst->name + ".type",
       fmt::format("about {} if the weight is shared by stiffness", foundation::prefixed(worst_ratio * highest, "N")),
       fmt::format("its mount \"{}\" carries at most {} along z at rest", worst->rating->mount,
                   foundation::prefixed_exactly(highest, "N", 5)),
       "use a larger mount, or more of them; gravity = [0, 0, -9.80665] gives the loads themselves"});
}

}  // namespace

void judge_ratings(const model::System& system, const assembly::AssembledOnce& assembled,
                   const std::vector<BodyPicture>& pictures, Suspicions& found) {
  if (std::ranges::none_of(system.elements(), has_range)) return;
  const auto loads = loads_at_rest(system, assembled);
  if (!loads) return judge_estimated_loads(system, pictures, found);
  for (const response::RatedLoad& one : *loads) judge_rated_mount(system.elements()[one.element], one.load, found);
}

}  // namespace trivet::plausibility
