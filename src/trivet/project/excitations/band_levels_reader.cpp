// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/excitations/band_levels_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "trivet/excitation/frequency_bands.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/text/bands_reader.h"
#include "trivet/project/text/pairs_reader.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

using excitation::FrequencyBand;

constexpr const char* levels_example = "levels = [[\"1 Hz\", \"2.1 µm/s rms\"], [\"1.25 Hz\", \"1.8 µm/s rms\"]]";

/// What levels of the excitation may measure, by the order of the derivative: one for a force.
std::vector<Quantity> level_quantities(const model::Action& action) {
  const Quantity own = course_quantity(action);
  if (action.body) return {own};
  if (own == Quantity::length || own == Quantity::velocity || own == Quantity::acceleration)
    return {Quantity::length, Quantity::velocity, Quantity::acceleration};
  return {Quantity::angle, Quantity::angular_velocity, Quantity::angular_acceleration};
}

std::string allowed_units(const std::vector<Quantity>& quantities) {
  std::string words;
  for (const Quantity quantity : quantities) words += (words.empty() ? "" : " or ") + printed_si_unit(quantity);
  return words;
}

/// Levels in SI with their midband frequencies [Hz].
struct MeasuredLevels {
  std::size_t quantity = 0;  ///< place in `level_quantities`
  std::vector<double> hertz, levels;
};

class LevelReader {
 public:
  LevelReader(TableReader& psd, const model::Action& action) : psd_(psd), quantities_(level_quantities(action)) {}

