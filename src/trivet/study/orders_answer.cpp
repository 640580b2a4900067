// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/case_context.h"

namespace trivet::study {

OrdersResult orders_answer(const CaseContext& c, const project::OrdersRequest& request) {
  const std::vector<response::OrderLoading> orders = response::order_loadings(c.system, c.assembled, request.wanted.excitations);
  if (orders.empty()) throw foundation::NotComputable("orders: the model has no excitation that goes with a shaft; add [excitations.NAME] with type = \"orders\" or \"unbalance\"");
  response::RunUpOptions options;
  options.speed = request.speed;
  return {response::run_up(c.assembled, channels_of(c, request.wanted), orders, c.modes, c.roots, options, c.progress),
          response::campbell(c.assembled, orders, c.modes, c.roots, request.speed), request.wanted.quantity};
}

}  // namespace trivet::study
