// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/at_rest.h"

#include <algorithm>
#include <utility>

#include "trivet/model/static_stiffness.h"

namespace trivet::response {

const assembly::Assembled& of_statics(const model::System& system, const assembly::Assembled& assembled) {
  const auto& elements = system.elements();
  const bool has_laws = std::ranges::any_of(
      elements, [](const model::Element& one) { return model::has_laws(one) || one.law.nonlinear.has_value(); });
  return has_laws ? assembled.first_order() : assembled;
}

AtRest::AtRest(const model::System& system, const assembly::Assembled& assembled)
    : system_(system), assembled_(of_statics(system, assembled)) {
  if (!model::has_static_stiffness(system)) return;
  model::System softer = model::with_static_stiffness(system);
  assembly::Assembled of_it = assembly::assemble(softer);
  own_ = std::make_unique<const Own>(Own{std::move(softer), std::move(of_it)});
}

std::vector<std::size_t> mounts(const model::System& system) {
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < system.elements().size(); ++e)
    if (!system.elements()[e].n.body && !system.elements()[e].is_foundation) result.push_back(e);
  return result;
}

}  // namespace trivet::response
