// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/suspicion.h"

#include <algorithm>

#include "trivet/plausibility/inertia_slips.h"
#include "trivet/plausibility/rules.h"
#include "trivet/plausibility/unit_slips.h"

namespace trivet::plausibility {
namespace {

bool touches(const BodyPicture& picture, const std::vector<std::size_t>& elements) {
  return std::any_of(picture.attachments.begin(), picture.attachments.end(),
                     [&](const Attachment& a) { return std::find(elements.begin(), elements.end(),
                         a.element) != elements.end(); });
}

/// Slips of elements are made once for the whole file: one entry for all bodies that show the same.
bool is_repeated(const BodyVerdict& verdict, const std::vector<BodyVerdict>& before) {
  if (!verdict.slip || (verdict.slip->stiffness == 1 && verdict.slip->places == 1
      && verdict.slip->rotation == 1)) return false;
  return std::any_of(before.begin(), before.end(), [&](const BodyVerdict& other) {
    return other.slip && other.suspicion.kind == verdict.suspicion.kind
        && other.slip->stiffness == verdict.slip->stiffness && other.slip->places == verdict.slip->places
        && other.slip->rotation == verdict.slip->rotation;
  });
}

}  // namespace

std::vector<Suspicion> suspicions(const model::System& system, const Stated& stated) {
  Suspicions found;
  const std::vector<BodyPicture> all = pictures(system, stated.inertia_about_pole, stated.from_solids);
  const std::vector<std::size_t> blamed = judge_mounts(system, all, found);
  std::vector<BodyVerdict> verdicts;
  for (const BodyPicture& picture : all)
    if (auto verdict = judge(system, picture, stated.windows)) {
      const bool explained = touches(picture, blamed) && (!verdict->slip || verdict->slip->stiffness != 1);
      if (!explained && !is_repeated(*verdict, verdicts)) verdicts.push_back(std::move(*verdict));
    }
  for (const BodyPicture& picture : all) {
    const bool doubted = std::any_of(verdicts.begin(), verdicts.end(),
        [&](const BodyVerdict& v) { return v.body == picture.body; });
    auto products = doubtful_products(system.bodies()[picture.body].name, picture);
    if (products && !doubted) found.push_back(std::move(*products));
    if (verdicts.empty() && blamed.empty()) judge_rotation(system, picture, found);
  }
  const bool machine_doubtful = !found.empty() || !verdicts.empty();
  const bool gravity_doubtful = judge_gravity(system, all, found);
  // What follows from a wrong mass, place, stiffness or gravity is not a suspicion of its own.
  const bool mass_doubtful = std::any_of(verdicts.begin(), verdicts.end(), [](const BodyVerdict& v) { return v.slip
      && v.slip->mass != 1; });
  if (!machine_doubtful && !gravity_doubtful) judge_balance(system, found);
  if (!mass_doubtful && !gravity_doubtful) {
    const std::size_t before = found.size();
    judge_ratings(system, all, stated.ratings, found);
    if (found.size() > before) std::erase_if(verdicts, [](const BodyVerdict& v) { return !v.slip; });
         // too small a mount sags too far
  }
  for (const BodyVerdict& verdict : verdicts) found.push_back(verdict.suspicion);
  judge_damping(system, all, found);
  judge_rotors(system, stated.rotors, found);
  judge_speeds(stated.speeds, found);
  if (!machine_doubtful) judge_limits(stated.allowed_motions, all, found);
  if (!machine_doubtful) judge_foundations(system, found);
  if (verdicts.empty() && blamed.empty()) judge_questions(system, stated, found);
  return found;
}

}  // namespace trivet::plausibility
