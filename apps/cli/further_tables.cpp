// SPDX-License-Identifier: BSD-3-Clause
#include "cli/further_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cli/map_text.h"
#include "cli/text_table.h"
#include "trivet/foundation/constants.h"

namespace trivet::cli {
namespace {

using foundation::two_pi;
constexpr double worth_a_row = 0.01;

double hertz(double omega) { return omega / two_pi; }
double rpm(double omega) { return omega * 60 / two_pi; }
std::string mode_of(const std::optional<int>& mode) { return mode ? std::to_string(*mode) : "–"; }

/// ∞ where a number has no bound, NaN where there is none.
double bounded(const std::optional<double>& value, bool infinite) { return infinite ? std::numeric_limits<double>::infinity() : value.value_or(nothing); }

/// How the variances were found and how well, if any is finite.
std::string accuracy_text(const response::RandomResponse& random) {
  std::vector<double> errors;
  for (const response::RandomAnswer& a : random.answers)
    if (!std::isnan(a.estimated_error)) errors.push_back(a.estimated_error);
  if (errors.empty()) return "  no variance is finite, so none has an error\n";
  return fmt::format("  {}, relative error of the {} about {:.1e}{}\n",
                     random.method == response::RandomMethod::poles ? "exact integration over the poles" : "adaptive quadrature over the poles",
                     errors.size() == random.answers.size() ? "variances" : "finite variances", *std::max_element(errors.begin(), errors.end()),
                     random.remark.empty() ? "" : "; " + random.remark);
}

}  // namespace

std::string random_text(const study::Answers& answers) {
  const study::RandomResult& random = *answers.random;
  const auto& list = random.response.answers;
  const bool weighted = std::any_of(list.begin(), list.end(), [](const response::RandomAnswer& a) { return a.weighted_rms || a.infinite_weighted_rms; });
  std::vector<std::string> header = {"answer", "rms", "3σ", "unit", "zero crossings [1/s]"};
  if (weighted) header.push_back("weighted rms [m/s², rad/s²]");
  if (random.inputs.size() > 1)
    for (const std::string& input : random.inputs) header.push_back("from " + input);
  TextTable table(header);
  std::string reasons;
  for (const response::RandomAnswer& a : list) {
    std::vector<std::string> row = {a.name, shown(bounded(a.rms, a.infinite_rms)), shown(bounded(a.three_sigma, a.infinite_rms)), a.unit, shown(a.zero_crossings.value_or(nothing), 4)};
    if (weighted) row.push_back(shown(bounded(a.weighted_rms, a.infinite_weighted_rms)));
    for (std::size_t i = 0; i < random.inputs.size() && random.inputs.size() > 1; ++i) row.push_back(i < a.variance_share.size() ? percent(a.variance_share[i]) : "–");
    table.add(row);
    if (!a.reason.empty()) reasons += "  " + a.name + ": " + a.reason + "\n";
  }
  for (const study::TotalValue& total : random.total_values)
    reasons += fmt::format("  {}: vibration total value of the weighted accelerations {} m/s², of {}\n", total.name, shown(total.value, 4), fmt::join(total.axes, ", "));
  return fmt::format("Random response, {} to {} Hz\n", shown(hertz(random.response.from), 4), shown(hertz(random.response.to), 4)) + table.text() + reasons + accuracy_text(random.response);
}

std::string transient_text(const study::Answers& answers) {
  const response::TransientResponse& found = answers.transient->response;
  TextTable table({"answer", "largest", "at [s]", "smallest", "at [s]", "rms", "unit"});
  for (const response::TimeCurve& c : found.curves)
    table.add({c.name, shown(c.largest.value), shown(c.largest.time, 5), shown(c.smallest.value), shown(c.smallest.time, 5), shown(c.rms), c.unit});
  const Eigen::Index n = found.time.size();
  return fmt::format("Motion in time, {} to {} s in {} points\n", shown(found.time(0), 4), shown(found.time(n - 1), 4), n) + table.text();
}

std::string orders_text(const study::Answers& answers) {
  constexpr std::size_t most_rows = 40;
  const response::RunUp& run = answers.orders->run_up;
  std::vector<response::CriticalSpeed> tall;
  for (const response::CriticalSpeed& c : run.critical)
    if (!(c.relative_height < worth_a_row)) tall.push_back(c);
  std::stable_sort(tall.begin(), tall.end(), [](const auto& a, const auto& b) { return a.speed < b.speed; });
  TextTable table({"speed [rpm]", "order", "f [Hz]", "answer", "amplitude", "unit", "of its highest", "nearest mode"});
  for (std::size_t i = 0; i < std::min(most_rows, tall.size()); ++i) {
    const response::CriticalSpeed& c = tall[i];
    table.add({shown(rpm(c.speed)), shown(c.order, 4), shown(hertz(c.angular_frequency)), run.overall[c.curve].name, shown(c.amplitude), run.overall[c.curve].unit, percent(c.relative_height), mode_of(c.nearest_mode)});
  }
  std::string text = "Critical speeds (peaks of single orders above 1 % of the highest of their answer)\n" + (tall.empty() ? std::string("  none in the range\n") : table.text());
  if (tall.size() > most_rows) text += fmt::format("  (the first {} of {}; --csv or --json gives all)\n", most_rows, tall.size());
  TextTable overall({"answer", "highest rms of all orders", "at [rpm]", "unit"});
  for (const response::Overall& o : run.overall) overall.add({o.name, shown(o.highest_rms), shown(rpm(o.highest_rms_at)), o.unit});
  TextTable points({"speed [rpm]", "order", "f [Hz]", "mode", "share of the modal force", "excited"});
  for (const response::Interference& p : answers.orders->campbell.points)
    points.add({shown(rpm(p.speed)), shown(p.order, 4), shown(hertz(p.angular_frequency)), mode_of(p.mode), p.modal_force_share ? percent(*p.modal_force_share) : "–", p.excited ? "yes" : "no"});
  return text + overall.text() + (answers.orders->campbell.points.empty() ? "" : "Campbell diagram: orders meet natural frequencies\n" + points.text());
}

std::string transmissibility_text(const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.transmissibility;
  TextTable table({"answer", "highest |T|", "at [Hz]", "level [dB]", "isolates from [Hz]", "at the end of the band", "efficiency there"});
  for (std::size_t i = 0; i < t.curves.curves.size(); ++i) {
    const response::CurveSummary& summary = t.peaks.curves[i];
    const Eigen::VectorXcd& values = t.curves.curves[i].value;
    const double last = std::abs(values(values.size() - 1));
    table.add({summary.name, shown(summary.highest), shown(hertz(summary.highest_at), 5), shown(response::transmissibility_level(summary.highest), 4),
               t.crossovers[i].angular_frequency && !t.is_share(i) ? shown(hertz(*t.crossovers[i].angular_frequency), 5) : "–", shown(last, 4),
               t.is_share(i) ? "–" : percent(response::isolation_efficiency(last))});
  }
  const std::string shares = t.is_share(1) ? "  the force of a single mount is its share: isolation is that of the ground\n" : "";
  return "Transmissibility: " + t.words + "\n" + table.text() + shares;
}

std::string power_text(const study::Answers& answers) {
  const response::PowerFlow& p = *answers.power;
  if (p.angular_frequency.empty()) return "";
  TextTable table({"mount", "highest power into the ground [W]", "at [Hz]"});
  const auto add = [&](const std::string& name, const Eigen::VectorXd& power) {
    Eigen::Index at = 0;
    const double highest = power.maxCoeff(&at);
    table.add({name, shown(highest), shown(hertz(p.angular_frequency[static_cast<std::size_t>(at)]), 5)});
  };
  for (std::size_t m = 0; m < p.mounts.size(); ++m) add(p.mounts[m], p.into_ground.row(static_cast<Eigen::Index>(m)).transpose());
  add("in total", p.into_ground_in_total);
  return "Mean power into the ground (negative: out of it)\n" + table.text();
}

std::string shapes_text(const study::Answers& answers) {
  std::string text;
  for (const response::DeflectionShape& shape : answers.shapes) {
    TextTable table({"place", "|x| [m]", "|y| [m]", "|z| [m]", "phase x", "phase y", "phase z"});
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) {
        std::vector<std::string> row = {p.name};
        for (int j = 0; j < 3; ++j) row.push_back(shown(std::abs(p.motion(j))));
        for (int j = 0; j < 3; ++j) row.push_back(std::abs(p.motion(j)) > 0 ? fmt::format("{:.1f}°", std::arg(p.motion(j)) * 180 / std::numbers::pi) : "–");
        table.add(row);
      }
    text += fmt::format("Operating deflection shape at {} Hz, largest excursion {} m\n", shown(hertz(shape.angular_frequency)), shown(shape.largest_excursion)) + table.text();
  }
  return text;
}

