// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/mount_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/explanation.h"
#include "trivet/study/margin.h"

namespace trivet::study {
namespace {

/// From its end N to its end K, ground axes.
Eigen::Vector3d axis_of(const model::System& system, const model::Element& element) {
  const Eigen::Vector3d axis = element.n.axes.col(2);
  return element.n.body ? system.bodies()[*element.n.body].pose.rotation * axis : axis;
}

/// Force and deflection of one mount at rest.
struct MountLoad {
  double along = 0, across = 0;  ///< compression is positive [N]
  double deflection = 0;         ///< of K against N, along the axis [m]
};

/// @param at  first of its six forces and six deflections
MountLoad mount_load(const model::System& system, const model::Element& element, const response::StaticResponse& rest,
                     std::size_t at) {
  Eigen::Vector3d force;  // on the N side, ground axes
  for (int j = 0; j < 3; ++j) force(j) = rest.values[at + to_size(j)].value;
  const Eigen::Vector3d axis = axis_of(system, element);
  const double along = -force.dot(axis);
  return {along, (force + along * axis).norm(),
          rest.values[at + 8].value};  // the third deflection: axes of the element
}

RequirementResult load_result(const model::Element& element, const Eigen::Vector2d& range) {
  RequirementResult result;
  result.kind = RequirementKind::mount_load;
  result.subject = element.name;
  result.words = fmt::format("{} carries {:.5g} … {:.5g} N", element.name, range(0), range(1));
  result.unit = "N";
  result.allowed = range(1);
  return result;
}

RequirementResult deflection_result(const model::Element& element, double allowed) {
  RequirementResult result;
  result.kind = RequirementKind::mount_deflection;
  result.subject = element.name;
  result.words = fmt::format("{} deflects ≤ {}", element.name, value_words(allowed, "m"));
  result.unit = "m";
  result.allowed = allowed;
  return result;
}

void judge_load(RequirementResult& result, const Eigen::Vector2d& range, const MountLoad& load) {
  result.value = load.along;
  result.margin = margin_in_range(load.along, range);
  if (load.along < range(0)) result.allowed = range(0);
  if (load.along < 0) result.detail = "in tension: its axis points from end N to end K";
  constexpr double noticeable = 0.01;
  if (load.across > noticeable * std::abs(load.along))
    result.detail += fmt::format("{}{} across its axis: not judged, the catalogue has no range",
                                 result.detail.empty() ? "" : "; ", value_words(load.across, "N"));
}

}  // namespace

double margin_in_range(double compression, const Eigen::Vector2d& range) {
  const double low = range(0), high = range(1);
  if (compression < 0) return low < 0 ? margin_of(-low, compression) : 0;  // tension
  const double upper = margin_of(high, compression);
  return low > 0 ? std::min(upper, margin_of_least(low, compression)) : upper;
}

MountRows mount_rows(const model::System& system, const assembly::Assembled& assembled, const model::Element& element) {
  const std::vector<assembly::Channel> channels = assembly::channels(
      system, assembled, {element.name, element.name + ".deflection"}, assembly::MotionQuantity::displacement);
  const Eigen::Vector3d axis = axis_of(system, element);
  MountRows rows;
  rows.compression = Eigen::RowVectorXd::Zero(assembled.matrices.size());
  for (std::size_t j = 0; j < 3; ++j) {
    rows.compression -= axis(to_index(j)) * channels[j].on_displacement.real().transpose();
    rows.compression_at_rest -= axis(to_index(j)) * channels[j].at_rest;
  }
  constexpr std::size_t along_the_axis = 8;  // after six forces
  rows.deflection = channels[along_the_axis].on_displacement.real().transpose();
  rows.deflection_at_rest = channels[along_the_axis].at_rest;
  return rows;
}

std::vector<RequirementResult> mount_loads(const CaseContext& context) {
  std::vector<const model::Element*> mounts;
  std::vector<std::string> words;
  for (const model::Element& element : context.system.elements())
    if (element.rating) {
      mounts.push_back(&element);
      words.insert(words.end(), {element.name, element.name + ".deflection"});
    }
  if (mounts.empty()) return {};
  std::optional<response::StaticResponse> rest;
  std::string reason;
  try {
    rest = response::static_response(
        context.system, context.assembled,
        assembly::channels(context.system, context.assembled, words, assembly::MotionQuantity::displacement));
  } catch (const foundation::NotComputable& refused) {
    reason = refused.what();
  } catch (const foundation::InvalidInput& refused) {
    reason = refused.what();
  }
  std::vector<RequirementResult> results;
  constexpr std::size_t values_per_mount = 12;
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    const model::Rating& rating = *mounts[i]->rating;
    const MountLoad load = rest ? mount_load(context.system, *mounts[i], *rest, values_per_mount * i) : MountLoad();
    if (rating.compression) {
      RequirementResult& result = results.emplace_back(load_result(*mounts[i], *rating.compression));
      if (rest) judge_load(result, *rating.compression, load);
    }
    if (rating.deflection) {
      RequirementResult& result = results.emplace_back(deflection_result(*mounts[i], *rating.deflection));
      if (rest) {
        result.value = std::abs(load.deflection);
        result.margin = margin_of(result.allowed, load.deflection);
      }
    }
  }
  for (RequirementResult& result : results) result.reason = reason;
  return results;
}

}  // namespace trivet::study
