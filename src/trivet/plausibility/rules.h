// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled_once.h"
#include "trivet/foundation/hertz.h"
#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

/// Rules for single numbers; each function adds its findings.
namespace trivet::plausibility {

using Suspicions = std::vector<Suspicion>;

using foundation::hertz;

/// True if `scale` of an element is probably meant in percent.
[[nodiscard]] bool is_scale_in_percent(double scale);

/// Two mounts at one place; one mount of a group far stiffer or softer than the others. Returns the elements that cause
/// these findings.
std::vector<std::size_t> judge_mounts(const model::System& system, const std::vector<BodyPicture>& pictures,
                                      Suspicions& found);

/// One of several equal mounts without damping, while the others have damping.
void judge_undamped(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Rotational stiffnesses that are impossible for mounts of this translational stiffness under this load. Call it only
/// for a body that is otherwise usual.
void judge_rotation(const model::System& system, const BodyPicture& picture, Suspicions& found);

/// Gravity in another unit or upwards.
void judge_gravity(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Centre of mass outside the mounts, mounts that lift off. Call it only if machine and gravity raise no suspicion.
void judge_balance(const model::System& system, const assembly::AssembledOnce& assembled, Suspicions& found);

/// Catalogue mounts whose static load is outside the range of their maker. Call it only if masses and gravity raise no
/// suspicion.
void judge_ratings(const model::System& system, const assembly::AssembledOnce& assembled,
                   const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Modal ratios and loss factors in percent, exchanged Rayleigh coefficients, factors of proportional damping.
void judge_damping(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Speeds without a unit that are usual in revolutions per minute.
void judge_speeds(const std::vector<Speed>& speeds, Suspicions& found);

/// Foundations far softer than the mounts on them.
void judge_foundations(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// A point or a force that is far from everything else of its body. Call it only if the machine raises no suspicion.
void judge_far_points(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Allowed motions larger than the body that moves.
void judge_limits(const model::System& system, const std::vector<AllowedMotion>& limits,
                  const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Pistons heavier than their machine.
void judge_engines(const model::System& system, const std::vector<Engine>& engines, Suspicions& found);

/// Motions of the ground far larger than the machine.
void judge_ground_motion(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found);

/// Struts whose free length is far from the distance of their ends.
void judge_struts(const model::System& system, Suspicions& found);

/// Gaps of stops, not in rotation, that are larger than machines usually have.
void judge_gaps(const model::System& system, Suspicions& found);

/// Dampers of one kind of which one is far stronger or weaker.
void judge_dampers(const model::System& system, Suspicions& found);

/// Rotors heavier than their machine, faster than steel can bear or with a balancing grade in another unit; unbalances
/// that would move the machine too far.
void judge_rotors(const model::System& system, const std::vector<Rotor>& rotors, Suspicions& found);

/// Limits on amplitudes of which none holds at the service speed of a rotor.
void judge_service_speeds(const std::vector<Rotor>& rotors, const std::vector<LimitedRange>& ranges, Suspicions& found);

/// Random excitations that end within a limit line over bands.
void judge_measured_ranges(const model::System& system, const std::vector<BandLine>& lines, Suspicions& found);

/// Bands and spectra without a resonance, transients that end too early, pulses that last too long.
void judge_analyses(const model::System& system, const assembly::AssembledOnce& assembled, const Stated& stated,
                    Suspicions& found);

}  // namespace trivet::plausibility
