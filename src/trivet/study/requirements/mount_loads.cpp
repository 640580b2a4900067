// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/mount_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {

namespace {

constexpr Eigen::Index along_axis = 2;  // e3

/// "left carries 0 … 800 N", for x and y with the direction.
std::string carries_words(const std::string& name, const Eigen::Vector2d& range, Eigen::Index direction) {
  const std::string words = fmt::format("{} carries {:.5g} … {:.5g} N", name, range(0), range(1));
  return direction == along_axis ? words : words + " along " + model::coordinate_names[direction];
}

RequirementResult judged_load(const model::Element& element, Eigen::Index direction, const Eigen::Vector2d& range,
                              const response::RatedLoad* at_rest) {
  RequirementResult result;
  result.kind = RequirementKind::mount_load;
  result.subject = element.name;
  result.words = carries_words(element.name, range, direction);
  result.unit = "N";
  result.allowed = range(1);
  result.direction = static_cast<int>(direction);
  if (!at_rest) return result;
  const double load = at_rest->load(direction);
  result.value = load;
  result.margin = margin_in_range(load, range);
  if (load < range(0)) result.allowed = range(0);
  if (direction == along_axis && load < 0) result.detail = "in tension: its axis points from end N to end K";
  return result;
}

/// A load for which the catalogue has no range: without a value, so that it never counts as within.
RequirementResult load_without_range(const model::Element& element, Eigen::Index direction, double load) {
  const char* axis = model::coordinate_names[direction];
  RequirementResult result;
  result.kind = RequirementKind::mount_load;
  result.subject = element.name;
  result.words = fmt::format("{} carries its load along {}", element.name, axis);
  result.unit = "N";
  result.detail = value_words(load, "N");
  result.reason = fmt::format(
      "{}: {} along {}, for which \"{}\" has no range; add load = {{{} = [\"… N\", \"… N\"]}} "
      "to the catalogue",
      element.name, value_words(load, "N"), axis, element.rating->mount, axis);
  return result;
}

RequirementResult judged_deflection(const model::Element& element, double allowed, const response::RatedLoad* at_rest) {
  RequirementResult result;
  result.kind = RequirementKind::mount_deflection;
  result.subject = element.name;
  result.words = {element.name + " deflects", "≤ " + value_words(allowed, "m")};
  result.unit = "m";
  result.allowed = allowed;
  if (!at_rest) return result;
  result.value = std::abs(at_rest->deflection);
  result.margin = margin_of(allowed, at_rest->deflection);
  if (element.creep > 1) result.detail = fmt::format("with its creep factor {:.4g}", element.creep);
  return result;
}

void judge_mount(const model::Element& element, const response::RatedLoad* at_rest, const std::string& reason,
                 std::vector<RequirementResult>& results) {
  const std::size_t first = results.size();
  for (const Eigen::Index direction : {along_axis, Eigen::Index{0}, Eigen::Index{1}})
    if (const auto& range = element.rating->load[direction])
      results.push_back(judged_load(element, direction, *range, at_rest));
  if (element.rating->deflection) results.push_back(judged_deflection(element, *element.rating->deflection, at_rest));
  for (std::size_t i = first; i < results.size(); ++i) results[i].reason = reason;
  for (Eigen::Index direction = 0; at_rest && direction < 3; ++direction)
    if (const double load = at_rest->load(direction);
        !element.rating->load[direction] && std::abs(load) > response::noticeable_load * at_rest->load.norm())
      results.push_back(load_without_range(element, direction, load));
}

}  // namespace

double margin_in_range(double load, const Eigen::Vector2d& range) {
  if (load < 0) return margin_in_range(-load, {-range(1), -range(0)});
  const double low = range(0), high = range(1);
  if (high < 0 || (high <= 0 && load > 0)) return 0;
  const double upper = margin_of(high, load);
  return low > 0 ? std::min(upper, margin_of_least(low, load)) : upper;
}

bool is_near_lower_end(double load, const Eigen::Vector2d& range) {
  if (load < 0) return is_near_lower_end(-load, {-range(1), -range(0)});
  return range(0) > 0 && load / range(0) < range(1) / load;
}