  std::optional<MeasuredLevels> rows() {
    const Node* list = psd_.node("levels");
    if (list->kind != Node::Kind::array || list->items.empty()) {
      refuse("levels", "no rows", "levels are rows of a midband frequency and a level", levels_example);
      return std::nullopt;
    }
    MeasuredLevels found;
    std::optional<std::size_t> quantity = of_unit_key();
    const double bare = quantity ? read_bare_unit(psd_, column_of(*quantity)).bare : 1;
    const std::size_t before = psd_.errors();
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      const Node& row = list->items[i];
      if (row.kind != Node::Kind::array || row.items.size() != 2) {
        refuse("levels", fmt::format("row {} is not a pair", i + 1),
               "levels are rows of a midband frequency and a level", levels_example);
        return std::nullopt;
      }
      found.hertz.push_back(frequency(row.items[0], i));
      found.levels.push_back(level(row.items[1], i, bare, quantity));
    }
    if (psd_.errors() > before) return std::nullopt;
    if (!quantity) {  // only bare zeros
      refuse("levels", "no level has a unit", "the unit states what the levels measure", levels_example);
      return std::nullopt;
    }
    found.quantity = *quantity;
    return found;
  }

  std::optional<MeasuredLevels> file() {
    const std::size_t before = psd_.errors();
    auto quantity = of_heading();
    if (!quantity && psd_.errors() == before) quantity = of_unit_key();
    if (!quantity) {
      if (!psd_.has("unit") && psd_.errors() == before)
        refuse("file", "levels without a unit", "the unit states what the levels measure",
               "head the column \"level [µm/s]\", or add unit = \"µm/s\"");
      return std::nullopt;
    }
    const ColumnQuantity column = read_bare_unit(psd_, column_of(*quantity));
    const auto pairs = read_pairs_of_file(psd_, "frequency_hz", "level", in_hertz(), column);
    if (!pairs) return std::nullopt;
    MeasuredLevels found{*quantity, {}, {}};
    found.hertz.assign(pairs->col(0).begin(), pairs->col(0).end());
    for (const double value : pairs->col(1)) found.levels.push_back(column.bare * value);
    return found;
  }

  /// The quantity of a level in terms of derivatives of the displacement; 0 of a force.
  [[nodiscard]] int order(std::size_t quantity) const { return static_cast<int>(quantity); }

 private:
  [[nodiscard]] ColumnQuantity column_of(std::size_t quantity) const {
    return ColumnQuantity(quantities_[quantity]).at_levels(Levels::of_random, Level::rms);
  }

  void refuse(const std::string& key, std::string finding, std::string rule, std::string remedy) {
    psd_.error(key, std::move(finding), std::move(rule), std::move(remedy));
  }

  std::optional<std::size_t> of_unit(const std::string& unit) const {
    for (std::size_t q = 0; q < quantities_.size(); ++q)
      if (to_si("1 " + split_level(unit).number, quantities_[q])) return q;
    return std::nullopt;
  }

  std::optional<std::size_t> of_unit_key() {
    const auto unit = psd_.text("unit");
    if (!unit) return std::nullopt;
    const auto found = of_unit(*unit);
    if (!found)
      refuse("unit", foundation::quoted(*unit), "levels of this excitation are in " + allowed_units(quantities_),
             "name such a unit, or a multiple");
    return found;
  }

  /// From "level [µm/s]" in the heading of the file.
  std::optional<std::size_t> of_heading() {
    const auto file = read_file_name(psd_, "file");
    const std::string wanted = psd_.text("level").value_or("level");
    if (!file) return std::nullopt;
    const auto csv = read_csv_table(*file, most_rows_over_frequency);
    if (!csv) return std::nullopt;  // reported when it is read
    for (const std::string& column : csv->columns)
      if (const UnitHeading heading = unit_heading(column);
          !heading.unit.empty() && (heading.name == wanted || column == wanted))
        return of_stated_unit(heading.unit, column);
    if (csv->columns.size() > 1 && psd_.has("level") && std::ranges::find(csv->columns, wanted) == csv->columns.end())
      refuse("level", foundation::quoted(wanted), "the file has no such column",
             "its columns are " + foundation::comma_separated(csv->columns));
    return std::nullopt;
  }

  /// "µm/s", "µm/s rms"; refuses other levels and units of other quantities.
  std::optional<std::size_t> of_stated_unit(const std::string& unit, const std::string& column) {
    const LevelledText split = split_level(unit);
    const auto reason = split.level ? reason_against(Levels::of_random, *split.level) : std::nullopt;
    const auto found = of_unit(split.number);
    if (reason) refuse("file", foundation::quoted(column), *reason, "give root mean squares");
    else if (!found)
      refuse("file", foundation::quoted(column), "levels of this excitation are in " + allowed_units(quantities_),
             "convert the column, and name such a unit or a multiple");
    return reason ? std::nullopt : found;
  }

  double frequency(const Node& cell, std::size_t row) {
    if (cell.kind != Node::Kind::text)
      return psd_.scalar(cell, fmt::format("{}.levels[{}][0]", psd_.path(), row), Quantity::pure).value_or(1);
    const auto omega = to_si(cell.text, Quantity::angular_frequency);
    if (!omega)
      refuse("levels", fmt::format("{} in row {}", value_text(cell), row + 1), omega.error(),
             "give the midband frequency, for instance \"12.5 Hz\"");
    return omega ? *omega / foundation::two_pi : 1;
  }

  /// @param quantity  of the levels before; set by the first with a unit
  double level(const Node& cell, std::size_t row, double bare, std::optional<std::size_t>& quantity) {
    const std::string where = fmt::format("{}.levels[{}][1]", psd_.path(), row);
    if (cell.kind != Node::Kind::text) {
      const double value = psd_.scalar(cell, where, Quantity::pure).value_or(0);
      if (value != 0 && !psd_.has("unit"))
        refuse("levels", fmt::format("{:.6g} without a unit in row {}", value, row + 1),
               "the unit states what the levels measure", "write \"2.1 µm/s rms\", or add unit = \"µm/s\"");
      return bare * value;
    }
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      const auto value = to_si_at_level(cell.text, quantities_[q], Levels::of_random, Level::rms);
      if (!value) continue;
      if (quantity.value_or(q) != q)
        refuse("levels",
               fmt::format("{} in row {} after levels in {}", value_text(cell), row + 1,
                           printed_si_unit(quantities_[*quantity])),
               "all levels measure one quantity", "convert them to one");
      quantity = q;
      return *value;
    }
    refuse("levels", fmt::format("{} in row {}", value_text(cell), row + 1),
           to_si_at_level(cell.text, quantities_.front(), Levels::of_random, Level::rms).error(),
           "give a root mean square in " + allowed_units(quantities_) + ", or a multiple");
    return 0;
  }

  TableReader& psd_;
  std::vector<Quantity> quantities_;
};

