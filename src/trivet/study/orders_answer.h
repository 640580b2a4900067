// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/machinery/campbell.h"
#include "trivet/response/machinery/run_up.h"

namespace trivet::study {

struct OrdersResult {
  response::RunUp run_up;
  response::Campbell campbell;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

}  // namespace trivet::study
