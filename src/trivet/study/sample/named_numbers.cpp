// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/named_numbers.h"

#include "trivet/foundation/index.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::study {

FileUnit unit_in_file(const project::Project& project, const std::string& path) {
  const project::Node& document = project.base().document;
  const std::vector<std::string> keys = project::path_keys(path);
  const project::Node* node = project::node_at(document, keys);
  if (const auto written = node ? project::written_number(*node) : std::nullopt; written && !written->unit.empty()) {
    const auto zero = project::in_unit({0, written->unit}, ""), one = project::in_unit({1, written->unit}, "");
    if (zero == 0.0 && one) return {written->unit, *one};
  }
  const auto quantity = project::quantity_at(document, keys);
  return {quantity ? project::printed_si_unit(*quantity) : "", 1.0};
}

std::vector<VariedNumber> varied_numbers(const project::Project& project,
                                         const std::vector<project::Tolerance>& tolerances, const DrawnDesigns& drawn) {
  std::vector<VariedNumber> list;
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    for (std::size_t p = 0; p < tolerances[t].places.size(); ++p) {
      const std::string& path = tolerances[t].places[p].path;
      const auto quantity = project::quantity_at(project.base().document, project::path_keys(path));
      const std::size_t draw = drawn.draw_of(t, p);
      list.push_back({.path = path,
                      .unit = unit_in_file(project, path),
                      .si_unit = quantity ? project::printed_si_unit(*quantity) : "",
                      .given = project::ModelNumber(path, "").read(project.base()).value_or(0),
                      .tolerance = t,
                      .place = p,
                      .draw = draw,
                      .drawn = drawn.name(draw)});
    }
  return list;
}

std::vector<NamedNumber> named_numbers(const project::Project& project,
                                       const std::vector<project::Tolerance>& tolerances, const DrawnDesigns& drawn,
                                       const Eigen::VectorXd& draws) {
  std::vector<NamedNumber> list;
  if (draws.size() == 0) return list;
  for (VariedNumber& one : varied_numbers(project, tolerances, drawn)) {
    const double value = tolerances[one.tolerance].number(one.place, one.given, draws(to_index(one.draw)));
    list.push_back({std::move(one.path), value, std::move(one.unit)});
  }
  return list;
}

}  // namespace trivet::study
