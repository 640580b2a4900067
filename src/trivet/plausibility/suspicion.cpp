// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/plausibility/suspicion.h"

#include <algorithm>

#include "trivet/plausibility/inertia_slips.h"
#include "trivet/plausibility/rules.h"
#include "trivet/plausibility/unit_slips.h"

namespace trivet::plausibility {
namespace {

bool touches(const BodyPicture& picture, const std::vector<std::size_t>& elements) {
  return std::ranges::any_of(picture.attachments, [&](const Attachment& a) {
    return std::ranges::find(elements, a.element) != elements.end();
  });
}

/// A slip in the elements is made once for the whole file: one entry for all bodies with the same slip.
bool is_repeated(const BodyVerdict& verdict, const std::vector<BodyVerdict>& before) {
  if (!verdict.slip || (verdict.slip->stiffness == 1 && verdict.slip->places == 1 && verdict.slip->rotation == 1))
    return false;
  return std::ranges::any_of(before, [&](const BodyVerdict& other) {
    return other.slip && other.suspicion.kind == verdict.suspicion.kind &&
        other.slip->stiffness == verdict.slip->stiffness && other.slip->places == verdict.slip->places &&
        other.slip->rotation == verdict.slip->rotation;
  });
}

}  // namespace

std::string table_of(const std::string& subject) {
  const std::size_t dot = subject.find('.');
  if (dot == std::string::npos) return "";
  const std::string first = subject.substr(0, dot);
  const bool single = first == "damping" || first == "limits" || first == "requirements" || first == "operation";
  return single ? first : subject.substr(0, subject.find('.', dot + 1));
}

std::vector<Suspicion> suspicions(const model::System& system, const assembly::AssembledOnce& assembled,
                                  const Stated& stated) {
  const auto casts_doubt = [&](const Suspicion& s) {
    const std::pair<std::string, std::string> key{table_of(s.subject), s.kind};
    return std::ranges::find(stated.accepted, key) == stated.accepted.end();
  };
  Suspicions found;
  const auto doubt_since = [&](std::size_t count) {
    return std::any_of(found.begin() + static_cast<std::ptrdiff_t>(count), found.end(), casts_doubt);
  };
  const std::vector<BodyPicture> all = pictures(system, stated.inertia_about_pole, stated.from_solids);
  std::vector<std::size_t> blamed = judge_mounts(system, all, found);
  const bool scales_accepted =
      std::ranges::any_of(found, [&](const Suspicion& s) { return s.kind == std::string("scale") && !casts_doubt(s); });
  std::erase_if(blamed, [&](std::size_t e) {
    if (is_scale_in_percent(system.elements()[e].law.scale)) return scales_accepted;  // one entry for all of them
    const std::string table = "elements." + system.elements()[e].name;
    return std::ranges::any_of(found,
                               [&](const Suspicion& s) { return table_of(s.subject) == table && !casts_doubt(s); });
  });

  std::vector<BodyVerdict> verdicts;
  for (const BodyPicture& picture : all)
    if (auto verdict = judge(system, picture, stated.windows)) {
      const bool explained = touches(picture, blamed) && (!verdict->slip || verdict->slip->stiffness != 1);
      if (!explained && !is_repeated(*verdict, verdicts)) verdicts.push_back(std::move(*verdict));
    }
  const auto doubted = [&](const BodyVerdict& v) { return casts_doubt(v.suspicion); };
  const bool bodies_doubtful = std::ranges::any_of(verdicts, doubted);
  for (const BodyPicture& picture : all) {
    const bool own =
        std::ranges::any_of(verdicts, [&](const BodyVerdict& v) { return v.body == picture.body && doubted(v); });
    auto products = doubtful_products(system.bodies()[picture.body].name, picture);
    if (products && !own) found.push_back(std::move(*products));
    if (!bodies_doubtful && blamed.empty()) judge_rotation(system, picture, found);
  }
  const bool machine_doubtful = bodies_doubtful || doubt_since(0);
  const std::size_t before_gravity = found.size();
  judge_gravity(system, all, found);
  const bool gravity_doubtful = doubt_since(before_gravity);
  // A consequence of a wrong mass, place, stiffness or gravity is not a separate suspicion.
  const bool mass_doubtful =
      std::ranges::any_of(verdicts, [&](const BodyVerdict& v) { return v.slip && v.slip->mass != 1 && doubted(v); });
  if (!machine_doubtful && !gravity_doubtful) judge_balance(system, assembled, found);
  if (!mass_doubtful && !gravity_doubtful) {
    const std::size_t before = found.size();
    judge_ratings(system, assembled, all, found);
    if (doubt_since(before))  // a mount that is too small sags too far
      std::erase_if(verdicts, [](const BodyVerdict& v) { return !v.slip; });
  }
  for (const BodyVerdict& verdict : verdicts) found.push_back(verdict.suspicion);
  if (!bodies_doubtful && blamed.empty()) judge_undamped(system, all, found);
  judge_damping(system, all, found);
  judge_speeds(stated.speeds, found);
  judge_rotors(system, stated.rotors, found);
  judge_engines(system, stated.engines, found);
  judge_dampers(system, found);
  judge_struts(system, found);
  if (!machine_doubtful) {
    judge_gaps(system, found);
    judge_far_points(system, all, found);
    judge_limits(system, stated.allowed_motions, all, found);
    judge_foundations(system, all, found);
    judge_ground_motion(system, all, found);
    judge_measured_ranges(system, stated.band_lines, found);
    judge_service_speeds(stated.rotors, stated.limited_ranges, found);
  }
  if (!bodies_doubtful && blamed.empty()) judge_analyses(system, assembled, stated, found);
  return found;
}

}  // namespace trivet::plausibility
