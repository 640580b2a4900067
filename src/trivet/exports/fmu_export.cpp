// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "trivet/exports/format_table.h"
#include "trivet/exports/functional_mockup_unit.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analysis.h"
#include "trivet/study/explain/linear_system.h"

/// Functional mock-up units: inputs are the places of the excitations (study/explain/linear_system.h), outputs the
/// results that the response of the file names. Frequency-dependent elements are replaced by their nearest linear
/// system.
namespace trivet::exports {
namespace {

/// The results that the file requests in time, else those of its response, else all coordinates.
project::ChannelSelection outputs(const project::Analyses& request) {
  if (request.transient) return request.transient->selection;
  return request.response ? request.response->selection : project::ChannelSelection();
}

bool share_a_name(const std::vector<Signal>& some, const std::vector<Signal>& others) {
  return std::ranges::any_of(some, [&](const Signal& one) {
    return std::ranges::any_of(others, [&](const Signal& other) { return other.name == one.name; });
  });
}

void add_prefix(const std::string& prefix, std::vector<Signal>& signals) {
  for (Signal& signal : signals) signal.name = prefix + signal.name;
}

/// States have names of their own: "state.machine.x" beside the output "machine.x". So have inputs if one would have
/// the name of an output: "input.machine.x" of an excitation that is called like a body.
LinearSystem with_names(LinearSystem system, const Content& content, std::vector<std::string>& notes) {
  system.title = content.project.title.empty() ? content.words() : content.project.title;
  do add_prefix("state.", system.states);
  while (share_a_name(system.states, system.outputs));
  if (!share_a_name(system.inputs, system.outputs) && !share_a_name(system.inputs, system.states)) return system;
  do add_prefix("input.", system.inputs);
  while (share_a_name(system.inputs, system.outputs) || share_a_name(system.inputs, system.states));
  notes.push_back("an excitation has the name of a body or a result: the inputs have the prefix of " +
                  foundation::quoted(system.inputs.front().name));
  return system;
}

std::string unit_of_case(const Content& content, FmiVersion version, std::vector<std::string>& notes) {
  const project::ChannelSelection wanted = outputs(content.variant.analyses);
  study::LinearSystem system = study::linear_system(content.variant, wanted.of, wanted.quantity, true);
  if (system.inputs.empty())
    throw foundation::NotComputable(
        "fmu: the model has no excitation, so the unit would have no input; add one where a force or a motion acts");
  for (const foundation::Problem& warning : system.warnings.list()) notes.push_back(foundation::message(warning));
  const FmuBinaries binaries = built_fmu_binaries();
  if (binaries.windows_x86_64.empty())
    notes.emplace_back("the unit runs on Linux x86-64 only: no library for Windows was built");
  return functional_mockup_unit(with_names(std::move(system), content, notes), version, binaries);
}

std::vector<std::string> write_fmi2(const Content& content, const Target& target, const foundation::Progress&) {
  std::vector<std::string> notes;
  write_bytes(target.path(), unit_of_case(content, FmiVersion::two, notes));
  return notes;
}

std::vector<std::string> write_fmi3(const Content& content, const Target& target, const foundation::Progress&) {
  std::vector<std::string> notes;
  write_bytes(target.path(), unit_of_case(content, FmiVersion::three, notes));
  return notes;
}

}  // namespace

const Format fmu_format = {
    "fmu",     "functional mock-up unit, FMI 2.0: co-simulation and model exchange", Target::Kind::file, {}, true,
    write_fmi2};
const Format fmu3_format = {"fmu3", "the same as FMI 3.0", Target::Kind::file, {}, true, write_fmi3};

}  // namespace trivet::exports
