// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/case_context.h"

#include <algorithm>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/modal_ground.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/analyses/question_sizes.h"

namespace trivet::study {
namespace {

constexpr double default_band_factor = 1.3;

}  // namespace

CaseContext::CaseContext(std::shared_ptr<const SolvedCase> solved_case, const foundation::Progress& shown_progress)
    : solved_(std::move(solved_case)),
      system(solved_->system),
      progress(shown_progress),
      assembled(solved_->assembled),
      modes(solved_->modes) {}

Eigen::VectorXcd CaseContext::resonances() const {
  constexpr Eigen::Index large = 60;  // whose roots take some hundredths of a second
  if (assembled.matrices.size() <= large || assembled.frequency_dependent()) return roots().poles;
  Eigen::VectorXcd natural(to_index(modes.list.size()));
  for (std::size_t i = 0; i < modes.list.size(); ++i)
    natural(to_index(i)) = {0, modes.list[i].angular_frequency.value_or(0)};
  return natural;
}

assembly::Band default_band(const CaseContext& c) {
  double highest = 0;
  for (const modal::Mode& mode : c.modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  for (const modal::Root& root : c.roots().list) highest = std::max(highest, root.damped_angular_frequency.value_or(0));
  assembly::Band band{0, highest > 0 ? default_band_factor * highest : 1.0};
  for (const assembly::ElementMap& map : c.assembled.elements)
    band = {std::max(band.from, map.defined_from), std::min(band.to, map.defined_to)};
  return band;
}

bool is_too_large_for_roots(const assembly::Assembled& assembled) {
  return assembled.matrices.size() > to_index(project::most_coordinates);
}

foundation::Problems warning_of_unknown_roots() {
  foundation::Problems warnings;
  warnings.warning("roots", "the stiffness or the damping may feed energy",
                   "motions may grow, and the damped roots of so large a model are not computed",
                   "check the damping, or split the model and compute its roots");
  return warnings;
}

foundation::NotComputable without_excitation(const std::string& question) {
  const project::MissingExcitation missing = project::missing_excitation(project::drive_of(question));
  return foundation::NotComputable(question + ": " + missing.finding + "; " + missing.remedy);
}

std::vector<assembly::Channel> channels_of(const CaseContext& c, const project::AnswerSelection& selection) {
  return assembly::channels(c.system, c.assembled, selection.of, selection.quantity);
}

std::vector<double> grid_over(const CaseContext& c, const std::vector<assembly::Channel>& channels,
                              const assembly::Loading& loading, const response::Peaks& peaks,
                              const assembly::Band& band) {
  return response::automatic_grid(c.assembled, channels, loading, c.roots().poles, peaks, band, c.progress);
}

void require_rigid_ground(const CaseContext& c, const std::string& question) {
  if (const auto standing = model::element_on_modes(c.system.description()))
    throw foundation::NotComputable(
        question + ": \"" + *standing +
        "\" is mounted on a modal foundation, for which a rigid motion of the ground is not defined; describe it "
        "by an impedance or a mobility, or as a body on its own elements");
}

}  // namespace trivet::study
