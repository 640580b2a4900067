// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/named_numbers.h"

#include "trivet/foundation/index.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::study {

std::vector<NamedNumber> named_numbers(const project::Project& project,
                                       const std::vector<project::Tolerance>& tolerances, const DrawnDesigns& drawn,
                                       const Eigen::VectorXd& draws) {
  std::vector<NamedNumber> list;
  if (draws.size() == 0) return list;
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    for (std::size_t p = 0; p < tolerances[t].places.size(); ++p) {
      const std::string& path = tolerances[t].places[p].path;
      const double given = project::ModelNumber(path, "").read(project.base()).value_or(0);
      list.push_back({path, tolerances[t].number(p, given, draws(to_index(drawn.draw_of(t, p)))),
                      project::quantity_at(project.base().document, project::path_keys(path))});
    }
  return list;
}

}  // namespace trivet::study
