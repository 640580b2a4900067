// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/load_case.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

#include "trivet/assembly/channels.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/response/machinery/load_sharing.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/study/requirements/mount_loads.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;

/// Smaller values, as a share of the largest of the same unit, are round-off.
constexpr double round_off_at_rest = 1e-12;
/// Cases differ from this share on.
constexpr double differs = 1e-9;
/// Share of a value by which a later case must exceed it to be named instead.
constexpr double worth_naming = 1e-6;

std::vector<std::size_t> mounts_and_rated(const model::System& system) {
  std::vector<std::size_t> found = response::mounts(system);
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (system.elements()[e].rating) found.push_back(e);
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

double or_zero(double value, double largest) { return std::abs(value) > round_off_at_rest * largest ? value : 0; }

/// Round-off of the largest force is no load, and round-off of the largest deflection no deflection. That is compared
/// also with what the loads alone would cause: a preload may bear all of them.
void remove_round_off(const model::System& system, const std::vector<std::size_t>& elements,
                      std::vector<MountAtRest>& mounts) {
  constexpr int axial = 8;  // translation of end K
  double force = 0, way = 0;
  for (std::size_t m = 0; m < mounts.size(); ++m) {
    force = std::max({force, std::abs(mounts[m].compression), mounts[m].across});
    const double stiffness = elements::stiffness(system.elements()[elements[m]].law)(axial, axial);
    way = std::max(way, std::abs(mounts[m].deflection));
    if (stiffness > 0) way = std::max(way, std::abs(mounts[m].compression) / stiffness);
  }
  for (MountAtRest& mount : mounts) {
    mount.compression = or_zero(mount.compression, force);
    mount.across = or_zero(mount.across, force);
    mount.deflection = or_zero(mount.deflection, way);
  }
}

/// Largest magnitude per unit over all cases.
std::map<std::string, double> largest_by_unit(const std::vector<EnvelopeRow>& rows) {
  std::map<std::string, double> largest;
  for (const EnvelopeRow& row : rows)
    largest[row.unit] = std::max({largest[row.unit], std::abs(row.least), std::abs(row.largest)});
  return largest;
}

double size_of(const EnvelopeRow& row) { return std::max(std::abs(row.least), std::abs(row.largest)); }

/// Names the first case with the least and with the largest value; others that differ by little are not told from it.
void name_cases(const std::vector<const LoadCase*>& cases, const std::map<std::string, std::size_t>& place,
                std::vector<EnvelopeRow>& rows) {
  for (const LoadCase* one : cases | std::views::reverse)
    for (const response::StaticValue& value : one->values) {
      EnvelopeRow& row = rows[place.at(value.name)];
      const double same = worth_naming * size_of(row);
      if (value.value <= row.least + same) row.least_in = one->case_name;
      if (value.value >= row.largest - same) row.largest_in = one->case_name;
    }
}

}  // namespace

std::vector<MountAtRest> mounts_at_rest(const model::System& moving, const assembly::Assembled& assembled_moving) {
  const auto [system, assembled] = nonlinear::static_machine(moving, assembled_moving);
  std::vector<MountAtRest> result;
  std::vector<std::string> words;
  const std::vector<std::size_t> mounts = mounts_and_rated(system);
  for (const std::size_t e : mounts) {
    result.emplace_back().name = system.elements()[e].name;
    words.insert(words.end(), {system.elements()[e].name, system.elements()[e].name + ".deflection"});
  }
  if (result.empty()) return result;
  const response::StaticResponse rest = response::static_response(system, assembled, words);
  const std::vector<response::RatedLoad> rated = response::rated_loads(system, assembled);
  const auto utilisation = [&](const response::RatedLoad& one) -> std::optional<double> {
    const model::Rating& rating = *system.elements()[one.element].rating;
    if (!rating.has_load_range()) return std::nullopt;
    double largest = 0;
    for (int j = 0; j < 3; ++j)
      if (const auto& range = rating.load[to_size(j)]) largest = std::max(largest, share_of_range(one.load(j), *range));
    return largest;
  };
  constexpr std::size_t values_per_mount = 12, axial_deflection = 8;  // six forces, then six deflections
  for (std::size_t m = 0; m < result.size(); ++m) {
    const std::size_t first = values_per_mount * m;
    Eigen::Vector3d force;  // on the N side, axes of the mount
    for (int j = 0; j < 3; ++j) force(j) = rest.values[first + j].value;
    force = response::mount_axes(system, system.elements()[mounts[m]]).transpose() * force;
    // What is compared with the ranges of its maker is the same everywhere.
    for (const response::RatedLoad& one : rated)
      if (one.element == mounts[m]) {
        force = -one.load;
        result[m].utilisation = utilisation(one);
      }
    // A stop is pressed from either side; its axis points towards it.
    result[m].compression = system.elements()[mounts[m]].type == "stop" ? std::abs(force.z()) : -force.z();
    result[m].across = force.head<2>().norm();
    result[m].deflection = rest.values[first + axial_deflection].value;
  }
  remove_round_off(system, mounts, result);
  return result;
}

LoadCase load_case(const std::string& name, const model::System& system, const assembly::Assembled& assembled,
                   const project::Analyses& analyses) {
  LoadCase result{name, {}, ""};
  try {
    if (analyses.static_of) {
      const nonlinear::StaticMachine held = nonlinear::static_machine(system, assembled);
      result.values = response::static_response(held.system, held.assembled, *analyses.static_of).values;
    }
    for (const MountAtRest& mount : mounts_at_rest(system, assembled)) {
      result.values.push_back({mount.name + ", compression", "N", mount.compression});
      result.values.push_back({mount.name + ", force across", "N", mount.across});
      result.values.push_back({mount.name + ", deflection", "m", mount.deflection});
    }
  } catch (const foundation::NotComputable& refused) {
    result.values.clear();
    result.reason = refused.what();
  }
  return result;
}

Envelope envelope(const std::vector<const LoadCase*>& cases) {
  Envelope result;
  std::map<std::string, std::size_t> place;
  for (const LoadCase* one : cases) {
    if (!one->reason.empty()) result.left_out.emplace_back(one->case_name, one->reason);
    for (const response::StaticValue& value : one->values) {
      const auto [at, added] = place.try_emplace(value.name, result.rows.size());
      if (added)
        result.rows.push_back({value.name, value.unit, value.value, value.value, one->case_name, one->case_name});
      EnvelopeRow& row = result.rows[at->second];
      row.least = std::min(row.least, value.value);
      row.largest = std::max(row.largest, value.value);
    }
  }
  name_cases(cases, place, result.rows);
  const std::map<std::string, double> largest = largest_by_unit(result.rows);
  std::erase_if(result.rows,
                [&](const EnvelopeRow& row) { return size_of(row) <= round_off_at_rest * largest.at(row.unit); });
  const bool differ = std::ranges::any_of(
      result.rows, [&](const EnvelopeRow& row) { return row.largest - row.least > differs * size_of(row); });
  if (cases.size() < 2 || !differ) result.rows.clear();
  return result;
}

}  // namespace trivet::study
