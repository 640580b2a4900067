// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/report/answer_tables.h"
#include "trivet/report/html_table.h"
#include "trivet/response/transient/earthquake.h"
#include "trivet/study/shock_spectrum_answer.h"

namespace trivet::report {

std::string shock_table(const study::Answers& answers) {
  const auto* spectra = answers.find<std::vector<study::ShockSpectrumResult>>("shock_spectrum");
  if (!spectra) return "";
  std::vector<std::vector<Cell>> rows;
  const auto unit = [&](const char* si_unit) { return results::display_unit(answers.display, si_unit); };
  for (const study::ShockSpectrumResult& s : *spectra) {
    if (s.spectrum.empty()) continue;
    const auto most = [&](const auto& value_of) {
      return *std::max_element(s.spectrum.begin(), s.spectrum.end(),
                               [&](const auto& a, const auto& b) { return value_of(a) < value_of(b); });
    };
    const auto up = most([](const auto& r) { return r.largest(); }),
               down = most([](const auto& r) { return -r.smallest(); });
    const auto far = most([](const auto& r) { return r.relative_displacement; }),
               fast = most([](const auto& r) { return r.pseudo_velocity(); });
    rows.push_back({{s.excitation},
                    number_cell(s.damping_ratio),
                    quantity_cell(up.largest(), unit(s.unit.c_str())),
                    frequency_cell(up.angular_frequency, answers.display),
                    quantity_cell(down.smallest(), unit(s.unit.c_str())),
                    frequency_cell(down.angular_frequency, answers.display),
                    quantity_cell(fast.pseudo_velocity(), unit("m/s")),
                    quantity_cell(far.relative_displacement, unit("m"))});
  }
  return html_table({{"excitation"},
                     right("damping ratio"),
                     right("positive maximax"),
                     frequency_cell_heading("at", answers.display),
                     right("negative maximax"),
                     frequency_cell_heading("at", answers.display),
                     right("largest pseudo-velocity"),
                     right("largest relative displacement")},
                    rows);
}

std::string earthquake_tables(const study::Answers& answers) {
  const auto* found = answers.find<response::EarthquakeResponse>("earthquake");
  if (!found) return "";
  const response::EarthquakeResponse& e = *found;
  const results::DisplayUnit mass = results::display_unit(answers.display, "kg"),
                             acceleration = results::display_unit(answers.display, "m/s²");
  std::vector<std::vector<Cell>> rows, modes;
  for (const response::CombinedAnswer& a : e.answers)
    rows.push_back({{a.name},
                    quantity_cell(a.complete_quadratic, results::display_unit(answers.display, a.unit)),
                    quantity_cell(a.square_root_of_sum_of_squares, results::display_unit(answers.display, a.unit))});
  for (const response::ModalShare& m : e.modes)
    modes.push_back({frequency_cell(m.angular_frequency, answers.display), number_cell(m.damping_ratio),
                     number_cell(m.effective_mass * mass.factor),
                     std::isfinite(m.spectral_acceleration) ? quantity_cell(m.spectral_acceleration, acceleration)
                                                            : right("beyond the spectrum")});
  return html_table({{"result"}, right("CQC"), right("SRSS")}, rows) +
      hint(fmt::format("Estimated largest values. The modes within the spectrum have {:.1f} % of the effective mass.",
                       100 * e.effective_mass_share)) +
      folded("Modes of the estimate",
             html_table({frequency_cell_heading("f", answers.display), right("damping ratio"),
                         right("effective mass [" + mass.unit + "]"), right("spectral acceleration")},
                        modes));
}

std::string limit_line_table(const study::Answers& answers) {
  if (answers.limit_lines.empty()) return "";
  std::vector<std::vector<Cell>> rows;
  const auto in_unit = [&](double omega) { return results::shown_frequency(answers.display, omega); };
  const std::string in_frequency = " [" + results::frequency_unit(answers.display) + "]";
  for (const study::LimitLineResult& l : answers.limit_lines) {
    const response::LimitComparison& c = l.comparison;
    std::string bands;
    for (const assembly::Band& band : c.exceeded)
      bands += fmt::format("{}{:.4g} … {:.4g}", bands.empty() ? "" : ", ", in_unit(band.from), in_unit(band.to));
    rows.push_back({{l.of},
                    {l.line.name},
                    {fmt::format("{:.4g} … {:.4g}", in_unit(c.compared.from), in_unit(c.compared.to))},
                    number_cell(response::margin_level(c.least_margin)),
                    frequency_cell(c.least_margin_at, answers.display),
                    {bands.empty() ? "–" : bands},
                    verdict_cell(c.met(), "met", "EXCEEDED")});
  }
  return html_table({{"result"},
                     {"limit line"},
                     {"compared" + in_frequency},
                     right("least margin [dB]"),
                     frequency_cell_heading("at", answers.display),
                     {"exceeded" + in_frequency},
                     {"verdict"}},
                    rows);
}

std::string load_sharing_table(const study::Answers& answers) {
  if (!answers.load_sharing) return "";
  std::vector<std::vector<Cell>> rows;
  const results::DisplayUnit force = results::display_unit(answers.display, "N"),
                             length = results::display_unit(answers.display, "m");
  results::LargestOfKind largest;
  for (const response::MountLoad& m : answers.load_sharing->mounts) {
    largest.add("N", m.bearing);
    for (const double deflection : m.deflection) largest.add("m", deflection);
  }
  for (const response::MountLoad& m : answers.load_sharing->mounts) {
    std::vector<Cell> row = {{m.element}, quantity_cell(largest.shown("N", m.bearing), force), percent_cell(m.share)};
    if (m.bearing < 0) row.back().tone = Tone::bad;
    for (int j = 0; j < 3; ++j) row.push_back(quantity_cell(largest.shown("m", m.deflection(j)), length));
    rows.push_back(std::move(row));
  }
  return html_table({{"mount"}, right("load"), right("share"), right("deflection x"), right("y"), right("z")}, rows) +
      hint(fmt::format("Along gravity, {:.5g} {} in total; a mount with a negative share pulls down. Deflections of "
                       "end K relative to N in the element's axes.",
                       answers.load_sharing->bearing_in_total * force.factor, force.unit));
}

}  // namespace trivet::report
