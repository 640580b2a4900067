// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "trivet/excitation/spectrum.h"
#include "trivet/foundation/constants.h"
#include "trivet/project/excitations/band_levels_reader.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/excitations/measured_spectrum_reader.h"
#include "trivet/project/excitations/universal_course.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/pairs_reader.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/unit_slips.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

/// Bare densities are in SI per hertz, or in `unit`.
ColumnQuantity read_density_unit(TableReader& psd, const model::Action& action) {
  return read_bare_unit(psd, density_of(course_quantity(action)));
}

std::optional<excitation::Spectrum> spectrum_from_rows(TableReader& reader, const std::string& key,
                                                       const Eigen::MatrixXd& rows, double unit, bool linear) {
  excitation::SpectrumTable table;
  table.frequencies_hz.assign(rows.col(0).begin(), rows.col(0).end());
  for (const double density : rows.col(1)) table.densities_per_hz.push_back(unit * density);
  if (linear) table.interpolation = excitation::SpectrumTable::Interpolation::linear;
  constexpr double slowest = 1e-9, fastest = 1e12;  // [Hz] once in thirty years; atoms of a solid vibrate as fast
  for (const double hertz : table.frequencies_hz)
    if ((hertz > 0 && hertz < slowest) || hertz > fastest) {
      reader.error(key, fmt::format("a frequency of {:.6g} Hz", hertz),
                   "frequencies of a spectrum are 0 or from 1e-9 to 1e12 Hz", "check the unit and the power of ten");
      return std::nullopt;
    }
  const foundation::Problems findings = excitation::check(table, key);
  reader.add(findings);
  return findings.has_errors() ? std::nullopt : std::optional(excitation::from_table(table));
}

std::optional<excitation::Spectrum> read_road(TableReader& psd, const model::Action& action) {
  const auto letter = psd.choice("road", {"A", "B", "C", "D", "E", "F", "G", "H"});
  const double speed = psd.required_number("speed", Quantity::velocity);
  if (psd.has("speed") && !(speed > 0))
    psd.error("speed", fmt::format("{:.6g} m/s", speed), "excitation by a road needs a speed > 0",
              "for instance \"80 km/h\"");
  if (!letter) return std::nullopt;
  excitation::RoadRoughness road = excitation::road_class((*letter)[0]);
  if (const auto waviness = psd.number("waviness", Quantity::pure)) road.waviness = *waviness;
  if (!(road.waviness > 0 && road.waviness <= 5))
    psd.error("waviness", fmt::format("{:.6g}", road.waviness),
              "the waviness of a road is about 2; values above 0 and up to 5 are allowed", "correct it");
  if (const auto range = psd.numbers("wave_numbers", Quantity::pure)) {
    if (range->size() == 2 && (*range)[0] > 0 && (*range)[1] > (*range)[0])
      road.wave_number_from = (*range)[0], road.wave_number_to = (*range)[1];
    else
      psd.error("wave_numbers", fmt::format("{} numbers", range->size()),
                "[from, to] in cycles per metre with 0 < from < to", "for instance [0.011, 2.83]");
  }
  if (course_quantity(action) != Quantity::length)
    psd.error("road", "the excitation is not a displacement of the ground",
              "a road class is a spectrum of the height of the ground",
              "use base = true, translation = [0, 0, 1] and no quantity");
  return speed > 0 && psd.errors() == 0 ? std::optional(excitation::road_spectrum(road, speed)) : std::nullopt;
}

void warn_of_idle_unit(TableReader& psd) {
  if (psd.has("unit"))
    warn_at_key(psd, "unit", "beside a value with a unit of its own", "the unit of the value holds", "remove it");
}

std::optional<excitation::Spectrum> read_flat(TableReader& psd, const ColumnQuantity& unit) {
  const std::size_t before = psd.errors();
  const Node* given = psd.node("flat");
  double density = 0;
  if (given->kind != Node::Kind::text) density = unit.bare * psd.required_number("flat", Quantity::pure);
  else if (const auto value = to_density(given->text, unit.quantity)) density = *value, warn_of_idle_unit(psd);
  else
    psd.error("flat", value_text(*given), value.error(),
              other_motion_advice(given->text, unit.quantity, psd.path(), true) + "give a number in " + unit.unit() +
                  ", or one with a unit");
  const bool is_number = psd.errors() == before;
  const std::optional<assembly::Band> band = read_band(psd, "band");
  if (!psd.has("band")) psd.missing("band", "give the band: band = [\"5 Hz\", \"500 Hz\"]");
  if (is_number && !(density > 0))
    psd.error("flat", fmt::format("{:.6g}", density), "a spectral density is > 0",
              "give it in " + unit.unit() + ", or with a unit");
  if (!band || !(density > 0)) return std::nullopt;
  return excitation::flat_spectrum(density / (2 * std::numbers::pi), band->from, band->to);
}

}  // namespace

std::optional<excitation::Spectrum> read_spectrum(TableReader& reader, const std::string& key,
                                                  const model::Action& action) {
  const Node* node = reader.node(key);
  if (!node) {
    reader.missing(key,
                   "give rows [[frequency in Hz, density per Hz], …], {file = \"psd.csv\"}, {bands = \"third-octave\", "
                   "levels = [[\"1 Hz\", \"2.1 µm/s rms\"], …]}, {road = \"C\", speed = "
                   "\"80 km/h\"} or {flat = …, band = […]}");
    return std::nullopt;
  }
  if (node->kind == Node::Kind::array) {
    const auto rows = read_pairs(reader, key, in_hertz(), density_of(course_quantity(action)));
    return rows ? spectrum_from_rows(reader, key, *rows, 1, false) : std::nullopt;
  }
  const Node* table = reader.table(key);
  if (!table) return std::nullopt;
  TableReader psd(*table, reader.path() + "." + key, reader.problems());
  std::optional<excitation::Spectrum> spectrum;
  if (psd.has("road")) {
    spectrum = read_road(psd, action);
  } else if (psd.has("bands")) {
    spectrum = read_band_levels(psd, action);
  } else if (psd.has("history")) {
    spectrum = read_measured_spectrum(psd, action);
  } else if (psd.has("flat")) {
    spectrum = read_flat(psd, read_density_unit(psd, action));
  } else {
    const bool linear = psd.choice("interpolation", {"logarithmic", "linear"}) == "linear";
    const ColumnQuantity unit = read_density_unit(psd, action);
    const auto rows = psd.has("rows") ? read_pairs(psd, "rows", in_hertz(), unit)
        : names_universal_file(psd)   ? read_power_spectral_density(psd, unit)
                                      : read_pairs_of_file(psd, "frequency_hz", "psd", in_hertz(), unit);
    if (rows) spectrum = spectrum_from_rows(psd, psd.has("rows") ? "rows" : "file", *rows, unit.bare, linear);
  }
  psd.finish();
  return spectrum;
}

}  // namespace trivet::project
