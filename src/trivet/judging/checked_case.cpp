// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/checked_case.h"

#include <string>
#include <utility>

#include "trivet/foundation/thread_progress.h"
#include "trivet/judging/design_corners.h"
#include "trivet/judging/rest_state.h"
#include "trivet/judging/suspicions.h"
#include "trivet/judging/uncounted_excitations.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/element_types.h"
#include "trivet/project/text/part_tables.h"
#include "trivet/response/transient/transient_refusals.h"

namespace trivet::judging {
namespace {

/// Reports a transient analysis of a model without constant coefficients in time.
void check_transient(const model::System& system, const project::Analyses& request, foundation::Problems& problems) {
  const auto& analysis = request.transient;
  if (!analysis) return;
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto problem = response::without_motion_in_time(
      system, assembled, response::time_inputs(system, assembled, analysis->selection.excitations),
      analysis->nearest_linear_system);
  if (problem) problems.error("analyses.transient", problem->finding, problem->rule, problem->remedy);
}

/// Settles the machine and checks it together with the analyses; the problems of the model, with their places.
foundation::Problems settled_and_checked(project::ReadCase& read, const project::AnalysisFilter& filter) {
  foundation::Problems found = read.of_model;
  if (!read.system) {
    name_slips(read.bodies, read.document, found);
  } else {
    if (read.has_every_part) settle(*read.system, found);
    found.add(project::too_large(read.system->description(), project::counted_part(filter, read.analyses)));
    if (!read.of_text.has_errors()) {
      project::check_analyses(*read.system, read.analyses, filter, read.name, found);
      if (!project::is_only_setting("transient", filter, read.name))
        check_transient(*read.system, read.analyses, found);
      warn_of_small_motions(*read.system, read.analyses, found);
      if (project::is_requested("requirements", filter, read.name) ||
          project::is_requested("limits", filter, read.name))
        warn_of_uncounted_excitations(*read.system, read.analyses, found);
    }
  }
  project::locate(found, read.document);
  return found;
}

}  // namespace

std::optional<project::Case> checked_case(project::ReadCase read, const project::AnalysisFilter& filter,
                                          const project::Case* base, foundation::Problems& problems) {
  foundation::report_progress(foundation::thread_progress(), "opening the project", 0);
  foundation::Problems all = read.of_text;
  all.add(settled_and_checked(read, filter));
  project::name_element_types(read.written, all);
  project::gather_columns(all);
  all = project::without_unrequested(all, filter, read.name, read.analyses);
  const bool new_map = read.analyses.map && (!base || !(base->analyses.map == read.analyses.map));
  const bool new_parameters = !base && !read.analyses.parameters.empty();
  if (new_map || new_parameters) {
    check_corners(read, new_map, new_parameters, filter, all);
    all = project::without_unrequested(all, filter, read.name, read.analyses);
  }
  const bool good = !all.has_errors();
  all.sort_by_origin();
  problems.add(all);
  if (!good || !read.system) return std::nullopt;
  return project::Case{std::move(read.name),     {},
                       std::move(*read.system),  std::move(read.analyses),
                       std::move(all),           std::move(read.written),
                       std::move(read.document), std::move(read.display),
                       std::move(read.of_text)};
}

}  // namespace trivet::judging
