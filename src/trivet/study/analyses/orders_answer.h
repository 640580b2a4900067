// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/machinery/campbell.h"
#include "trivet/response/machinery/run_up.h"

namespace trivet::study {

/// Share of the highest peak of the same result above which tables for people list a critical speed.
inline constexpr double listed_height = 0.01;

struct OrdersResult {
  response::RunUp run_up;
  response::Campbell campbell;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

}  // namespace trivet::study
