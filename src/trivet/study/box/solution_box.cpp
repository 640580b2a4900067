// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/box/solution_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/study/box/box_check.h"
#include "trivet/study/box/box_ends.h"
#include "trivet/study/box/box_growth.h"
#include "trivet/study/sample/named_numbers.h"

namespace trivet::study {
namespace {

using foundation::InvalidInput;
using foundation::NotComputable;

constexpr double narrow_range = 1e-3;  // ranges of the cases that judge the design of the file
constexpr int most_repeats = 10;       // after a check that found violations

/// A box is around a design that meets everything.
void refuse_violations(const BoxCases& cases) {
  std::string list;
  for (const SampledCase& one : cases.list())
    for (const RequirementResult& given : one.given())
      if (given.margin < 1 + box_reserve)
        list += fmt::format(
            "{}\"{}\"{} (margin {:.4g})", list.empty() ? "" : ", ", given.words_for_people(one.variant().display),
            one.variant().name.empty() ? "" : " in case " + foundation::quoted(one.variant().name), given.margin);
  if (!list.empty())
    throw NotComputable(
        fmt::format("box: the design of the file violates or only just meets {}; ranges are around a design that meets "
                    "every requirement "
                    "with a margin "
                    "above 1: change it, see trivet verdict and trivet optimize",
                    list));
}

BoxNumber number_of(const project::Project& project, const project::Tolerance& tolerance, std::size_t place,
                    const BoxRange& range) {
  BoxNumber found{.path = tolerance.places[place].path};
  const auto quantity = project::quantity_at(project.base().document, project::path_keys(found.path));
  found.si = quantity ? project::si_unit(*quantity) : "1";
  found.unit = unit_in_file(project, found.path);
  found.given = project::ModelNumber(found.path, "").read(project.base()).value_or(0);
  found.from = tolerance.number(place, found.given, range.lower.draw);
  found.to = tolerance.number(place, found.given, range.upper.draw);
  if (found.from > found.to) std::swap(found.from, found.to);
  return found;
}

class BoxStudy {
 public:
  BoxStudy(const project::Project& project, const foundation::Progress& progress)
      : project_(project),
        progress_(progress),
        tolerances_(project.base().analyses.tolerances),
        request_(project.base().analyses.box.value_or(project::BoxRequest())),
        ends_(tolerances_, request_.most),
        cases_(project, ends_, Eigen::VectorXd::Constant(to_index(ends_.size()), narrow_range)) {
    if (std::ranges::all_of(cases_.list(), [](const SampledCase& one) { return one.given().empty(); }))
      throw InvalidInput(
          "box: neither requirements nor limits; a box has the designs that meet them: add [requirements]");
    refuse_violations(cases_);
    set_reach(cases_, ends_, request_.most);
  }

  SolutionBox run() {
    BoxGrowth growth(project_, ends_, request_, progress_);
    std::vector<BoxViolation> known;
    CheckedBox checked;
    int repeats = 0;
    while (true) {
      growth.run(known);
      checked = checked_box(project_, ends_, request_, progress_);
      if (checked.violations.empty() || repeats == most_repeats) break;
      known.insert(known.end(), checked.violations.begin(), checked.violations.end());
      ++repeats;
    }
    checked.check.repeats = repeats;
    SolutionBox found{.request = request_,
                      .cases = std::move(checked.cases),
                      .check = checked.check,
                      .searched = growth.searched(),
                      .draws = cases_.draws()};
    found.request.points = found.check.inside;
    found.all_times = ends_.times().minCoeff();
    found.correlated =
        std::ranges::any_of(tolerances_, [](const project::Tolerance& one) { return !one.correlations.empty(); });
    for (std::size_t t = 0; t < tolerances_.size(); ++t) found.ranges.push_back(range(t, growth));
    return found;
  }

 private:
  [[nodiscard]] BoxEnd end(std::size_t e, const BoxGrowth& growth) const {
    const EndStop& stop = growth.stop(e);
    return {.draw = ends_[e].draw(ends_[e].times),
            .times = ends_[e].times,
            .stop = stop.kind,
            .in_case = stop.beyond.in_case,
            .requirement = stop.beyond.requirement,
            .reason = stop.beyond.failure,
            .beyond = named_numbers(project_, tolerances_, cases_.drawn(), stop.beyond.draws),
            .is_corner = stop.is_corner};
  }

  [[nodiscard]] BoxRange range(std::size_t t, const BoxGrowth& growth) const {
    BoxRange found{.name = tolerances_[t].name,
                   .relative = tolerances_[t].relative,
                   .draws = tolerances_[t].draws(),
                   .lower = end(2 * t, growth),
                   .upper = end(2 * t + 1, growth)};
    for (std::size_t p = 0; p < tolerances_[t].places.size(); ++p)
      found.numbers.push_back(number_of(project_, tolerances_[t], p, found));
    return found;
  }

  const project::Project& project_;
  const foundation::Progress& progress_;
  const std::vector<project::Tolerance>& tolerances_;
  project::BoxRequest request_;
  BoxEnds ends_;
  BoxCases cases_;
};

}  // namespace

const char* name(BoxStop stop) {
  switch (stop) {
    case BoxStop::requirement:
      return "requirement";
    case BoxStop::no_model:
      return "no_model";
    case BoxStop::most:
      return "most";
    case BoxStop::not_determined:
      return "not_determined";
  }
  return "";
}

SolutionBox solution_box(const project::Project& project, const foundation::Progress& progress) {
  if (project.base().analyses.tolerances.empty())
    throw InvalidInput("box: the file has no tolerances; write [tolerances.NAME] with path and half_width");
  return BoxStudy(project, progress).run();
}

}  // namespace trivet::study
