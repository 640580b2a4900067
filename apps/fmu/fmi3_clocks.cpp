// SPDX-License-Identifier: BSD-3-Clause
// The model has no clocks. Each function succeeds only for no clocks at all.
#include <stdexcept>

#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/guarded_call.h"

using namespace trivet::fmu;

namespace {

fmi3Status no_clocks(fmi3Instance instance, const char* function, std::size_t count) {
  return fmi3_status(guarded_call(instance, function, phase::any, [&](Instance&) {
    if (count > 0) throw std::runtime_error("the model has no clocks");
  }));
}

}  // namespace

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Float64[],
                                  fmi3IntervalQualifier[]) {
  return no_clocks(instance, "fmi3GetIntervalDecimal", count);
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt64[],
                                   fmi3UInt64[], fmi3IntervalQualifier[]) {
  return no_clocks(instance, "fmi3GetIntervalFraction", count);
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Float64[]) {
  return no_clocks(instance, "fmi3GetShiftDecimal", count);
}

fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt64[],
                                fmi3UInt64[]) {
  return no_clocks(instance, "fmi3GetShiftFraction", count);
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t count,
                                  const fmi3Float64[]) {
  return no_clocks(instance, "fmi3SetIntervalDecimal", count);
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t count,
                                   const fmi3UInt64[], const fmi3UInt64[]) {
  return no_clocks(instance, "fmi3SetIntervalFraction", count);
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference[], std::size_t count,
                               const fmi3Float64[]) {
  return no_clocks(instance, "fmi3SetShiftDecimal", count);
}

fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference[], std::size_t count,
                                const fmi3UInt64[], const fmi3UInt64[]) {
  return no_clocks(instance, "fmi3SetShiftFraction", count);
}
