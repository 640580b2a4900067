// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/excitations/measured_spectrum_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "trivet/excitation/measured_spectrum.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/pairs_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// A record whose times are printed with few digits is even to this share of a step.
constexpr double rounded_times = 0.01;

/// Above it, the error of one line is worth a warning.
constexpr double large_line_error = 0.3;

/// Step of a record [s]; none after an error.
std::optional<double> even_step(TableReader& history, const Eigen::MatrixXd& rows) {
  const char* key = history.has("rows") ? "rows" : "file";
  const double first = rows(0, 0), last = rows(rows.rows() - 1, 0);
  const double step = (last - first) / static_cast<double>(rows.rows() - 1);
  if (!(step > 0)) {
    history.error(key, fmt::format("the last time is {:.6g} s, the first one {:.6g} s", last, first), "times increase",
                  "sort the record");
    return std::nullopt;
  }
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    if (const double even = first + static_cast<double>(i) * step;
        !(std::abs(rows(i, 0) - even) < rounded_times * step)) {
      history.error(key, fmt::format("row {}: {:.9g} s; at equal steps it would be {:.9g} s", i + 1, rows(i, 0), even),
                    "a spectral density is computed from samples at equal times", "resample the record");
      return std::nullopt;
    }
  return step;
}

void warn_of_few_segments(TableReader& psd, const excitation::MeasuredSpectrum& found) {
  if (found.line_error > large_line_error)
    warn_at_key(psd, "resolution",
                fmt::format("{} segments of {:.6g} s fit into the record", found.segments, 1 / found.resolution_hz),
                fmt::format("a line of the density is known to ± {:.0f} % only", 100 * found.line_error),
                "measure longer, or take a coarser resolution");
}

std::optional<excitation::Spectrum> density_of_record(TableReader& psd, TableReader& history,
                                                      const Eigen::MatrixXd& rows, double unit, double resolution) {
  const auto step = even_step(history, rows);
  if (!step) return std::nullopt;
  std::vector<double> values;
  for (const double value : rows.col(1)) values.push_back(unit * value);
  try {
    const excitation::MeasuredSpectrum found =
        excitation::measured_spectrum(values, *step, resolution / foundation::two_pi);
    if (found.table.frequencies_hz.size() > most_rows_over_frequency) {
      psd.error("resolution", fmt::format("{} lines", found.table.frequencies_hz.size()),
                fmt::format("a density has at most {}", most_rows_over_frequency), "take a coarser resolution");
      return std::nullopt;
    }
    const foundation::Problems findings = excitation::check(found.table, history.path());
    psd.add(findings);
    if (findings.has_errors()) return std::nullopt;
    warn_of_few_segments(psd, found);
    return excitation::from_table(found.table);
  } catch (const foundation::InvalidInput& wrong) {
    psd.error("resolution", wrong.what(), "segments fit into the record",
              "measure longer, or take a coarser resolution");
    return std::nullopt;
  }
}

}  // namespace

std::optional<excitation::Spectrum> read_measured_spectrum(TableReader& psd, const model::Action& action) {
  const double resolution = psd.required_number("resolution", Quantity::angular_frequency);
  if (psd.has("resolution") && !(resolution > 0))
    psd.error("resolution", fmt::format("{:.6g} Hz", resolution / foundation::two_pi), "the distance of lines is > 0",
              "for instance \"0.25 Hz\"");
  const Node* table = psd.table("history");
  if (!table) return std::nullopt;
  TableReader history(*table, psd.path() + ".history", psd.problems());
  const ColumnQuantity value = read_bare_unit(history, course_quantity(action));
  const auto rows = read_rows_over_time(history, value);
  history.finish();
  if (!rows || !(resolution > 0)) return std::nullopt;
  return density_of_record(psd, history, *rows, value.bare, resolution);
}

}  // namespace trivet::project
