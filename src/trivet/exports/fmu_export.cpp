// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/fmu_binaries.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/functional_mockup_unit.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/question.h"
#include "trivet/study/linear_system.h"

/// Functional mock-up units: inputs are the places of the excitations (study/linear_system.h), outputs the results that
/// the response of the file names. Frequency-dependent elements are replaced by their nearest linear system.
namespace trivet::exports {
namespace {

/// The results that the file asks for in time, else those of its response, else all coordinates.
project::AnswerSelection outputs(const project::Analyses& asked) {
  if (const auto found = asked.questions.find("transient"); found != asked.questions.end())
    return found->second->selection;
  return asked.response ? asked.response->selection : project::AnswerSelection();
}

/// States have names of their own: "state.machine.x" beside the output "machine.x".
LinearSystem with_names(LinearSystem system, const Content& content) {
  system.title = content.project.title.empty() ? content.words() : content.project.title;
  for (Signal& state : system.states) state.name = "state." + state.name;
  return system;
}

std::string unit_of_case(const Content& content, FmiVersion version, std::vector<std::string>& notes) {
  const project::AnswerSelection wanted = outputs(content.variant.analyses);
  study::LinearSystem system = study::linear_system(content.variant, wanted.of, wanted.quantity, true);
  if (system.inputs.empty())
    throw foundation::NotComputable(
        "fmu: the model has no excitation, so the unit would have no input; add one where a force or a motion acts");
  for (const foundation::Problem& warning : system.warnings.list()) notes.push_back(foundation::message(warning));
  const FmuBinaries binaries = built_fmu_binaries();
  if (binaries.windows_x86_64.empty())
    notes.emplace_back("the unit runs on Linux x86-64 only: no library for Windows was built");
  return functional_mockup_unit(with_names(system, content), version, binaries);
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
