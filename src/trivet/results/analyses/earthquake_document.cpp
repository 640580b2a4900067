// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/results/format/result_writer.h"

/// Largest response to an earthquake.
namespace trivet::results {
namespace {

using response::CombinedChannel;
using response::EarthquakeResponse;

/// Modal maxima for all modes; NaN for a mode outside the spectrum.
std::vector<double> maxima_of_all_modes(const EarthquakeResponse& e, const CombinedChannel& a) {
  std::vector<double> maxima;
  Eigen::Index counted = 0;
  for (const response::ModalShare& m : e.modes)
    maxima.push_back(std::isnan(m.spectral_acceleration) ? nothing : a.modal_maxima(counted++));
  return maxima;
}

Table combined_table(const EarthquakeResponse& e) {
  const Rows row(e.channels);
  std::vector<std::string> modes;
  for (const response::ModalShare& m : e.modes) modes.push_back(fmt::format("{:.6g} Hz", hertz(m.angular_frequency)));
  return {.key = "results",
          .axis = "result",
          .plain_names = true,
          .file = "earthquake.csv",
          .title = "Earthquake response from the spectrum (motions relative to the ground, accelerations absolute)",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "result", &CombinedChannel::name),
                      row("unit", Kind::words, "", &CombinedChannel::unit),
                      row("srss", Kind::quantity, "SRSS", &CombinedChannel::square_root_of_sum_of_squares),
                      row("cqc", Kind::quantity, "CQC", &CombinedChannel::complete_quadratic),
                      row.lists("modal_maxima", "", "", {}, &CombinedChannel::modal_maxima, {.forms = in_json}),
                      row.lists("modal_maxima", "", "mode", modes,
                                [&e](const CombinedChannel& a) { return maxima_of_all_modes(e, a); },
                                {.unit = unit_of_the_row, .forms = in_csv | in_arrays})},
          .csv = {"name", "unit", "cqc", "srss", {"largest in mode at {}", "modal_maxima"}},
          .arrays = {{"result", "name"}, "unit", "cqc", "srss", "modal_maxima"}};
}

Table mode_shares(const EarthquakeResponse& e) {
  using response::ModalShare;
  const Rows row(e.modes);
  return {.key = "modes",
          .axis = "mode",
          .counted = false,
          .title = "Modes of the estimate (no spectral acceleration: beyond the spectrum)",
          .rows = row.size(),
          .columns = {row("angular_frequency", Kind::frequency, "f", &ModalShare::angular_frequency),
                      row("damping_ratio", Kind::number, "damping ratio", &ModalShare::damping_ratio, {.digits = 3}),
                      row("participation", Kind::number, "", &ModalShare::participation, {.unit = "√kg"}),
                      row("effective_mass", Kind::number, "effective mass", &ModalShare::effective_mass,
                          {.unit = "kg", .digits = 5}),
                      row("spectral_acceleration", Kind::number, "spectral acceleration",
                          &ModalShare::spectral_acceleration, {.unit = "m/s²", .digits = 5})},
          .height = [&e](std::size_t i) { return e.modes[i].effective_mass; },
          .folded = true};
}

Document earthquake_document(const project::Case&, const study::CaseResults& results) {
  const EarthquakeResponse& e = *results.earthquake;
  return {{{combined_table(e)},
           {mode_shares(e)},
           {Single{.name = "effective_mass_share", .value = e.effective_mass_share, .forms = in_json | in_arrays}},
           {Sentence{.parts = {"The spectrum covers modes with ", Quantity{e.effective_mass_share, "1", Kind::share},
                               " of the effective mass."},
                     .place = Sentence::Place::note}},
           {warnings_part(results)}}};
}

}  // namespace

const ResultWriter earthquake_results = {.document = earthquake_document, .files = {"earthquake.csv"}};

}  // namespace trivet::results