/// The bands of the levels: those of their midband frequencies, one after the other.
std::optional<std::vector<FrequencyBand>> bands_of(TableReader& psd, const std::string& key,
                                                   excitation::BandWidth width, const MeasuredLevels& measured) {
  std::vector<FrequencyBand> bands;
  const auto refuse = [&](std::string finding, std::string rule, std::string remedy) {
    psd.error(key, std::move(finding), std::move(rule), std::move(remedy));
    return std::nullopt;
  };
  for (std::size_t i = 0; i < measured.hertz.size(); ++i) {
    const double hertz = measured.hertz[i];
    constexpr double lowest = 1e-6, highest = 1e9;  // [Hz]
    if (!(hertz >= lowest && hertz <= highest))
      return refuse(fmt::format("a midband frequency of {:.6g} Hz in row {}", hertz, i + 1),
                    "midband frequencies are from 1e-6 to 1e9 Hz", "check the unit");
    const auto band = excitation::band_of(width, hertz);
    if (!band)
      return refuse(fmt::format("{:.6g} Hz in row {}", hertz, i + 1),
                    fmt::format("this is no midband frequency of {} bands (IEC 61260-1)", name(width)),
                    fmt::format("the nearest is {:.6g} Hz", excitation::nearest_band(width, hertz).nominal_hz()));
    if (!bands.empty() && band->index != bands.back().index + 1)
      return refuse(fmt::format("{:.6g} Hz in row {} after {:.6g} Hz", hertz, i + 1, bands.back().nominal_hz()),
                    "bands follow each other without a gap",
                    fmt::format("the next is {:.6g} Hz; a band where nothing was measured has the level 0",
                                FrequencyBand{width, bands.back().index + 1}.nominal_hz()));
    if (!(measured.levels[i] >= 0))
      return refuse(fmt::format("a level of {:.6g} in row {}", measured.levels[i], i + 1), "levels are not negative",
                    "root mean squares are meant, not decibels");
    bands.push_back(*band);
  }
  return bands;
}

}  // namespace

std::optional<excitation::Spectrum> read_band_levels(TableReader& psd, const model::Action& action) {
  const auto width = read_bands(psd, "bands");
  LevelReader reader(psd, action);
  const bool in_file = psd.has("file"), in_rows = psd.has("levels");
  if (in_file == in_rows) {
    psd.error("bands", in_file ? "levels and a file" : "bands without levels",
              "the levels of the bands are in the project or in a file",
              in_file ? "keep one" : std::string("add ") + levels_example);
    psd.also_known({"levels", "file", "level", "frequency_hz", "unit"});
    return std::nullopt;
  }
  const auto measured = in_file ? reader.file() : reader.rows();
  if (!measured || !width) return std::nullopt;
  const std::string key = in_file ? "file" : "levels";
  const auto bands = bands_of(psd, key, *width, *measured);
  if (!bands) return std::nullopt;
  excitation::Spectrum spectrum = excitation::spectrum_of_levels(*bands, measured->levels);
  if (spectrum.pieces.empty()) {
    psd.error(key, "all levels are 0", "an excitation has a level above 0 in one band", "give the measured levels");
    return std::nullopt;
  }
  return action.body ? spectrum : differentiated(spectrum, action.derivative - reader.order(measured->quantity));
}

}  // namespace trivet::project