std::string shock_spectrum_text(const study::Answers& answers) {
  constexpr std::size_t most_rows = 24;
  std::string text;
  for (const study::ShockSpectrumResult& spectrum : answers.shock_spectra) {
    TextTable table({"natural frequency [Hz]", "largest [m/s²]", "smallest [m/s²]", "pseudo velocity [m/s]", "relative displacement [m]"});
    const std::size_t step = (spectrum.spectrum.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < spectrum.spectrum.size(); i += step) {
      const excitation::ShockResponse& r = spectrum.spectrum[i];
      table.add({shown(hertz(r.angular_frequency), 5), shown(r.largest()), shown(r.smallest()), shown(r.pseudo_velocity()), shown(r.relative_displacement)});
    }
    text += fmt::format("Shock response spectrum of {}, damping ratio {:.4g} (absolute acceleration)\n", spectrum.excitation, spectrum.damping_ratio) + table.text();
  }
  return text;
}

std::string earthquake_text(const study::Answers& answers) {
  const response::EarthquakeResponse& e = *answers.earthquake;
  TextTable modes({"f [Hz]", "damping ratio", "effective mass [kg]", "S_a [m/s²]"});
  for (const response::ModalShare& m : e.modes) modes.add({shown(hertz(m.angular_frequency), 5), shown(m.damping_ratio, 3), shown(m.effective_mass, 5), shown(m.spectral_acceleration, 5)});
  TextTable table({"answer", "CQC", "SRSS", "unit"});
  for (const response::CombinedAnswer& a : e.answers) table.add({a.name, shown(a.complete_quadratic), shown(a.square_root_of_sum_of_squares), a.unit});
  return "Earthquake by its response spectrum (motions against the ground, accelerations absolute)\n" + modes.text() + table.text() +
         fmt::format("  the spectrum reaches modes with {} of the effective mass\n", percent(e.effective_mass_share));
}

