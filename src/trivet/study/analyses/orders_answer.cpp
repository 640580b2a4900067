// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/orders_answer.h"

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/orders_question.h"
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {
namespace {

OrdersResult answer_orders(const CaseContext& c, const project::OrdersQuestion& asked, foundation::Problems&) {
  const std::vector<response::OrderLoading> orders =
      response::order_loadings(c.system, c.assembled, asked.selection.excitations);
  if (orders.empty())
    throw foundation::NotComputable(
        "orders: the model has no excitation by a rotating shaft; add [excitations.NAME] with type = \"orders\" or "
        "\"unbalance\"");
  response::RunUpOptions options;
  options.speed = asked.speed;
  return {
      response::run_up(c.assembled, channels_of(c, asked.selection), orders, c.modes, c.roots(), options, c.progress),
      response::campbell(orders, c.modes, c.roots(), asked.speed), asked.selection.quantity};
}

}  // namespace

const QuestionAnswer orders_answer = answered_by<answer_orders>(
    "run-up: response over shaft speed, critical speeds",
    "orders: no range of speeds given; add orders = {speed = [\"600 rpm\", \"3000 rpm\"]} to [analyses]");

}  // namespace trivet::study
