// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/nonlinear/steady_branch.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Periodic motions of nonlinear machines.
namespace trivet::results {

using nonlinear::Fold;
using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

namespace {

const SteadyBranch& branch_of(const study::Answers& answers) { return *answers.find<SteadyBranch>("steady"); }

/// Numbers of one result along the branch.
template <typename Value>
std::vector<double> along(const SteadyBranch& branch, std::size_t result, const Value& value) {
  std::vector<double> numbers;
  for (const SteadyPoint& point : branch.points) numbers.push_back(value(point.results[result]));
  return numbers;
}

struct Course {
  const char* name;
  double (*value)(const ObservedMotion& motion);
};
constexpr Course courses[] = {{"mean", [](const ObservedMotion& m) { return m.mean; }},
                              {"largest", [](const ObservedMotion& m) { return m.largest; }},
                              {"smallest", [](const ObservedMotion& m) { return m.smallest; }},
                              {"rms", [](const ObservedMotion& m) { return m.rms; }}};

}  // namespace

namespace json {
namespace {

Json motion(const ObservedMotion& m) {
  return {{"mean", m.mean},
          {"largest", m.largest},
          {"smallest", m.smallest},
          {"rms", m.rms},
          {"harmonics", list(m.harmonics)}};
}

Json point(const SteadyPoint& p) {
  Json motions = Json::array();
  for (const ObservedMotion& m : p.results) motions.push_back(motion(m));
  return {{"angular_frequency", p.angular_frequency},
          {"stable", p.stable},
          {"largest_multiplier", number(p.largest_multiplier())},
          {"results", std::move(motions)}};
}

Json steady(const project::Case&, const study::Answers& answers) {
  const SteadyBranch& branch = branch_of(answers);
  Json result{{"harmonics", branch.harmonics},
              {"left_out", number(branch.left_out)},
              {"ended", branch.ended},
              {"results", Json::array()},
              {"points", Json::array()},
              {"folds", Json::array()},
              {"warnings", warnings(answers.warnings)}};
  for (std::size_t c = 0; c < branch.results.size(); ++c)
    result["results"].push_back({{"name", branch.results[c]}, {"unit", branch.units[c]}});
  for (const SteadyPoint& p : branch.points) result["points"].push_back(point(p));
  for (const Fold& fold : branch.folds)
    result["folds"].push_back({{"point", point(fold.point)},
                               {"jump_of", fold.upper ? "rising frequency" : "falling frequency"},
                               {"lands", fold.lands ? point(*fold.lands) : Json(nullptr)}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string steady_csv(const project::Case&, const study::Answers& answers) {
  const SteadyBranch& branch = branch_of(answers);
  std::string text = "angular_frequency [rad/s],stable,largest multiplier";
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    for (const char* part : {"re", "im"})
      text += "," + csv_field(fmt::format("{} {} [{}]", branch.results[c], part, branch.units[c]));
    for (const Course& course : courses)
      text += "," + csv_field(fmt::format("{} {} [{}]", branch.results[c], course.name, branch.units[c]));
  }
  text += "\n";
  for (const SteadyPoint& point : branch.points) {
    text += fmt::format("{},{},{}", point.angular_frequency, point.stable ? "yes" : "no",
                        csv_number(point.largest_multiplier()));
    for (const ObservedMotion& motion : point.results) {
      append_csv_number(text, motion.harmonics(0).real());
      append_csv_number(text, motion.harmonics(0).imag());
      for (const Course& course : courses) append_csv_number(text, course.value(motion));
    }
    text += "\n";
  }
  return text;
}

/// The result that jumps are told of: of those with the unit of the first one that moves, the one that moves most.
std::optional<std::size_t> main_result(const SteadyBranch& branch) {
  std::optional<std::size_t> found;
  double largest = 0;
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    if (found && branch.units[c] != branch.units[*found]) continue;
    double range = 0;
    for (const SteadyPoint& point : branch.points) range = std::max(range, point.results[c].half_of_range());
    if (range <= largest) continue;
    largest = range;
    found = c;
  }
  return found;
}

/// "machine.z from 4.12 mm to 0.31 mm"
std::string jump_words(const Fold& fold, const SteadyBranch& branch, const project::ShownUnits& display) {
  const std::optional<std::size_t> told = main_result(branch);
  if (!told) return "";
  const DisplayUnit unit = display_unit(display, branch.units[*told]);
  const std::string from =
      fmt::format("{} from {}", branch.results[*told], value_text(fold.point.results[*told].half_of_range(), unit));
  return from +
      (fold.lands ? " to " + value_text(fold.lands->results[*told].half_of_range(), unit)
                  : "; this branch has no other stable motion there, or several");
}

std::string folds_text(const SteadyBranch& branch, const project::ShownUnits& display) {
  if (branch.folds.empty()) return "  no folds: one motion at each frequency of this branch, no jumps\n";
  TextTable table({"fold", "at [" + frequency_unit(display) + "]", "half of the range jumps"});
  for (const Fold& fold : branch.folds)
    table.add({fold.upper ? "rising frequency" : "falling frequency",
               number_text(shown_frequency(display, fold.point.angular_frequency), 9),
               jump_words(fold, branch, display)});
  return table.text();
}

/// Stable motions: points, and folds beside a stable point, which are the ends of stable motions.
std::vector<const SteadyPoint*> stable_motions(const SteadyBranch& branch) {
  std::vector<const SteadyPoint*> stable;
  for (const SteadyPoint& point : branch.points)
    if (point.stable) stable.push_back(&point);
  for (const Fold& fold : branch.folds) {
    const std::size_t next = std::min(fold.after + 1, branch.points.size() - 1);
    if (branch.points[fold.after].stable || branch.points[next].stable) stable.push_back(&fold.point);
  }
  return stable;
}

/// "  stability changes without a fold near 4.99, 5.14 Hz …": there motions of another period begin.
std::string changes_without_fold(const SteadyBranch& branch, const project::ShownUnits& display) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const bool at_fold =
        std::any_of(branch.folds.begin(), branch.folds.end(), [i](const Fold& fold) { return fold.after == i; });
    if (at_fold || branch.points[i].stable == branch.points[i + 1].stable) continue;
    const double omega = (branch.points[i].angular_frequency + branch.points[i + 1].angular_frequency) / 2;
    places.push_back(number_text(shown_frequency(display, omega), 4));
  }
  constexpr std::size_t most = 8;
  if (places.empty()) return "";
  return "  stability changes without a fold near " + foundation::comma_separated(places, most) + " " +
      frequency_unit(display) + ": motions of another period, not computed\n";
}

std::string steady_text(const project::Case& variant, const study::Answers& answers) {
  const SteadyBranch& branch = branch_of(answers);
  const project::ShownUnits& display = variant.display;
  const auto hertz = [&](double omega) { return number_text(shown_frequency(display, omega), 5); };
  const std::string unit = frequency_unit(display);
  const auto unstable =
      std::count_if(branch.points.begin(), branch.points.end(), [](const auto& p) { return !p.stable; });
  const auto [low, high] = std::minmax_element(
      branch.points.begin(), branch.points.end(),
      [](const SteadyPoint& a, const SteadyPoint& b) { return a.angular_frequency < b.angular_frequency; });
  std::string text =
      excited_at_once(variant, "steady") +
      fmt::format(
          "Periodic motions from {} to {} {}, connected with the one at the lower end (detached ones are not sought)\n"
          "  {} points, {} of them unstable; {} harmonics, which leave out at most {:.2g} of the deflections\n",
          hertz(low->angular_frequency), hertz(high->angular_frequency), unit, branch.points.size(), unstable,
          branch.harmonics, branch.left_out);
  if (!branch.ended.empty()) text += "  " + branch.ended + "\n";
  text += changes_without_fold(branch, display) + folds_text(branch, display);
  TextTable table({"deviation from rest", "largest stable", "at [" + unit + "]", "smallest stable", "mean there",
                   "largest of all"});
  const std::vector<const SteadyPoint*> stable = stable_motions(branch);
  for (std::size_t c = 0; c < branch.results.size() && !stable.empty(); ++c) {
    const auto is_lower = [c](const SteadyPoint* a, const SteadyPoint* b) {
      return a->results[c].largest < b->results[c].largest;
    };
    const SteadyPoint& top = **std::max_element(stable.begin(), stable.end(), is_lower);
    double smallest = 0, of_all = top.results[c].largest;
    for (const SteadyPoint* point : stable) smallest = std::min(smallest, point->results[c].smallest);
    for (const SteadyPoint& point : branch.points) of_all = std::max(of_all, point.results[c].largest);
    const DisplayUnit shown = display_unit(display, branch.units[c]);
    table.add({branch.results[c], value_text(top.results[c].largest, shown), hertz(top.angular_frequency),
               value_text(smallest, shown),
               value_text(without_round_off(top.results[c].mean, top.results[c].half_of_range()), shown),
               value_text(of_all, shown)});
  }
  return text + table.text();
}

void steady_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  const SteadyBranch& branch = branch_of(answers);
  const std::string axis = "angular_frequency";
  const std::vector<SteadyPoint>& points = branch.points;
  const auto harmonics = to_size(branch.harmonics);
  list.field(axis, "rad/s", axis, points, &SteadyPoint::angular_frequency);
  list.column("stable", "1", axis, points, &SteadyPoint::stable);
  list.column("largest_multiplier", "1", axis, points, &SteadyPoint::largest_multiplier);
  list.count("harmonic", harmonics);
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    const std::string &name = branch.results[c], &unit = branch.units[c];
    Eigen::VectorXcd first(to_index(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) first(to_index(i)) = points[i].results[c].harmonics(0);
    list.copy(name, unit, axis, std::move(first));
    list.mark_harmonic({name});
    for (const Course& course : courses)
      list.copy(name + " " + course.name, unit, axis, along(branch, c, course.value));
    list.lists(name + " harmonics", unit, {axis, "harmonic"}, harmonics, points,
               [c](const SteadyPoint& point) -> const Eigen::VectorXcd& { return point.results[c].harmonics; });
  }
  list.texts("fold", "fold", branch.folds,
             [](const Fold& fold) { return fold.upper ? "rising frequency" : "falling frequency"; });
  list.column("fold.angular_frequency", "rad/s", "fold", branch.folds,
              [](const Fold& fold) { return fold.point.angular_frequency; });
  list.value("left_out", "1", branch.left_out);
}

}  // namespace

const AnswerWriter steady_results = {
    .json = json::steady,
    .tables = {{"steady.csv", steady_csv}},
    .text = steady_text,
    .arrays = steady_arrays,
};

}  // namespace trivet::results
