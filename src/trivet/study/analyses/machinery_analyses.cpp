// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/power.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/analysis_run.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {

namespace {

OrdersResult orders_result(const CaseContext& c, const project::OrdersAnalysis& request, foundation::Problems&) {
  const std::vector<response::OrderLoading> orders =
      response::order_loadings(c.system, c.assembled, request.selection.excitations);
  if (orders.empty())
    throw foundation::NotComputable(
        "orders: the model has no excitation by a rotating shaft; add [excitations.NAME] with type = \"orders\" or "
        "\"unbalance\"");
  response::RunUpOptions options;
  options.speed = request.speed;
  const std::vector<assembly::Channel> channels = channels_of(c, request.selection);
  OrdersResult result{response::run_up(c.assembled, channels, orders, c.modes, c.roots(), options, c.progress),
                      response::campbell(orders, c.modes, c.roots(), request.speed), request.selection.quantity};
  const SummedOrders summed(c, channels, orders, 0);
  for (const double speed : request.at) result.at.push_back(summed.largest({speed, speed}));
  return result;
}

}  // namespace

const AnalysisRun orders_run = computed_by<&project::Analyses::orders, &CaseResults::orders, orders_result>(
    "run-up: response over shaft speed, critical speeds",
    "orders: no range of speeds given; add orders = {speed = [\"600 rpm\", \"3000 rpm\"]} to [analyses]");

namespace {

response::PowerFlow power_result(const CaseContext& c, const project::BandAnalysis& request, foundation::Problems&) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, request.selection.excitations);
  if (loading.vanishes()) throw without_excitation("power");
  const std::vector<assembly::Channel> channels =
      assembly::channels(c.system, c.assembled, {"coordinates"}, assembly::MotionQuantity::velocity);
  const assembly::Band band = request.band ? *request.band : default_band(c);
  // They only choose the frequencies.
  const response::Peaks peaks = response::peaks(c.assembled, channels, loading, c.modes, c.roots(),
                                                {.search_to = band.to, .refine = false}, c.progress);
  std::vector<double> grid = grid_over(c, channels, loading, peaks, band);
  // At ω = 0 nothing moves; at an undamped resonance there is no steady power.
  const response::FrequencyResponse defined = response::frequency_response(c.assembled, channels, loading, grid);
  std::erase_if(grid, [&](double w) {
    return w == 0 || std::ranges::find(defined.check.undefined_at, w) != defined.check.undefined_at.end();
  });
  return response::power_flow(c.system, c.assembled, loading, grid, c.progress);
}

}  // namespace

namespace {

void compute_power(const CaseContext& c, const project::Analyses& requested, CaseResults& into) {
  if (!requested.power) return;
  into.power = power_result(c, *requested.power, into.warnings);
  if (requested.power->at.empty()) return;
  const assembly::Loading loading =
      assembly::harmonic_loading(c.system, c.assembled, requested.power->selection.excitations);
  into.power_at = response::power_flow(c.system, c.assembled, loading, requested.power->at, c.progress);
}

constexpr AnalysisRun run_of_power() {
  AnalysisRun run = computed_by<&project::Analyses::power, &CaseResults::power, power_result>(
      "mean power into the ground at each mount");
  run.compute = compute_power;
  return run;
}

}  // namespace

const AnalysisRun power_run = run_of_power();

namespace {

std::vector<response::DeflectionShape> shapes_result(const CaseContext& c, const project::ShapesAnalysis& request,
                                                     foundation::Problems&) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, request.selection.excitations);
  if (loading.vanishes()) throw without_excitation("shapes");
  std::vector<response::DeflectionShape> shapes;
  for (const double omega : request.at)
    shapes.push_back(response::deflection_shape(c.system, c.assembled, loading, omega));
  return shapes;
}

}  // namespace

const AnalysisRun shapes_run = computed_by<&project::Analyses::shapes, &CaseResults::shapes, shapes_result>(
    "operating deflection shapes", "shapes: no frequencies given; add shapes = {at = [\"25 Hz\"]} to [analyses]");

}  // namespace trivet::study
