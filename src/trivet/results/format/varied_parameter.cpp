// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/varied_parameter.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"

namespace trivet::results {

using nonlinear::Parameter;
using nonlinear::SteadyBranch;

const char* varied_word(const SteadyBranch& branch) {
  if (branch.over == Parameter::load_factor) return "load";
  return branch.of_shaft ? "speed" : "frequency";
}

std::string varied_unit(const SteadyBranch& branch, const project::ShownUnits& display) {
  if (branch.over == Parameter::load_factor) return "times the load";
  return branch.of_shaft ? "rpm" : frequency_unit(display);
}

std::string varied_heading(const SteadyBranch& branch, const project::ShownUnits& display) {
  if (branch.over == Parameter::load_factor) return "load factor";
  return branch.of_shaft ? "shaft speed [rpm]" : frequency_heading(display);
}

double shown_varied(const SteadyBranch& branch, double parameter, const project::ShownUnits& display) {
  if (branch.over == Parameter::load_factor) return parameter;
  return branch.of_shaft ? parameter * foundation::rpm_per_rad_s : shown_frequency(display, parameter);
}

std::string begun_words(const SteadyBranch& branch, const project::ShownUnits& display) {
  if (!branch.begun_at) return "the one at the lower end of the band";
  return fmt::format("the one at {} {}", number_text(shown_varied(branch, *branch.begun_at, display), 5),
                     varied_unit(branch, display));
}

}  // namespace trivet::results
