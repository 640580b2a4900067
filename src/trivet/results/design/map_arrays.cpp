// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/result_writer.h"

/// The grid, the rules and the boundary of a map as arrays.
namespace trivet::results {
namespace {

using design::DesignOutcome;
using design::MapRule;

/// Index of the governing rule, from 0; NaN without an outcome, or if no rule limits the design.
double governing_rule(const DesignOutcome& outcome) {
  return outcome.known() && !std::isinf(outcome.margin) ? outcome.governing : nothing;
}

/// Arrays and axes of one map.
class MapArrays {
 public:
  MapArrays(const study::DesignMap& map, const std::string& before, LabelledArrays& list)
      : map_(map), before_(before), list_(list) {}

  void add_axes() {
    const project::MapRequest& request = map_.request;
    std::vector<double> x, y;
    for (int i = 0; i < map_.grid.nx; ++i) x.push_back(map_.point(to_size(i)).x);
    for (int j = 0; j < map_.grid.ny; ++j) y.push_back(map_.point(to_size(j) * to_size(map_.grid.nx)).y);
    list_.copy(named("x"), array_unit(request.x), named("x"), std::move(x));
    list_.copy(named("y"), array_unit(request.y), named("y"), std::move(y));
    list_.texts(named("parameter"), named("parameter"), {"x", "y"});
    list_.texts(named("parameter.name"), named("parameter"), {axis_name(request.x), axis_name(request.y)});
    list_.texts(named("parameter.path"), named("parameter"), {request.x.parameter, request.y.parameter});
  }

  void add_grid() {
    add_outcomes("margin", [](const DesignOutcome& outcome) {
      return outcome.known() ? static_cast<double>(outcome.margin) : nothing;
    });
    add_outcomes("governing", governing_rule);
    add_outcomes("kept", &DesignOutcome::feasible);
  }

  void add_rules() {
    const std::string axis = named("rule");
    list_.texts(axis, axis, map_.rules, &MapRule::words);
    list_.texts(axis + ".name", axis, map_.rules, &MapRule::channel);
    list_.texts(axis + ".unit", axis, map_.rules, &MapRule::unit);
    list_.field(axis + ".allowed", unit_of_the_row, axis, map_.rules, &MapRule::allowed);
  }

  /// Each line of the boundary has a number; its points follow each other.
  void add_boundary() {
    std::vector<double> line, x, y;
    for (std::size_t k = 0; k < map_.feasible.lines.size(); ++k)
      for (const design::MapPlace& place : map_.feasible.lines[k]) {
        line.push_back(static_cast<double>(k + 1));
        x.push_back(map_.request.x.at(place.x));
        y.push_back(map_.request.y.at(place.y));
      }
    const std::string axis = named("boundary");
    list_.count(axis, line.size());
    list_.copy(axis + ".line", "1", axis, std::move(line));
    list_.copy(axis + ".x", array_unit(map_.request.x), axis, std::move(x));
    list_.copy(axis + ".y", array_unit(map_.request.y), axis, std::move(y));
  }

  void add_best() {
    if (!map_.best) return;
    const design::DesignPoint point = map_.point(*map_.best);
    list_.value(named("best.x"), array_unit(map_.request.x), point.x);
    list_.value(named("best.y"), array_unit(map_.request.y), point.y);
    list_.value(named("best.margin"), "1", map_.outcomes[*map_.best].margin);
  }

  void add_marks() {
    using study::MapMark;
    const std::string axis = named("mark");
    list_.texts(axis, axis, map_.marks, &MapMark::name);
    list_.column(axis + ".x", array_unit(map_.request.x), axis, map_.marks, &MapMark::x);
    list_.column(axis + ".y", array_unit(map_.request.y), axis, map_.marks, &MapMark::y);
    list_.column(axis + ".margin", "1", axis, map_.marks,
                 [](const MapMark& mark) { return mark.judged ? mark.judged->governing.margin : nothing; });
  }

 private:
  [[nodiscard]] std::string named(const char* name) const { return before_ + name; }

  template <typename Number>
  void add_outcomes(const char* name, const Number& number) {
    std::vector<double> numbers;
    numbers.reserve(map_.outcomes.size());
    for (const DesignOutcome& outcome : map_.outcomes) numbers.push_back(std::invoke(number, outcome));
    list_.copy(named(name), "1", {named("y"), named("x")}, {to_size(map_.grid.ny), to_size(map_.grid.nx)},
               std::move(numbers));
  }

  const study::DesignMap& map_;
  const std::string& before_;
  LabelledArrays& list_;
};

}  // namespace

std::string array_unit(const project::DesignAxis& axis) {
  const std::string unit = axis_unit(axis);
  return unit.empty() ? "1" : unit;
}

void add_map_arrays(const study::DesignMap& map, const std::string& before, LabelledArrays& list) {
  MapArrays arrays(map, before, list);
  arrays.add_axes();
  arrays.add_grid();
  arrays.add_rules();
  arrays.add_boundary();
  arrays.add_best();
  arrays.add_marks();
}

}  // namespace trivet::results
