// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/box/box_ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/study/box/solution_box.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {
namespace {

/// The same draws, as one list of numbers: its ends are exact, and its middle is the design of the file.
numerics::Distribution range_around(double given, double from, double to) {
  return {.shape = numerics::DistributionShape::measured, .mean = given, .measured = {from, given, to}};
}

/// Random numbers are enough: nothing is drawn.
project::SampleRequest no_numbers() {
  project::SampleRequest request;
  request.sobol = false;
  return request;
}

}  // namespace

BoxEnds::BoxEnds(const std::vector<project::Tolerance>& tolerances, double most) : tolerances_(tolerances) {
  for (std::size_t t = 0; t < tolerances.size(); ++t) {
    const DrawRange range = worst_range(tolerances[t].distribution);
    const double given = tolerances[t].distribution.mean;
    if (!(range.from < given && given < range.to))
      throw foundation::InvalidInput(fmt::format(
          "box: tolerance {}: the number of the file is not inside the range of its measured batch; a range around it "
          "needs a distance on both sides: give half_width",
          foundation::quoted(tolerances[t].name)));
    for (const bool upper : {false, true}) {
      GrowingEnd end{t, upper, given, upper ? range.to - given : given - range.from};
      end.reach = std::numeric_limits<double>::infinity();
      end.last = end.draw(most);
      end.reach = most;
      ends_.push_back(std::move(end));
    }
  }
}

Eigen::VectorXd BoxEnds::times() const {
  Eigen::VectorXd all(to_index(size()));
  for (std::size_t e = 0; e < size(); ++e) all(to_index(e)) = ends_[e].times;
  return all;
}

DrawBox BoxEnds::box(const Eigen::VectorXd& times) const {
  std::vector<DrawRange> ranges;
  std::vector<double> given;
  for (std::size_t t = 0; t < tolerances_.size(); ++t)
    for (std::size_t d = 0; d < tolerances_[t].draws(); ++d) {
      given.push_back(ends_[2 * t].given);
      ranges.push_back({ends_[2 * t].draw(times(to_index(2 * t))), ends_[2 * t + 1].draw(times(to_index(2 * t + 1)))});
    }
  return {std::move(ranges), Eigen::Map<const Eigen::VectorXd>(given.data(), to_index(given.size()))};
}

std::vector<project::Tolerance> BoxEnds::ranges(const Eigen::VectorXd& times) const {
  std::vector<project::Tolerance> found = tolerances_;
  for (std::size_t t = 0; t < found.size(); ++t) {
    found[t].correlations.clear();
    found[t].distribution = range_around(ends_[2 * t].given, ends_[2 * t].draw(times(to_index(2 * t))),
                                         ends_[2 * t + 1].draw(times(to_index(2 * t + 1))));
  }
  return found;
}

BoxCases::BoxCases(const project::Project& project, const BoxEnds& ends, const Eigen::VectorXd& times)
    : tolerances_(ends.ranges(times)), drawn_(tolerances_, no_numbers()) {
  const std::vector<std::string> hold_in = cases_to_hold(project);
  for (const project::Case& variant : project.cases)
    if (std::ranges::find(hold_in, variant.name) != hold_in.end()) list_.emplace_back(variant, tolerances_, drawn_);
}

bool BoxCases::has_kernels() const {
  return std::ranges::all_of(list_, [](const SampledCase& one) { return one.no_kernels().empty(); });
}

namespace {

/// Tries one end, the others as in the file.
class EndReach {
 public:
  EndReach(const BoxCases& cases, const BoxEnds& ends) : cases_(cases), ends_(ends) {}

  /// Why there is no model with this draw; empty if there is one in every case.
  [[nodiscard]] std::string refused(const GrowingEnd& end, double draw) const {
    const std::vector<project::Tolerance>& tolerances = ends_.tolerances();
    Eigen::MatrixXd design(1, to_index(cases_.draws()));
    for (std::size_t t = 0; t < tolerances.size(); ++t)
      for (std::size_t p = 0; p < tolerances[t].places.size(); ++p)
        design(0, to_index(cases_.draw_of(t, p))) = t == end.tolerance ? draw : ends_[2 * t].given;
    for (const SampledCase& one : cases_.list())
      if (const SampledMargins found = one.assembled(design); !found.failures.front().empty())
        return found.failures.front();
    return "";
  }

 private:
  const BoxCases& cases_;
  const BoxEnds& ends_;
};

}  // namespace

void set_reach(const BoxCases& cases, BoxEnds& ends, double most) {
  constexpr int halvings = 40;
  const EndReach reach(cases, ends);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    GrowingEnd& end = ends[e];
    end.beyond = reach.refused(end, end.draw(most));
    if (end.beyond.empty()) continue;
    double from = 0, to = most;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (from + to) / 2;
      const std::string refused = reach.refused(end, end.draw(middle));
      if (refused.empty()) from = middle;
      else to = middle, end.beyond = refused;
    }
    // Of a number that is wrong by more than round-off.
    if (const std::string clear = reach.refused(end, end.draw((1 + box_distance_kept) * from)); !clear.empty())
      end.beyond = clear;
    end.reach = (1 - box_distance_kept) * from;
    end.last = end.given + (end.upper ? end.width : -end.width) * end.reach;
  }
}

}  // namespace trivet::study