std::string limit_lines_text(const study::Answers& answers) {
  if (answers.limit_lines.empty()) return "";
  TextTable table({"limit line", "answer", "least margin [dB]", "at [Hz]", "exceeded [Hz]", "verdict"});
  for (const study::LimitLineResult& l : answers.limit_lines) {
    std::string bands;
    for (const response::Band& band : l.comparison.exceeded) bands += (bands.empty() ? "" : ", ") + fmt::format("{:.4g} … {:.4g}", hertz(band.from), hertz(band.to));
    table.add({l.line.name, l.of, shown(response::margin_level(l.comparison.least_margin), 4), shown(hertz(l.comparison.least_margin_at), 5), bands.empty() ? "–" : bands, l.comparison.kept() ? "kept" : "EXCEEDED"});
  }
  return "Limit lines\n" + table.text();
}

std::string load_sharing_text(const study::Answers& answers) {
  TextTable table({"mount", "bears [N]", "share", "deflection x [m]", "y [m]", "z [m]"});
  for (const response::MountLoad& m : answers.load_sharing->mounts)
    table.add({m.element, shown(m.bearing), percent(m.share), shown(m.deflection(0), 4), shown(m.deflection(1), 4), shown(m.deflection(2), 4)});
  return "Load sharing (deflection of end K against N in the element's axes)\n" + table.text();
}

std::string further_text(const study::Answers& answers) {
  std::string text;
  const auto add = [&](bool there, const auto& render) {
    if (there) text += render(answers) + "\n";
  };
  add(answers.load_sharing.has_value(), load_sharing_text);
  add(answers.random.has_value(), random_text);
  add(answers.transient.has_value(), transient_text);
  add(answers.orders.has_value(), orders_text);
  add(answers.transmissibility.has_value(), transmissibility_text);
  add(answers.power.has_value(), power_text);
  add(!answers.shapes.empty(), shapes_text);
  add(!answers.shock_spectra.empty(), shock_spectrum_text);
  add(answers.earthquake.has_value(), earthquake_text);
  add(!answers.limit_lines.empty(), limit_lines_text);
  if (answers.map) text += map_text(*answers.map) + "\n";
  return text;
}

}  // namespace trivet::cli
