// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/known_model.h"

#include <algorithm>

namespace trivet::project {
namespace {

bool has_problem_of(const foundation::Problems& problems, const std::string& part) {
  return std::ranges::any_of(problems.list(), [&](const foundation::Problem& problem) {
    return problem.subject == part || problem.subject.starts_with(part + ".");
  });
}

/// Quantities of the numbers of a node that another one with the same content has already had read.
void take_quantities(const Node& read, const Node& now) {
  now.quantity = read.quantity;
  for (std::size_t i = 0; i < now.items.size(); ++i) take_quantities(read.items[i], now.items[i]);
}

}  // namespace

const Node* KnownModel::unchanged(const char* table, const std::string& name, const Node& now) const {
  const Node* parts = document.find(table);
  const Node* before = parts ? parts->find(name) : nullptr;
  if (!before || !same_content(*before, now)) return nullptr;
  for (const char* adjusted :
       {"stiffness_factor", "damping_factor", "moved", "mass_about_center", "center_moved", "inertia_about_center"})
    if (now.find(adjusted)) return nullptr;
  if (of_text && (now.find("catalogue") || has_problem_of(*of_text, std::string(table) + "." + name)))
    return nullptr;  // warnings of a catalogue are about the catalogue
  take_quantities(*before, now);
  return before;
}

}  // namespace trivet::project
