// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/index.h"
#include "trivet/response/machinery/power.h"
#include "trivet/results/format/result_writer.h"

/// Mean power into the ground.
namespace trivet::results {
namespace {

using response::PowerFlow;

/// Largest power at a mount, or at all of them.
struct LargestPower {
  std::string mount;
  double power = 0;
  std::optional<double> at;  ///< [rad/s]; none if there is only round-off
  std::optional<double> share;
  double fed = 0;  ///< by the excitations at that frequency
};

LargestPower largest_power(const PowerFlow& p, const std::string& mount, const Eigen::VectorXd& power) {
  const double most = std::max(
      {p.by_forces.cwiseAbs().maxCoeff(), p.by_ground.cwiseAbs().maxCoeff(), p.into_ground.cwiseAbs().maxCoeff()});
  Eigen::Index at = 0;
  LargestPower found{.mount = mount, .power = without_round_off(power.maxCoeff(&at), most)};
  const double total = p.into_ground_in_total(at);
  if (found.power != 0) found.at = p.angular_frequency[at];
  if (found.power > 0 && total > 0) found.share = found.power / total;
  found.fed = p.by_forces(at) + std::max(p.by_ground(at), 0.0);
  return found;
}

Table largest_powers(const PowerFlow& p) {
  std::vector<LargestPower> mounts;
  for (std::size_t m = 0; m < p.mounts.size() && !p.angular_frequency.empty(); ++m)
    mounts.push_back(largest_power(p, p.mounts[m], p.into_ground.row(to_index(m)).transpose()));
  if (!mounts.empty()) mounts.push_back(largest_power(p, "all mounts", p.into_ground_in_total));
  const Rows row(std::move(mounts));
  return {
      .title = "Mean power into the ground (negative: out of the ground) in the steady state",
      .rows = row.size(),
      .columns = {row("mount", Kind::words, "mount", &LargestPower::mount),
                  row("power", Kind::quantity, "largest power into the ground", &LargestPower::power, {.unit = "W"}),
                  row("at", Kind::frequency, "at", &LargestPower::at),
                  row("share", Kind::share, "share of all mounts", &LargestPower::share),
                  row("fed", Kind::quantity, "input power there", &LargestPower::fed, {.unit = "W"})},
      .without_rows = "Power into the ground: none, no element ends there",
      .forms = for_people};
}

/// What a share above 100 % means, if a mount has one.
Sentence share_note(const PowerFlow& p) {
  bool exceeds = false;
  for (std::size_t m = 0; m < p.mounts.size() && !p.angular_frequency.empty(); ++m) {
    const auto share = largest_power(p, p.mounts[m], p.into_ground.row(to_index(m)).transpose()).share;
    constexpr double round_off = 1e-9;
    exceeds = exceeds || share.value_or(0) > 1 + round_off;
  }
  return {
      .parts = {exceeds ? "Above 100 %: at this frequency other mounts return power from the ground to the machine; "
                          "the shares of all mounts, negative ones included, add up to 100 %."
                        : ""},
      .place = Sentence::Place::note};
}

/// Powers of mounts or elements over the frequencies.
Table power_rows(const char* key, const char* axis, const char* name, const std::vector<std::string>& names,
                 const Eigen::MatrixXd& powers) {
  const Rows row(names);
  const auto powers_of = [&powers](std::size_t i) { return Numbers::row(powers, i); };
  return {.key = key,
          .axis = axis,
          .plain_names = true,
          .rows = row.size(),
          .columns = {row("name", Kind::words, "", [](const std::string& one) { return one; }),
                      row.lists(name, "", "angular_frequency", {}, powers_of, {.unit = "W"})},
          .arrays = {{axis, "name"}, name},
          .forms = for_programs};
}

/// The power at one mount, or at all of them, at one of the single frequencies.
struct PowerAt {
  double angular_frequency = 0;
  std::string mount;
  double power = 0, fed = 0;
};

Table powers_at(const PowerFlow& p) {
  std::vector<PowerAt> list;
  for (Eigen::Index i = 0; i < to_index(p.angular_frequency.size()); ++i) {
    const double fed = p.by_forces(i) + std::max(p.by_ground(i), 0.0);
    const auto add = [&](const std::string& mount, double power) {
      list.push_back({p.angular_frequency[static_cast<std::size_t>(i)], mount, power, fed});
    };
    for (std::size_t m = 0; m < p.mounts.size(); ++m) add(p.mounts[m], p.into_ground(to_index(m), i));
    add("all mounts", p.into_ground_in_total(i));
  }
  const Rows row(std::move(list));
  return {.key = "at",
          .axis = "single",
          .title = "At single frequencies",
          .rows = row.size(),
          .columns = {row("angular_frequency", Kind::frequency, "f", &PowerAt::angular_frequency),
                      row("mount", Kind::words, "mount", &PowerAt::mount),
                      row("into_ground", Kind::quantity, "power into the ground", &PowerAt::power, {.unit = "W"}),
                      row("fed", Kind::quantity, "input power", &PowerAt::fed, {.unit = "W"})}};
}

Document power_document(const project::Case& variant, const study::CaseResults& results) {
  const PowerFlow& p = *results.power;
  Curves curves{.axis = "angular_frequency",
                .unit = "rad/s",
                .points = p.angular_frequency,
                .file = "power.csv",
                .axis_columns = {"angular_frequency [rad/s]"},
                .list = {{.name = "by forces", .unit = "W", .values = p.by_forces, .forms = in_csv},
                         {.name = "by ground", .unit = "W", .values = p.by_ground, .forms = in_csv},
                         {.name = "into ground", .unit = "W", .values = p.into_ground_in_total, .forms = in_csv}}};
  for (std::size_t m = 0; m < p.mounts.size(); ++m)
    curves.list.push_back({.name = "into ground at " + p.mounts[m],
                           .unit = "W",
                           .values = Numbers::row(p.into_ground, m),
                           .forms = in_csv});
  const auto total = [](const char* name, const Eigen::VectorXd& power) {
    return Curve{.name = name, .unit = "W", .values = power, .forms = in_json | in_arrays};
  };
  const auto more = [&](std::vector<Curve> list) {
    return Curves{.axis = "angular_frequency", .list = std::move(list), .forms = 0};
  };
  Document document{
      {{excited_part(variant, "power")},
       {largest_powers(p)},
       {share_note(p)},
       {std::move(curves)},
       {power_rows("mounts", "mount", "into_ground", p.mounts, p.into_ground)},
       {more({total("into_ground_in_total", p.into_ground_in_total), total("by_forces", p.by_forces),
              total("by_ground", p.by_ground)})},
       {power_rows("elements", "element", "dissipated", p.elements, p.dissipated)},
       {more({total("dissipated_by_foundations", p.dissipated_by_foundations),
              total("dissipated_by_system", p.dissipated_by_system)})},
       {Sentence{.parts = {"Only a flexible foundation or moving ground takes power; rigid ground at rest does not."},
                 .place = Sentence::Place::note,
                 .forms = on_page}}}};
  if (results.power_at) document.add(powers_at(*results.power_at));
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter power_results = {.document = power_document, .files = {"power.csv"}};

}  // namespace trivet::results
