// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/response/random/random_response.h"

namespace trivet::response {

RandomLoading random_loading(const model::System& system, const assembly::Assembled& assembled,
                             const std::vector<std::string>& selected) {
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected)
    if (std::ranges::none_of(excitations, [&](const model::Excitation& excitation) {
          return excitation.name == name && std::holds_alternative<model::Random>(excitation.course);
        }))
      throw foundation::InvalidInput("\"" + name + "\" is not a random excitation of this model");
  RandomLoading result;
  std::vector<const model::Random*> courses;
  for (const model::Excitation& excitation : excitations) {
    const auto* random = std::get_if<model::Random>(&excitation.course);
    if (!random || !model::is_selected(excitation, selected)) continue;
    result.inputs.push_back({excitation.name, assembly::loading(assembled, excitation.action), random->spectrum});
    courses.push_back(random);
  }
  for (std::size_t i = 0; i < courses.size(); ++i)
    for (const model::Random::Partner& partner : courses[i]->partners)
      for (std::size_t k = 0; k < result.inputs.size(); ++k) {
        const bool known =
            std::ranges::any_of(result.pairs, [&](const auto& pair) { return pair.first == k && pair.second == i; });
        if (result.inputs[k].name == partner.other && !known) result.pairs.push_back({i, k, partner.coherence, 0});
      }
  return result;
}

}  // namespace trivet::response
