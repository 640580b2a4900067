// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <optional>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/analyses/study_arrays.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

assembly::MotionQuantity quantity_of(const Task& task) {
  return task.keys.has("quantity") ? assembly::motion_quantity(task.keys.text("quantity"))
                                   : assembly::MotionQuantity::displacement;
}

Result matrices(const Task& task) {
  const auto held = hold(task, study::system_matrices(task.variant));
  Result result;
  result.warnings = without_unused(*task.project, task.variant.warnings);
  if (!held->found.exact)
    result.warnings.warning("elements", "frequency-dependent elements",
                            "B and K are those of their nearest linear system", "take `response` for exact amplitudes");
  result.arrays = [held] { return results::matrix_arrays(held->found); };
  result.held = held;
  return result;
}

Result state_space(const Task& task) {
  const auto held = hold(
      task, study::linear_system(task.variant, task.keys.names("of"), quantity_of(task), task.keys.flag("nearest")));
  Result result;
  result.warnings = without_unused(*task.project, task.variant.warnings);
  result.warnings.add(held->found.warnings);
  result.arrays = [held] { return results::linear_system_arrays(held->found); };
  result.held = held;
  return result;
}

/// The values of one number: numbers in SI, or texts with units. None if it is not a list.
std::optional<std::vector<study::WrittenValue>> written_values(const Value& given) {
  const auto* list = std::get_if<std::vector<Value>>(&given);
  if (!list) return std::nullopt;
  std::vector<study::WrittenValue> values;
  for (const Value& one : *list) {
    if (const auto* number = std::get_if<double>(&one)) values.emplace_back(*number);
    else values.emplace_back(text_of(one));
  }
  return values;
}

study::SweepRequest sweep_request(const Task& task) {
  study::SweepRequest request;
  const std::vector<std::string> paths = task.keys.names("paths");
  const Value* values = task.keys.find("values");
  const auto* lists = std::get_if<std::vector<Value>>(values);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto list = lists && lists->size() == paths.size() ? written_values((*lists)[i]) : std::nullopt;
    if (!list) throw InvalidInput(task.keys.written("values") + ": a sweep has a list of values for each path");
    request.numbers.push_back(study::swept_number(task.variant, paths[i], *list));
  }
  request.of = task.keys.names("of");
  request.excitations = task.keys.names("excitations");
  const std::vector<double> band = task.keys.frequencies("band");
  if (!band.empty() && band.size() != 2)
    throw InvalidInput(task.keys.written("band") + ": it has two frequencies, FROM and TO");
  if (!band.empty()) request.band = {band[0], band[1]};
  request.quantity = quantity_of(task);
  return request;
}

Result sweep(const Task& task) {
  struct Found {
    study::SweepRequest request;
    study::DesignSweep sweep;
  };
  Found found{sweep_request(task), {}};
  found.sweep = study::design_sweep(task.variant, found.request, task.progress);
  const auto held = hold(task, std::move(found));
  const study::DesignSweep& sweep = held->found.sweep;
  Result result;
  result.warnings = without_unused(*task.project, task.variant.warnings);
  if (sweep.without_model > 0)
    result.warnings.warning("sweep", fmt::format("designs without a valid model: {}", sweep.without_model),
                            "their amplitudes are NaN; the first: " + sweep.first_failure, "");
  if (const auto infinite = sweep.highest.array().isInf().count(); infinite > 0)
    result.warnings.warning("sweep", fmt::format("infinite amplitudes: {} of {}", infinite, sweep.highest.size()),
                            "an undamped resonance, or a motion without limit at rest, lies in the band",
                            "give a band without it, or damping");
  result.arrays = [held] { return results::sweep_arrays(held->found.request, held->found.sweep); };
  result.held = held;
  return result;
}

}  // namespace

std::vector<Command> data_commands() {
  const Key of = {.name = "of", .kind = KeyKind::text, .about = "results, as in `response`", .repeatable = true};
  const Key quantity = {.name = "quantity",
                        .kind = KeyKind::choice,
                        .about = "of the motions among the results",
                        .choices = assembly::motion_names(),
                        .by_default = "displacement"};
  return {
      {.name = "matrices",
       .about = "mass, damping and stiffness matrices, loads, and the names of their rows",
       .group = Group::data,
       .of_one_case = true,
       .json = false,
       .for_programs = true,
       .run = matrices},
      {.name = "state_space",
       .about = "x' = A x + B u, y = C x + D u with inputs at the excitations and results as outputs",
       .group = Group::data,
       .of_one_case = true,
       .keys = {of,
                quantity,
                {.name = "nearest",
                 .kind = KeyKind::flag,
                 .about = "the nearest linear system in place of elements that depend on frequency"}},
       .json = false,
       .for_programs = true,
       .run = state_space},
      {.name = "sweep",
       .about = "largest amplitudes over all combinations of values of numbers of the model",
       .group = Group::design,
       .of_one_case = true,
       .looks_at = {"peaks"},
       .keys = {{.name = "paths", .kind = KeyKind::text, .about = "of the numbers, as in --set", .required = true},
                {.name = "values", .kind = KeyKind::text, .about = "a list of each number", .required = true},
                of,
                {.name = "excitations", .kind = KeyKind::text, .about = "harmonic ones that act", .repeatable = true},
                {.name = "band", .kind = KeyKind::text, .about = "FROM,TO in which amplitudes are sought"},
                quantity},
       .json = false,
       .for_programs = true,
       .run = sweep},
  };
}

}  // namespace trivet::engine