double share_of_range(double load, const Eigen::Vector2d& range) {
  if (load == 0) return 0;
  const double end = load > 0 ? range(1) : -range(0);
  return end > 0 ? std::abs(load) / end : foundation::infinity;
}

MountRows mount_rows(const model::System& system, const assembly::Assembled& given, const model::Element& element) {
  const assembly::Assembled& assembled = given.first_order();
  const auto row = [&](const std::string& result) { return response::rest_row(system, assembled, result); };
  Eigen::Matrix<double, 3, Eigen::Dynamic> force(3, assembled.matrices.size());  // on the N side, ground axes
  Eigen::Vector3d force_at_rest;
  for (const auto& [j, component] : {std::pair{0, ".force.x"}, {1, ".force.y"}, {2, ".force.z"}}) {
    const response::RestRow one = row(element.name + component);
    force.row(j) = one.row;
    force_at_rest(j) = one.at_rest;
  }
  const Eigen::Matrix3d into_mount = response::mount_axes(system, element).transpose();
  MountRows rows;
  rows.load = -(into_mount * force);
  rows.load_at_rest = -(into_mount * force_at_rest);
  const response::RestRow deflection = row(element.name + ".deflection.z");
  rows.deflection = element.creep * deflection.row;
  rows.deflection_at_rest = element.creep * deflection.at_rest;
  return rows;
}

MountsAtRest mounts_at_rest(const CaseContext& context) {
  try {
    const nonlinear::StaticMachine held = nonlinear::static_machine(context.system, context.assembled);
    return {response::rated_loads(held.system, held.assembled), ""};
  } catch (const foundation::NotComputable& refused) {
    return {{}, refused.what()};
  } catch (const foundation::InvalidInput& refused) {
    return {{}, refused.what()};
  }
}

std::vector<RequirementResult> mount_loads(const CaseContext& context) {
  const auto& [loads, reason] = mounts_at_rest(context);
  std::vector<RequirementResult> results;
  std::size_t rated = 0;
  for (const model::Element& element : context.system.elements())
    if (element.rating) judge_mount(element, loads.empty() ? nullptr : &loads[rated++], reason, results);
  return results;
}

namespace {

RequirementResult limit_of_sum(RequirementKind kind, RequirementWords words, std::string unit, double allowed,
                               const std::optional<double>& sum) {
  RequirementResult result;
  result.kind = kind;
  result.words = std::move(words);
  result.unit = std::move(unit);
  result.allowed = allowed;
  result.value = sum;
  if (sum) result.margin = margin_of(allowed, *sum);
  return result;
}

}  // namespace

MountSums sums_of_mounts(const model::System& system) {
  MountSums sums;
  bool first = true;
  for (const model::Element& element : system.elements()) {
    if (!element.rating) continue;
    const auto& mass = element.rating->mass;
    const auto& price = element.rating->price;
    if (first) {
      sums = {price, mass};
      first = false;
      continue;
    }
    if (sums.mass) sums.mass = mass ? std::optional(*sums.mass + *mass) : std::nullopt;
    if (!sums.price) continue;
    if (price && price->currency == sums.price->currency) sums.price->amount += price->amount;
    else sums.price.reset();
  }
  return sums;
}

std::vector<RequirementResult> mount_sums(const model::System& system, const project::Requirements& required) {
  std::vector<RequirementResult> results;
  const MountSums sums = sums_of_mounts(system);
  if (required.price) {
    const bool same = sums.price && sums.price->currency == required.price->currency;
    RequirementResult& result = results.emplace_back(limit_of_sum(
        RequirementKind::price, RequirementWords("mounts cost", "≤ " + project::price_words(*required.price)),
        required.price->currency, required.price->amount, same ? std::optional(sums.price->amount) : std::nullopt));
    if (!same) result.reason = "price: not every mount has one in " + required.price->currency;
  }
  if (required.mass > 0) {
    RequirementResult& result = results.emplace_back(limit_of_sum(
        RequirementKind::mount_mass, RequirementWords("mounts weigh", fmt::format("≤ {:.5g} kg", required.mass)), "kg",
        required.mass, sums.mass));
    if (!sums.mass) result.reason = "mass: not every mount has one";
  }
  return results;
}

}  // namespace trivet::study
