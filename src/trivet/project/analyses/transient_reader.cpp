// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/project/analyses/wanted_reader.h"

namespace trivet::project {
namespace {

constexpr double most_time_points = 20'000'000;

std::vector<std::pair<std::string, double>> read_initial(TableReader& reader, const std::string& key, const ResultNames& names, assembly::Quantity quantity) {
  std::vector<std::pair<std::string, double>> values;
  const Node* table = reader.table(key);
  if (!table) return values;
  TableReader inside(*table, reader.path() + "." + key, reader.problems());
  for (const std::string& name : table->keys) {
    const auto measured = names.component(name, quantity);
    const bool coordinate = measured && *measured != Quantity::force && *measured != Quantity::moment && std::count(name.begin(), name.end(), '.') == 1;
    if (!coordinate) {
      inside.error(name, "no such coordinate", "initial values belong to free coordinates of bodies, in quotes: \"BODY.z\"", "check the name");
      continue;
    }
    if (const auto value = inside.number(name, *measured)) values.emplace_back(name, *value);
  }
  return values;
}

}  // namespace

TransientRequest read_transient(TableReader& reader, const ResultNames& names, const Mentioned& mentioned) {
  TransientRequest request;
  read_wanted(reader, names, mentioned.time_excitations, "time", request.wanted);
  request.from = reader.number("from", Quantity::time).value_or(0);
  request.to = reader.number("to", Quantity::time);
  request.step = reader.number("step", Quantity::time);
  if (request.to && !(*request.to > request.from)) reader.error("to", fmt::format("{:.6g} s", *request.to), "it ends after it begins", "give to above from");
  if (request.step && !(*request.step > 0)) reader.error("step", fmt::format("{:.6g} s", *request.step), "a step is > 0", "mend it");
  if (request.step && request.to && *request.step > *request.to - request.from && *request.to > request.from)
    reader.error("step", fmt::format("{:.6g} s", *request.step), "it is no longer than the time from from to to", "take a shorter step");
  if (request.step && request.to && *request.step > 0 && (*request.to - request.from) / *request.step > most_time_points)
    reader.error("step", fmt::format("{:.3g} points", (*request.to - request.from) / *request.step), fmt::format("at most {:.0f} points are computed at once", most_time_points), "take a longer step");
  request.nearest_linear_system = reader.boolean("nearest_linear_system").value_or(false);
  request.displacements = read_initial(reader, "initial_displacement", names, assembly::Quantity::displacement);
  request.velocities = read_initial(reader, "initial_velocity", names, assembly::Quantity::velocity);
  return request;
}

ShockSpectrumRequest read_shock_spectrum(TableReader& reader, const Mentioned& mentioned) {
  ShockSpectrumRequest request;
  request.excitations = read_selected(reader, mentioned.time_excitations, "time");
  request.damping_ratio = reader.number("damping", Quantity::pure).value_or(0.05);
  if (!(request.damping_ratio >= 0 && request.damping_ratio < 1)) reader.error("damping", fmt::format("{:.6g}", request.damping_ratio), "a damping ratio is 0 … 1 (Q = 1/(2ζ); Q = 10 is 0.05)", "mend it");
  const auto band = read_band(reader, "band");
  if (!reader.has("band")) reader.missing("band", "give the natural frequencies: band = [\"5 Hz\", \"2000 Hz\"]");
  if (band && !(band->from > 0)) reader.error("band", "from 0", "natural frequencies are > 0", "raise the lower end");
  request.band = band.value_or(response::Band{1, 2});
  return request;
}

}  // namespace trivet::project
