// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/modal/motion_words.h"
#include "trivet/project/analyses/isolation_reader.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/study/requirements/band_words.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {
namespace {

std::string least_isolation_words(const project::Isolation& wanted) {
  constexpr double percent = 100;
  return wanted.in_decibels ? fmt::format("≥ {:.5g} dB", response::isolation_level(wanted.transmitted))
                            : fmt::format("≥ {:.5g} %", percent * (1 - wanted.transmitted));
}

std::string isolated_direction_words(const model::Direction& direction) {
  return (direction.rotation ? " about " : " along ") + modal::direction_words(direction.axis.normalized());
}

/// One row for each force and axis of its ellipse, or each place.
struct IsolationRow {
  std::string subject, words;
  RequirementResult::Transmitted transmitted;
  std::vector<assembly::Band> at;
};

std::vector<IsolationRow> isolation_rows(const CaseContext& c, const project::Isolation& wanted) {
  std::vector<IsolationRow> rows;
  for (const std::string& place : wanted.of)
    rows.push_back({place,
                    place + " isolated from the ground" + isolated_direction_words(wanted.base),
                    {"", place, wanted.base},
                    wanted.at});
  if (wanted.is_of_base()) return rows;
  for (const std::string& force : project::isolated_forces(wanted, c.system)) {
    const auto directions = response::excitation_transmission(c.system, c.assembled, force).directions;
    for (std::size_t i = 0; i < directions.size(); ++i)
      rows.push_back({force,
                      "ground isolated from " + foundation::quoted(force) +
                          (directions.size() > 1 ? isolated_direction_words(directions[i]) : ""),
                      {force, "", {}, i},
                      project::isolated_at(wanted, c.system, force)});
  }
  return rows;
}

/// Magnitude at one frequency; infinite at an undamped resonance.
double isolation_magnitude(const CaseContext& c, const RequirementCurve& curve, double omega) {
  const double size =
      std::abs(response::frequency_response(c.assembled, {curve.channel}, curve.loading, {omega}).curves[0].value(0));
  return std::isnan(size) ? foundation::infinity : size;
}

/// @throws foundation::NotComputable if a constraint of the body carries a part of the force to the ground
void require_free_direction(const CaseContext& c, const RequirementResult::Transmitted& transmitted) {
  const auto force = model::harmonic_force(c.system, transmitted.force);
  const model::Direction along =
      response::excitation_transmission(c.system, c.assembled, transmitted.force).directions[transmitted.direction];
  const std::string reason = response::carried_by_constraint(c.system.bodies()[*force.action.body], along);
  if (!reason.empty()) throw foundation::NotComputable(reason);
}

}  // namespace

void judge_transmitted(const CaseContext& c, RequirementResult& result) {
  if (result.transmitted->force.empty()) require_rigid_ground(c, "isolation");
  else require_free_direction(c, *result.transmitted);
  const RequirementCurve curve = requirement_curve(c.system, c.assembled, result);
  const assembly::Band& band = result.band;
  std::vector<design::LargestAmplitude> maxima;
  if (band.from == band.to) {
    maxima.push_back({isolation_magnitude(c, curve, band.from), band.from});
  } else {
    const response::Peaks found = response::peaks(c.assembled, {curve.channel}, curve.loading, c.modes, c.roots(),
                                                  {.search_to = band.to}, c.progress);
    maxima = design::maxima_in_band(c.assembled, {curve.channel}, curve.loading, found, 0, band);
  }
  result.value = 0;
  for (const design::LargestAmplitude& one : maxima) {
    result.candidates.push_back({margin_of(result.allowed, one.amplitude), one.angular_frequency, 0, 0});
    if (one.amplitude < *result.value) continue;
    result.value = one.amplitude;
    result.angular_frequency = one.angular_frequency;
  }
  result.margin = margin_of(result.allowed, *result.value);
}

void add_isolation_requirements(const CaseContext& c, const project::Requirements& required, RequirementList& list) {
  for (const project::Isolation& wanted : required.isolation) {
    for (const IsolationRow& row : isolation_rows(c, wanted))
      for (const assembly::Band& band : row.at) {
        const std::size_t place = list.size();
        RequirementResult& result =
            list.add(RequirementKind::isolation, row.subject,
                     {row.words, least_isolation_words(wanted), " at " + hertz_words(band)}, "1", wanted.transmitted);
        result.band = band;
        result.transmitted = row.transmitted;
        list.attempt(place, [&] { judge_transmitted(c, list[place]); });
      }
  }
}

}  // namespace trivet::study
