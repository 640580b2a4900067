// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/at_rest.h"

#include <utility>

#include "trivet/model/static_stiffness.h"

namespace trivet::response {

AtRest::AtRest(const model::System& system, const assembly::Assembled& assembled)
    : system_(system), assembled_(assembled) {
  if (!model::has_static_stiffness(system)) return;
  model::System softer = model::with_static_stiffness(system);
  assembly::Assembled of_it = assembly::assemble(softer);
  own_ = std::make_unique<const Own>(Own{std::move(softer), std::move(of_it)});
}

}  // namespace trivet::response
