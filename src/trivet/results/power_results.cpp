// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/response/machinery/power.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Mean power into the ground.
namespace trivet::results {
namespace json {
namespace {

Json power(const project::Case&, const study::Answers& answers) {
  const response::PowerFlow& p = *answers.find<response::PowerFlow>("power");
  Json result{{"angular_frequency", list(p.angular_frequency)},
              {"mounts", Json::array()},
              {"into_ground_in_total", list(p.into_ground_in_total)},
              {"by_forces", list(p.by_forces)},
              {"by_ground", list(p.by_ground)},
              {"elements", Json::array()},
              {"dissipated_by_foundations", list(p.dissipated_by_foundations)},
              {"dissipated_by_system", list(p.dissipated_by_system)},
              {"warnings", warnings(answers.warnings)}};
  for (std::size_t i = 0; i < p.mounts.size(); ++i)
    result["mounts"].push_back({{"name", p.mounts[i]}, {"into_ground", list(p.into_ground.row(to_index(i)))}});
  for (std::size_t i = 0; i < p.elements.size(); ++i)
    result["elements"].push_back({{"name", p.elements[i]}, {"dissipated", list(p.dissipated.row(to_index(i)))}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string power_csv(const project::Case&, const study::Answers& answers) {
  const response::PowerFlow& p = *answers.find<response::PowerFlow>("power");
  std::string text = "angular_frequency [rad/s],by forces [W],by ground [W],into ground [W]";
  for (const std::string& mount : p.mounts) text += "," + csv_field("into ground at " + mount + " [W]");
  text += "\n";
  for (std::size_t k = 0; k < p.angular_frequency.size(); ++k) {
    const auto column = to_index(k);
    text += fmt::format("{},{},{},{}", p.angular_frequency[k], csv_number(p.by_forces(column)),
                        csv_number(p.by_ground(column)), csv_number(p.into_ground_in_total(column)));
    for (Eigen::Index m = 0; m < p.into_ground.rows(); ++m) append_csv_number(text, p.into_ground(m, column));
    text += "\n";
  }
  return text;
}

std::string power_text(const project::Case& variant, const study::Answers& answers) {
  const response::PowerFlow& p = *answers.find<response::PowerFlow>("power");
  if (p.angular_frequency.empty()) return "";
  if (p.mounts.empty())
    return excited_at_once(variant, "power") + "Power into the ground: none, no element ends there\n";
  TextTable table({"mount", "highest power into the ground [W]", "at [" + frequency_unit(variant.display) + "]"});
  const double most = std::max(
      {p.by_forces.cwiseAbs().maxCoeff(), p.by_ground.cwiseAbs().maxCoeff(), p.into_ground.cwiseAbs().maxCoeff()});
  const auto add = [&](const std::string& name, const Eigen::VectorXd& power) {
    Eigen::Index at = 0;
    const double highest = without_round_off(power.maxCoeff(&at), most);
    const double frequency = shown_frequency(variant.display, p.angular_frequency[to_size(at)]);
    table.add({name, number_text(highest), highest == 0 ? "–" : number_text(frequency, 5)});
  };
  for (std::size_t m = 0; m < p.mounts.size(); ++m) add(p.mounts[m], p.into_ground.row(to_index(m)).transpose());
  add("in total", p.into_ground_in_total);
  return excited_at_once(variant, "power") + "Mean power into the ground (negative: out of the ground)\n" +
      table.text();
}

void power_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  const response::PowerFlow& p = *answers.find<response::PowerFlow>("power");
  const std::string axis = "angular_frequency";
  list.view(axis, "rad/s", axis, p.angular_frequency);
  list.view("by_forces", "W", axis, p.by_forces);
  list.view("by_ground", "W", axis, p.by_ground);
  list.view("into_ground_in_total", "W", axis, p.into_ground_in_total);
  list.texts("mount", "mount", p.mounts);
  list.view("into_ground", "W", {"mount", axis}, p.into_ground);
  list.texts("element", "element", p.elements);
  list.view("dissipated", "W", {"element", axis}, p.dissipated);
  list.view("dissipated_by_foundations", "W", axis, p.dissipated_by_foundations);
  list.view("dissipated_by_system", "W", axis, p.dissipated_by_system);
}

}  // namespace

const AnswerWriter power_results = {
    .json = json::power,
    .tables = {{"power.csv", power_csv}},
    .text = power_text,
    .arrays = power_arrays,
};

}  // namespace trivet::results
