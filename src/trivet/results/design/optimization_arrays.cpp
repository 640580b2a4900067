// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/result_writer.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"

/// The best design, or the front, as arrays; parameters in their units.
namespace trivet::results {
namespace {

using study::Optimization;

void add_parameters(const Optimization& found, LabelledArrays& list) {
  using study::OptimizedParameter;
  const std::string axis = "parameter";
  const auto& parameters = found.parameters;
  list.texts(axis, axis, parameters, [](const OptimizedParameter& p) { return p.axis.name; });
  list.texts("unit", axis, parameters, [](const OptimizedParameter& p) { return array_unit(p.axis); });
  list.column("from", unit_of_the_row, axis, parameters, [](const OptimizedParameter& p) { return p.axis.from; });
  list.column("to", unit_of_the_row, axis, parameters, [](const OptimizedParameter& p) { return p.axis.to; });
  list.column("given", unit_of_the_row, axis, parameters, &OptimizedParameter::given);
  list.field("optimum", unit_of_the_row, axis, parameters, &OptimizedParameter::best);
  list.field("as_good_from", unit_of_the_row, axis, parameters, &OptimizedParameter::least);
  list.field("as_good_to", unit_of_the_row, axis, parameters, &OptimizedParameter::most);
  list.column("at_bound", "1", axis, parameters, &OptimizedParameter::at_bound);
  list.column("idle", "1", axis, parameters, &OptimizedParameter::idle);
}

void add_objective(const Optimization& found, LabelledArrays& list) {
  using study::MinimizedAmplitude;
  const std::string unit = found.objective_unit.empty() ? "1" : found.objective_unit;
  if (found.objective_before) list.value("before", unit, *found.objective_before);
  list.value("after", unit, found.objective_after);
  const std::string axis = "minimized";
  if (found.minimized.empty()) return;
  list.texts(axis, axis, found.minimized, &MinimizedAmplitude::name);
  list.texts(axis + ".unit", axis, found.minimized, &MinimizedAmplitude::unit);
  list.texts(axis + ".case", axis, found.minimized,
             [&](const MinimizedAmplitude& one) { return found.after[one.result_case].case_name; });
  list.column(axis + ".limit", unit_of_the_row, axis, found.minimized, &MinimizedAmplitude::limit);
  list.field(axis + ".before", unit_of_the_row, axis, found.minimized, &MinimizedAmplitude::before);
  list.field(axis + ".after", unit_of_the_row, axis, found.minimized, &MinimizedAmplitude::after);
}

void add_active_requirements(const Optimization& found, LabelledArrays& list) {
  using study::ActiveRequirement;
  const std::string axis = "active";
  list.texts(axis, axis, found.active, &ActiveRequirement::words);
  list.texts(axis + ".case", axis, found.active,
             [&](const ActiveRequirement& one) { return found.after[one.result_case].case_name; });
  list.field(axis + ".multiplier", "1", axis, found.active, &ActiveRequirement::multiplier);
}

void add_chosen_mounts(const study::OptimizedMounts& mounts, LabelledArrays& list) {
  std::vector<std::string> chosen;
  for (std::size_t c = 0; c < mounts.choices.size(); ++c) chosen.push_back(mounts.choices[c].mounts[mounts.chosen[c]]);
  list.texts("choice", "choice", mounts.choices, &project::MountChoice::name);
  list.texts("choice.mount", "choice", std::move(chosen));
}

}  // namespace

void add_optimization_arrays(const Optimization& found, LabelledArrays& list) {
  add_parameters(found, list);
  add_objective(found, list);
  add_active_requirements(found, list);
  if (found.mounts) add_chosen_mounts(*found.mounts, list);
}

void add_front_arrays(const study::DesignFront& front, LabelledArrays& list) {
  using project::DesignAxis;
  using study::FrontObjective;
  using study::FrontPoint;
  std::vector<double> knee(front.points.size());
  if (front.knee) knee[*front.knee] = 1;
  list.count("point", front.points.size());
  list.lists("amplitudes", unit_of_the_row, {"point", "objective"}, front.objectives.size(), front.points,
             &FrontPoint::amplitudes);
  list.lists("values", unit_of_the_row, {"point", "parameter"}, front.parameters.size(), front.points,
             &FrontPoint::values);
  list.field("residual", "1", "point", front.points, &FrontPoint::residual);
  list.column("exchange", "1", "point", front.points, &FrontPoint::exchange);
  list.copy("knee", "1", "point", std::move(knee));
  list.texts("objective", "objective", front.objectives, &FrontObjective::name);
  list.texts("objective.unit", "objective", front.objectives, &FrontObjective::unit);
  list.field("objective.given", unit_of_the_row, "objective", front.objectives, &FrontObjective::given);
  list.field("objective.least", unit_of_the_row, "objective", front.objectives, &FrontObjective::least);
  list.field("objective.most", unit_of_the_row, "objective", front.objectives, &FrontObjective::most);
  list.texts("parameter", "parameter", front.parameters, &DesignAxis::name);
  list.texts("parameter.unit", "parameter", front.parameters, array_unit);
  list.field("parameter.from", unit_of_the_row, "parameter", front.parameters, &DesignAxis::from);
  list.field("parameter.to", unit_of_the_row, "parameter", front.parameters, &DesignAxis::to);
  list.column("parameter.given", unit_of_the_row, "parameter", front.given, [](const auto& value) { return value; });
}

}  // namespace trivet::results
