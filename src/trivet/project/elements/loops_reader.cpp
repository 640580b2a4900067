// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "trivet/foundation/plain_text.h"
#include "trivet/identification/law_fit.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/file_name.h"

namespace trivet::project {
namespace {

using identification::LawFit;
using identification::LoopFit;
using identification::LoopRecord;

/// Laws that can be fitted: their names in the project file and in LawFit.
const std::map<std::string, std::string> law_names = {{"hysteretic", "hysteretic"},
                                                      {"kelvin_voigt", "viscous (Kelvin–Voigt)"},
                                                      {"zener", "Zener"},
                                                      {"fractional_zener", "fractional Zener"}};

void add_problems(TableReader& reader, const foundation::Problems& problems) {
  for (foundation::Problem problem : problems.list()) {
    if (problem.origin.line == 0) problem.origin = reader.node("loops")->origin;
    problem.subject = reader.path() + ".loops" + (problem.subject.empty() ? "" : " (" + problem.subject + ")");
    reader.problems().add(std::move(problem));
  }
}

/// One record for each run of rows with the same `loop`: displacement and force in the given units; frequency_hz and
/// time if these columns exist.
std::vector<LoopRecord> records(const CsvTable& table, const Eigen::MatrixXd& needed, double length_unit,
                                double force_unit) {
  const auto column = [&](const char* name) -> Eigen::Index {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    return found == table.columns.end() ? -1 : found - table.columns.begin();
  };
  const Eigen::Index time = column("time"), frequency = column("frequency_hz");
  std::vector<LoopRecord> result;
  for (Eigen::Index first = 0; first < needed.rows();) {
    Eigen::Index count = 1;
    while (first + count < needed.rows() && needed(first + count, 0) == needed(first, 0)) ++count;
    LoopRecord record;
    record.name = fmt::format("loop {:.6g}", needed(first, 0));
    record.displacement = length_unit * needed.col(1).segment(first, count);
    record.force = force_unit * needed.col(2).segment(first, count);
    if (time >= 0) record.time = table.values.col(time).segment(first, count);
    if (frequency >= 0) record.angular_frequency = 2 * std::numbers::pi * table.values(first, frequency);
    result.push_back(std::move(record));
    first += count;
  }
  return result;
}

std::string interval(const identification::Estimate& estimate) {
  return fmt::format("{:.5g} ± {:.2g}", estimate.value, estimate.half_width);
}

void add_facts(const std::vector<LoopFit>& loops, const identification::LawRanking& ranking, const LawFit& taken,
               model::Element& element) {
  for (const LoopFit& loop : loops)
    element.facts.push_back(
        {loop.name,
         fmt::format("{:.5g} Hz, amplitude {:.4g} m: stiffness {} N/m, loss factor {}, loss energy {} J{}",
                     loop.angular_frequency.value_or(std::numeric_limits<double>::quiet_NaN()) / (2 * std::numbers::pi),
                     loop.amplitude.value, interval(loop.stiffness), interval(loop.loss_factor),
                     interval(loop.loss_energy),
                     loop.viscous_coefficient ? ", c = " + interval(*loop.viscous_coefficient) + " N s/m" : "")});
  for (const LawFit& law : ranking.laws)
    element.facts.push_back({law.law + (&law == &taken ? " (taken)" : ""),
                             fmt::format("deviates from the loops by {:.3g} % rms, AICc {:.3g} above the best",
                                         100 * law.relative_rms, law.akaike_difference)});
}

}  // namespace

void read_loops(TableReader& damping, model::Element& element) {
  const std::size_t before = damping.errors();
  const auto file = read_file_name(damping, "loops");
  const auto wanted =
      damping.choice("law", {"best", "hysteretic", "kelvin_voigt", "zener", "fractional_zener"}).value_or("best");
  const double length_unit = damping.number("length_unit", Quantity::length).value_or(1),
               force_unit = damping.number("force_unit", Quantity::force).value_or(1);
  for (const auto& [key, unit] : {std::pair{"length_unit", length_unit}, std::pair{"force_unit", force_unit}})
    if (!(unit > 0)) damping.error(key, fmt::format("{:.6g}", unit), "a unit is > 0", "write \"1 mm\", \"1 kN\"");
  if (!file || damping.errors() > before) return;
  const auto table = read_csv_table(*file);
  if (!table) {
    damping.add_of_file("loops", table.error());
    return;
  }
  for (const std::string& name : table->columns)
    if (name != "loop" && name != "displacement" && name != "force" && name != "time" && name != "frequency_hz")
      damping.error("loops", "column " + foundation::quoted(name),
                    "columns are loop, displacement, force, and time, frequency_hz if they are known",
                    "rename or remove it");
  const auto needed = columns(*table, {"loop", "displacement", "force"});
  if (!needed) {
    add_problems(damping, needed.error());
    return;
  }
  if (damping.errors() > before) return;
  std::vector<LoopFit> loops;
  for (const LoopRecord& record : records(*table, *needed, length_unit, force_unit)) {
    const auto fit = identification::loop_fit(record);
    if (!fit) {
      foundation::Problems named = fit.error();
      for (foundation::Problem& problem : named.list())
        problem.subject = record.name + (problem.subject.empty() ? "" : ", " + problem.subject);
      add_problems(damping, named);
      return;
    }
    add_problems(damping, fit->warnings);
    loops.push_back(*fit);
  }
  foundation::Problems remarks;
  const std::vector<identification::StiffnessPoint> points = identification::stiffness_points(loops, false, remarks);
  add_problems(damping, remarks);
  const auto ranking = identification::fitted_laws(points);
  if (!ranking) {
    add_problems(damping, ranking.error());
    return;
  }
  const auto taken = std::find_if(ranking->laws.begin(), ranking->laws.end(), [&](const LawFit& law) {
    return wanted == "best" || law.law == law_names.at(wanted);
  });
  if (taken == ranking->laws.end()) {
    damping.error("law", "\"" + wanted + "\"", "this law could not be fitted to these loops",
                  "measure at more frequencies, or take law = \"best\"");
    return;
  }
  add_facts(loops, *ranking, *taken, element);
  constexpr double poor = 0.05, alike = 2;
  foundation::Problems doubts;
  if (taken->relative_rms > poor)
    doubts.warning(
        "loops",
        fmt::format("the law \"{}\" deviates from the loops by {:.3g} %", taken->law, 100 * taken->relative_rms),
        "a law should fit its data within 5 %", "take law = \"best\", or check the loops");
  const Eigen::Vector3d translations = element.law.nominal_stiffness.diagonal().tail<6>().head<3>();
  if (translations.maxCoeff() > 0 &&
      !(taken->stiffness > translations.minCoeff() / alike && taken->stiffness < alike * translations.maxCoeff()))
    doubts.warning("loops",
                   fmt::format("the loops have a stiffness of {:.4g} N/m, the element {:.4g} to {:.4g} N/m",
                               taken->stiffness, translations.minCoeff(), translations.maxCoeff()),
                   "loops and stiffness should be of one element", "check length_unit and force_unit of the loops");
  damping.add(doubts);
  if (taken->loss_factor) element.law.damping = elements::LossFactor{*taken->loss_factor};
  else element.law.damping = *taken->viscoelastic;
}

}  // namespace trivet::project
