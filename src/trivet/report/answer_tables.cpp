// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/answer_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/report/answer_figures.h"
#include "trivet/report/html_table.h"
#include "trivet/report/svg_canvas.h"
#include "trivet/response/machinery/power.h"
#include "trivet/study/orders_answer.h"
#include "trivet/study/random_answer.h"
#include "trivet/study/transient_answer.h"
#include "trivet/study/transmissibility_answer.h"

namespace trivet::report {
namespace {

using foundation::rpm_per_rad_s;

std::string remark(const response::RandomAnswer& answer) { return answer.vanishes ? "below round-off" : answer.reason; }

bool weighted(const study::RandomResult& random) {
  return std::any_of(random.response.answers.begin(), random.response.answers.end(),
                     [](const auto& a) { return a.weighted_rms || a.infinite_weighted_rms; });
}

/// Unit of the acceleration: m → m/s², m/s → m/s² …
std::string acceleration_unit(const std::string& unit) { return unit.starts_with("rad") ? "rad/s²" : "m/s²"; }

}  // namespace

std::string random_table(const study::Answers& answers) {
  const auto* found = answers.find<study::RandomResult>("random");
  if (!found) return "";
  const study::RandomResult& random = *found;
  const bool has_weights = weighted(random), has_shares = random.inputs.size() > 1;
  const bool has_remarks = std::any_of(random.response.answers.begin(), random.response.answers.end(),
                                       [](const auto& a) { return !remark(a).empty(); });
  std::vector<Cell> headings = {{"result"}, right("rms"), right("3σ"), right("upward zero crossings [1/s]")};
  if (has_weights) headings.push_back(right("weighted rms"));
  if (has_shares)
    for (const std::string& input : random.inputs) headings.push_back(right("variance from " + input));
  if (has_remarks) headings.push_back({"remark"});
  std::vector<std::vector<Cell>> rows;
  for (const response::RandomAnswer& a : random.response.answers) {
    const auto bounded_cell = [&](const std::optional<double>& value, bool infinite, const std::string& unit) {
      return value ? quantity_cell(*value, results::display_unit(answers.display, unit)) : right(infinite ? "∞" : "–");
    };
    std::vector<Cell> row = {{a.name},
                             bounded_cell(a.rms, a.infinite_rms, a.unit),
                             bounded_cell(a.three_sigma, a.infinite_rms, a.unit),
                             a.zero_crossings ? number_cell(*a.zero_crossings) : right("–")};
    if (has_weights) row.push_back(bounded_cell(a.weighted_rms, a.infinite_weighted_rms, acceleration_unit(a.unit)));
    if (has_shares)
      for (std::size_t i = 0; i < random.inputs.size(); ++i)
        row.push_back(i < a.variance_share.size() && !a.vanishes ? percent_cell(a.variance_share[i]) : right("–"));
    if (has_remarks) row.push_back({remark(a)});
    rows.push_back(std::move(row));
  }
  const bool by_poles = random.response.method == response::RandomMethod::poles;
  return html_table(headings, rows) +
      hint(fmt::format(
          "RMS values over {:.4g} … {:.4g} {}, {}.{}", results::shown_frequency(answers.display, random.response.from),
          results::shown_frequency(answers.display, random.response.to), results::frequency_unit(answers.display),
          by_poles ? "integrated in closed form over the poles" : "by quadrature with controlled error",
          random.response.remark.empty() ? "" : " " + random.response.remark));
}

std::string transient_table(const study::Answers& answers) {
  const auto* transient = answers.find<study::TransientResult>("transient");
  if (!transient) return "";
  std::vector<std::vector<Cell>> rows;
  results::LargestOfKind largest;
  for (const response::TimeCurve& c : transient->response.curves)
    for (const double value : {c.largest.value, c.smallest.value}) largest.add(c.unit, value);
  for (const response::TimeCurve& c : transient->response.curves) {
    const results::DisplayUnit unit = results::display_unit(answers.display, c.unit);
    if (is_round_off(transient->response, c)) {
      rows.push_back({{c.name}, right("≈ 0"), right("–"), right("≈ 0"), right("–"), right("≈ 0")});
      continue;
    }
    rows.push_back({{c.name},
                    quantity_cell(largest.shown(c.unit, c.largest.value), unit),
                    quantity_cell(c.largest.time, "s"),
                    quantity_cell(largest.shown(c.unit, c.smallest.value), unit),
                    quantity_cell(c.smallest.time, "s"),
                    quantity_cell(largest.shown(c.unit, c.rms), unit)});
  }
  return html_table(
             {{"result"}, right("largest"), right("at"), right("smallest"), right("at"), right("rms over the time")},
             rows) +
      hint("Relative to the position of rest. The extremes are those of the exact motion, also between the time "
           "points.");
}

std::string run_up_tables(const study::Answers& answers) {
  const auto* orders = answers.find<study::OrdersResult>("orders");
  if (!orders) return "";
  const response::RunUp& run_up = orders->run_up;
  std::vector<std::vector<Cell>> rows;
  for (const response::CriticalSpeed& c : run_up.critical) {
    const response::Overall& curve = run_up.overall[c.curve];
    if (std::isfinite(c.amplitude) && c.relative_height < study::listed_height) continue;
    rows.push_back({{curve.name},
                    number_cell(c.order),
                    number_cell(c.speed * rpm_per_rad_s, 5),
                    frequency_cell(c.angular_frequency, answers.display),
                    quantity_cell(c.amplitude, results::amplitude_unit(answers.display, curve.unit)),
                    percent_cell(c.relative_height),
                    right(c.nearest_mode ? std::to_string(*c.nearest_mode) : "–")});
  }
  std::vector<std::vector<Cell>> points;
  for (const response::Interference& p : orders->campbell.points)
    points.push_back({right(p.mode ? std::to_string(*p.mode) : "–"),
                      number_cell(p.order),
                      number_cell(p.speed * rpm_per_rad_s, 5),
                      frequency_cell(p.angular_frequency, answers.display),
                      p.modal_force_share ? percent_cell(*p.modal_force_share) : right("–"),
                      {p.excited ? "yes" : "no"}});
  return html_table({{"result"},
                     right("order"),
                     right("critical speed [rpm]"),
                     frequency_cell_heading("f", answers.display),
                     right("amplitude"),
                     right("of its highest"),
                     right("nearest mode")},
                    rows) +
      hint("Peaks of single orders over the speed, except those below 1 % of the highest peak of the same result.") +
      folded("Interference points: intersections of orders and natural frequencies",
             html_table({right("mode"),
                         right("order"),
                         right("speed [rpm]"),
                         frequency_cell_heading("f", answers.display),
                         right("modal force share"),
                         {"excited"}},
                        points));
}

std::string transmissibility_table(const study::Answers& answers) {
  const auto* found = answers.find<study::TransmissibilityResult>("transmissibility");
  if (!found) return "";
  const study::TransmissibilityResult& t = *found;
  std::vector<std::vector<Cell>> rows;
  for (std::size_t i = 0; i < t.curves.curves.size(); ++i) {
    const response::Curve& c = t.curves.curves[i];
    std::vector<Cell> row = {{c.name}};
    const auto summary =
        std::find_if(t.peaks.curves.begin(), t.peaks.curves.end(), [&](const auto& s) { return s.name == c.name; });
    row.push_back(summary == t.peaks.curves.end() ? right("–")
                                                  : number_cell(response::transmissibility_level(summary->highest)));
    row.push_back(summary == t.peaks.curves.end() ? right("–") : frequency_cell(summary->highest_at, answers.display));
    const bool known = i < t.crossovers.size() && t.crossovers[i].angular_frequency;
    row.push_back(t.is_share(i) ? right("–")
                      : !known  ? right("none")
                      : *t.crossovers[i].angular_frequency == 0
                      ? right("everywhere")
                      : frequency_cell(*t.crossovers[i].angular_frequency, answers.display));
    const double last = c.value.size() > 0 ? std::abs(c.value(c.value.size() - 1)) : 0;
    row.push_back(number_cell(response::transmissibility_level(last)));
    row.push_back(t.is_share(i) ? right("–") : percent_cell(response::isolation_efficiency(last)));
    rows.push_back(std::move(row));
  }
  const std::string end = t.curves.angular_frequency.empty()
      ? ""
      : fmt::format(" at {:.4g} {}", results::shown_frequency(answers.display, t.curves.angular_frequency.back()),
                    results::frequency_unit(answers.display));
  return "<p>" + escaped(t.words) + "</p>\n" +
      html_table({{"result"},
                  right("highest [dB]"),
                  frequency_cell_heading("at", answers.display),
                  frequency_cell_heading("isolates above", answers.display),
                  right("level" + end + " [dB]"),
                  right("isolation efficiency there")},
                 rows);
}

std::string power_table(const study::Answers& answers) {
  const auto* found = answers.find<response::PowerFlow>("power");
  if (!found || found->angular_frequency.empty() || found->mounts.empty()) return "";
  const response::PowerFlow& p = *found;
  results::LargestOfKind largest;
  for (const double power : p.by_forces) largest.add("W", power);
  for (const double power : p.by_ground) largest.add("W", power);
  const auto row = [&](const std::string& name, const Eigen::VectorXd& power) {
    Eigen::Index at = 0;
    const double most = power.maxCoeff(&at), total = p.into_ground_in_total(at),
                 fed = p.by_forces(at) + std::max(p.by_ground(at), 0.0);
    return std::vector<Cell>{{name},
                             quantity_cell(largest.shown("W", most), "W"),
                             frequency_cell(p.angular_frequency[to_size(at)], answers.display),
                             total > 0 && most > 0 ? percent_cell(most / total) : right("–"),
                             quantity_cell(largest.shown("W", fed), "W")};
  };
  std::vector<std::vector<Cell>> rows;
  for (std::size_t m = 0; m < p.mounts.size(); ++m)
    rows.push_back(row(p.mounts[m], p.into_ground.row(to_index(m)).transpose()));
  rows.push_back(row("all mounts", p.into_ground_in_total));
  return html_table({{"mount"},
                     right("largest power into the ground"),
                     frequency_cell_heading("at", answers.display),
                     right("share of all mounts"),
                     right("input power there")},
                    rows) +
      hint("Mean power in the steady state at the computed frequencies. Only a flexible foundation or moving ground "
           "takes "
           "power; rigid ground at rest does not.");
}

}  // namespace trivet::report
