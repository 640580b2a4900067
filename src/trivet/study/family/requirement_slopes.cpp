// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/requirement_slopes.h"

#include <algorithm>
#include <cmath>

#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/random/variance_slopes.h"
#include "trivet/study/family/slopes.h"
#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

using Candidates = std::vector<RequirementResult::Candidate>;

template <typename Named>
std::size_t index_by_name(const std::vector<Named>& list, const std::string& name) {
  return to_size(std::ranges::find(list, name, &Named::name) - list.begin());
}

bool is_frequency_dependent(const model::System& system) {
  return std::ranges::any_of(
      system.elements(), [](const model::Element& element) { return elements::is_frequency_dependent(element.law); });
}

}  // namespace

RequirementSlopes::RequirementSlopes(const CaseContext& context, const DesignNeighbours& neighbours)
    : c_(context), neighbours_(neighbours) {}

bool RequirementSlopes::are_missing(RequirementKind kind, const model::System& system) {
  const MarginSlopes slopes = requirement_row(kind).slopes;
  return slopes == MarginSlopes::differences || (slopes == MarginSlopes::variance && is_frequency_dependent(system));
}

Eigen::MatrixXd RequirementSlopes::of(const RequirementResult& result, const Candidates& candidates) const {
  const MarginSlopes from = requirement_row(result.kind).slopes;
  Eigen::MatrixXd slopes(to_index(candidates.size()), to_index(neighbours_.parameters()));
  if (from == MarginSlopes::curve) slopes = of_curve(result, candidates);
  else if (from == MarginSlopes::shapes) slopes = of_decoupling(result, candidates);
  else
    for (std::size_t i = 0; i < candidates.size(); ++i) slopes.row(to_index(i)) = of_one(result, candidates[i]);
  for (Eigen::Index i = 0; i < slopes.rows(); ++i)
    if (!slopes.row(i).allFinite()) slopes.row(i).setZero();
  return slopes;
}

Eigen::MatrixXd RequirementSlopes::of_curve(const RequirementResult& result, const Candidates& candidates) const {
  std::vector<double> places, minima;
  for (const RequirementResult::Candidate& candidate : candidates) {
    places.push_back(candidate.angular_frequency);
    minima.push_back(candidate.minimum_at);
  }
  RequirementResult curve = result;
  if (result.kind == RequirementKind::mount_dynamic_deflection) curve.subject += deflection_along_axis;
  const Eigen::MatrixXd at_places = curve_slopes(c_, neighbours_, curve, places);
  if (result.kind != RequirementKind::no_peak) return -at_places;
  Eigen::MatrixXd slopes = curve_slopes(c_, neighbours_, result, minima) - at_places;
  // margin (1 + a)/(1 + r) below 1 and a/r above, with 1 + r = peak / minimum
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (const double prominence = result.allowed / candidates[i].margin; candidates[i].margin >= 1)
      slopes.row(to_index(i)) *= (1 + prominence) / prominence;
  return slopes;
}

Eigen::MatrixXd RequirementSlopes::of_decoupling(const RequirementResult& result, const Candidates& candidates) const {
  std::vector<std::size_t> modes;
  for (const RequirementResult::Candidate& candidate : candidates) modes.push_back(to_size(candidate.mode - 1));
  return decoupling_slopes(c_, neighbours_, index_by_name(c_.system.bodies(), result.subject), modes);
}

Eigen::RowVectorXd RequirementSlopes::of_one(const RequirementResult& result,
                                             const RequirementResult::Candidate& candidate) const {
  if (requirement_row(result.kind).slopes == MarginSlopes::zero)
    return Eigen::RowVectorXd::Zero(to_index(neighbours_.parameters()));
  switch (result.kind) {
    case RequirementKind::avoided_frequencies:
      return (candidate.below ? -1 : 1) * frequencies().slopes(candidate.mode);
    case RequirementKind::separation:
      return frequencies().slopes(candidate.mode + 1) - frequencies().slopes(candidate.mode);
    case RequirementKind::damping_ratio:
      return damping_ratio_slopes(c_, neighbours_, to_size(candidate.mode - 1), neighbours_.towards());
    case RequirementKind::rms:
      return -of_rms(result);
    case RequirementKind::static_value:
      return -rest_slopes(c_, neighbours_, [&](const model::System& system, const assembly::Assembled& assembled) {
        response::RestRow rest = response::rest_row(system, assembled, result.subject);
        const double creep = creep_in(system, result.subject);
        for (Eigen::RowVectorXd* row : {&rest.row, &rest.beside}) *row *= creep;
        rest.at_rest *= creep;
        return rest;
      });
    case RequirementKind::mount_load:
    case RequirementKind::mount_deflection:
      return of_mount(result);
    default:
      throw foundation::InvalidInput("RequirementSlopes: this requirement has no slopes");
  }
}

Eigen::RowVectorXd RequirementSlopes::of_mount(const RequirementResult& result) const {
  const bool load = result.kind == RequirementKind::mount_load;
  const std::size_t element = index_by_name(c_.system.elements(), result.subject);
  const Eigen::RowVectorXd slopes =
      rest_slopes(c_, neighbours_, [&](const model::System& system, const assembly::Assembled& assembled) {
        const MountRows rows = mount_rows(system, assembled, system.elements()[element]);
        const Eigen::RowVectorXd row = load ? Eigen::RowVectorXd(rows.load.row(result.direction)) : rows.deflection;
        return response::RestRow{row, row, load ? rows.load_at_rest(result.direction) : rows.deflection_at_rest};
      });
  const auto range = [&] { return *c_.system.elements()[element].rating->load[result.direction]; };
  return load && is_near_lower_end(*result.value, range()) ? slopes : -slopes;
}

Eigen::RowVectorXd RequirementSlopes::of_rms(const RequirementResult& result) const {
  std::vector<response::WeightedModels> models;
  for (std::size_t j = 0; j < neighbours_.parameters(); ++j) models.push_back(neighbours_.along(j));
  return response::rms_slopes(c_.system, c_.assembled, {result.subject, result.quantity, result.excitations},
                              c_.roots().poles, models);
}

const FrequencySlopes& RequirementSlopes::frequencies() const {
  if (!frequencies_) {
    std::vector<response::MatrixRates> rates;
    for (std::size_t j = 0; j < neighbours_.parameters(); ++j)
      rates.push_back(response::matrix_rates(neighbours_.along(j), c_.assembled));
    frequencies_ = std::make_unique<const FrequencySlopes>(c_.modes, c_.assembled.matrices, std::move(rates),
                                                           neighbours_.towards());
  }
  return *frequencies_;
}

}  // namespace trivet::study
