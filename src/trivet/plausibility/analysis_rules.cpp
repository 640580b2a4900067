// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"
#include "trivet/plausibility/rules.h"

namespace trivet::plausibility {
namespace {

/// A resonance this far outside a band still has an effect in it.
constexpr double margin = 1.1;
/// Natural frequencies of a usual machine [Hz].
constexpr double usual_from = 0.5, usual_to = 200;
/// Larger systems are not solved for this check.
constexpr Eigen::Index most_coordinates = 300;
/// A pulse has at most this many pieces; a longer history is a record, which may be cut after its largest value.
constexpr std::size_t most_pieces_of_pulse = 8;

/// Periods of the lowest mode from which a pulse is no shock; in milliseconds it would be one.
constexpr double most_periods_of_pulse = 20, shock_from = 0.05, shock_to = 5;

/// Standards on vibration allow velocities of mm/s, far below this [m/s].
constexpr double fastest_allowed = 0.5;

/// Natural frequencies above 0, ascending [rad/s]; empty if the system is too large or has no such modes.
std::vector<double> natural_frequencies(const model::System& system, const assembly::AssembledOnce& once) {
  std::vector<double> result;
  if (6 * to_index(system.bodies().size()) > most_coordinates) return result;
  try {
    const assembly::Assembled& assembled = *once;
    if (assembled.layout.size() > most_coordinates) return result;
    const numerics::MassiveSystem massive = numerics::massive_system(assembled.matrices);
    for (const double lambda : numerics::generalized_modes(massive.K, massive.A, assembled.matrices.symmetric).lambda)
      if (lambda > 0) result.push_back(std::sqrt(lambda));
  } catch (const foundation::NotComputable&) {  // a coordinate without mass and stiffness: the analyses report it
    result.clear();
  }
  std::ranges::sort(result);
  return result;
}

bool holds_any(const Window& window, const std::vector<double>& natural, double factor) {
  return std::ranges::any_of(
      natural, [&](double w) { return factor * w * margin >= window.from && factor * w <= window.to * margin; });
}

/// A window to avoid whose numbers, had they been meant in hertz, would hold a natural frequency that it misses in
/// rad/s: the requirement would be met by the slip alone.
void judge_avoided(const Window& window, const std::vector<double>& natural, Suspicions& found) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto inside = [&](double factor) {
    return std::ranges::find_if(natural,
                                [&](double w) { return w >= factor * window.from && w <= factor * window.to; });
  };
  const auto meant = inside(turn);
  if (inside(1) != natural.end() || meant == natural.end()) return;
  found.push_back(
      {"band", window.subject, fmt::format("{:.4g} … {:.4g} Hz", hertz(window.from), hertz(window.to)),
       fmt::format("numbers without a unit are in rad/s; in Hz they would hold the natural frequency {:.4g} "
                   "Hz",
                   hertz(*meant)),
       fmt::format("write [\"{:.6g} Hz\", \"{:.6g} Hz\"] if hertz are meant, or [\"{:.6g} rad/s\", "
                   "\"{:.6g} rad/s\"]",
                   window.from, window.to, window.from, window.to)});
}

void judge_window(const Window& window, const std::vector<double>& natural, Suspicions& found) {
  if (window.avoided) return judge_avoided(window, natural, found);
  if (holds_any(window, natural, 1)) return;
  const double thousand = std::sqrt(1000.0);
  const auto explains = [&](double factor) {
    return holds_any(window, natural, factor) && hertz(factor * natural.front()) > usual_from &&
        hertz(factor * natural.back()) < usual_to;
  };
  const char* typed = explains(thousand) ? "N/mm typed as N/m" : explains(1 / thousand) ? "N/m typed as N/mm" : nullptr;
  const std::string stiffness =
      typed ? fmt::format("; or suspicion \"stiffness\": with stiffnesses in {} some would be in it", typed) : "";
  found.push_back({window.spectrum ? "spectrum" : "band", window.subject,
                   fmt::format("{:.4g} … {:.4g} Hz", hertz(window.from), hertz(window.to)),
                   fmt::format("no natural frequency is in it: those of {} are {:.4g} … {:.4g} Hz",
                               window.subject.starts_with("analyses.steady")
                                   ? "small motions about rest, in which friction sticks and no gap closes,"
                                   : "the machine",
                               hertz(natural.front()), hertz(natural.back())),
                   std::string(window.spectrum ? "rows of a psd without units are in Hz; " : "") +
                       "change the band, or check masses and stiffnesses if the resonances should be in it" +
                       stiffness});
}

/// Effective end of a history: the end of a pulse, the largest value of a record. [s]
double end_of(const excitation::Signal& signal) {
  if (signal.pieces.size() <= most_pieces_of_pulse) return signal.pieces.back().start;
  // the last piece is the state after it, 0 or constant
  double largest = 0, at = signal.pieces.front().start;
  for (const excitation::Piece& piece : signal.pieces)
    if (std::abs(piece.value) > largest) largest = std::abs(piece.value), at = piece.start;
  return at;
}

/// A half-sine or a rectangle: it rises and returns to 0, without oscillation.
bool is_pulse(const excitation::Signal& signal) {
  if (signal.pieces.size() < 2 || signal.pieces.size() > most_pieces_of_pulse) return false;
  const excitation::Piece& rest = signal.pieces.back();
  if (rest.value != 0 || rest.rate != 0 || rest.curvature != 0) return false;
  for (std::size_t i = 0; i + 1 < signal.pieces.size(); ++i) {
    const excitation::Piece& piece = signal.pieces[i];
    constexpr double one_cycle = 2 * std::numbers::pi * (1 + 1e-9);
    if (piece.kappa * (signal.pieces[i + 1].start - piece.start) > one_cycle) return false;
  }
  return true;
}

void judge_pulses(const model::System& system, const TimeAnalysis& analysis, double lowest, Suspicions& found) {
  for (const model::Excitation& excitation : system.description().excitations) {
    const auto* history = std::get_if<model::History>(&excitation.course);
    if (!history || !model::is_selected(excitation, analysis.excitations) || !is_pulse(history->signal)) continue;
    const double duration = history->signal.pieces.back().start - history->signal.pieces.front().start;
    const double periods = duration * hertz(lowest), meant = periods / 1000;
    if (periods > most_periods_of_pulse && meant > shock_from && meant < shock_to)
      found.push_back(
          {"pulse", "excitations." + excitation.name + ".history", fmt::format("it lasts {:.6g} s", duration),
           fmt::format(
               "over more than {:.0f} periods of the lowest mode ({:.4g} Hz) a pulse acts like a constant force",
               most_periods_of_pulse, hertz(lowest)),
           fmt::format("it would last {:.6g} s if the number was meant in milliseconds", duration / 1000)});
  }
}

void judge_transient(const model::System& system, const TimeAnalysis& analysis, const std::vector<double>& natural,
                     Suspicions& found) {
  double latest = 0;
  std::string name;
  for (const model::Excitation& excitation : system.description().excitations) {
    const auto* history = std::get_if<model::History>(&excitation.course);
    if (!history || !model::is_selected(excitation, analysis.excitations) || history->signal.pieces.empty()) continue;
    const double end = end_of(history->signal) + excitation.action.delay;
    if (name.empty() || end > latest) latest = end, name = excitation.name;
  }
  const std::string finding = fmt::format("it ends at {:.6g} s", analysis.to.value_or(0));
  if (analysis.to && *analysis.to < latest) {
    found.push_back({"transient", "analyses.transient.to", finding,
                     fmt::format("\"{}\" lasts until {:.6g} s", name, latest), "let it end some periods later"});
    return;
  }
  if (natural.empty()) return;
  judge_pulses(system, analysis, natural.front(), found);
  const double half_period = std::numbers::pi / natural.front();
  if (analysis.to && *analysis.to - latest < half_period)
    found.push_back(
        {"transient", "analyses.transient.to", finding,
         fmt::format("half a period of the lowest mode ({:.4g} Hz) is {:.4g} s{}", hertz(natural.front()), half_period,
                     name.empty() ? "" : fmt::format(", after \"{}\" at {:.4g} s", name, latest)),
         "let it end some periods later: the largest response occurs in this time"});
}

}  // namespace

void judge_limits(const model::System& system, const std::vector<AllowedMotion>& limits,
                  const std::vector<BodyPicture>& pictures, Suspicions& found) {
  for (const AllowedMotion& limit : limits) {
    const auto picture = std::ranges::find_if(
        pictures, [&](const BodyPicture& p) { return system.bodies()[p.body].name == limit.body; });
    if (picture == pictures.end()) continue;
    const double written = limit.amplitude * limit.as_written;
    const auto finding = [&](const char* unit) {
      return fmt::format("{:.6g} {}{} allowed for {}", written, unit, limit.level_ending, limit.channel);
    };
    const auto remedy = [&](const char* unit) {
      return limit.is_line
          ? fmt::format("write unit = \"{}\" if they are in it: rows without a unit are in SI", unit)
          : fmt::format("write \"{:.6g} {}{}\" if millimetres are meant", written, unit, limit.level_ending);
    };
    if (limit.is_velocity && limit.amplitude > fastest_allowed)
      found.push_back({"limit", limit.subject, finding("m/s"),
                       fmt::format("vibration limits are below {:.1g} m/s", fastest_allowed), remedy("mm/s")});
    const double size = 2 * mass_radius(picture->mass);
    if (limit.is_velocity || !(size > 0) || limit.amplitude <= size) continue;
    found.push_back({"limit", limit.subject, finding("m"),
                     fmt::format("it exceeds the size of \"{}\", {:.3g} m, so that it has no effect", limit.body, size),
                     remedy("mm")});
  }
}

void judge_ground_motion(const model::System& system, const std::vector<BodyPicture>& pictures, Suspicions& found) {
  constexpr double farthest = 10,
                   sizes = 10;  // [m], and sizes of the largest body: an earthquake moves the ground by 1 m
  double size = 0;
  for (const BodyPicture& picture : pictures) size = std::max(size, 2 * mass_radius(picture.mass));
  for (const model::Excitation& excitation : system.description().excitations) {
    const model::Action& action = excitation.action;
    if (action.body || action.derivative != 0 || !(size > 0)) continue;
    double amplitude = action.amplitude.head<3>().cwiseAbs().maxCoeff();
    if (const auto* history = std::get_if<model::History>(&excitation.course)) {
      double largest = 0;
      for (const excitation::Piece& piece : history->signal.pieces)
        largest = std::max({largest, std::abs(piece.value), piece.kappa > 0 ? std::abs(piece.rate) / piece.kappa : 0});
      amplitude *= largest;
    } else if (!std::holds_alternative<model::Harmonic>(excitation.course)) {
      continue;
    }
    if (amplitude > farthest && amplitude > sizes * size)
      found.push_back({"ground motion", "excitations." + excitation.name,
                       fmt::format("the ground moves by {:.4g} m", amplitude),
                       fmt::format("the machine is {:.2g} m large", size),
                       "add quantity = \"acceleration\" if an acceleration is meant"});
  }
}

std::vector<Suspicion> suspicions_about(const model::System& system, const std::vector<Window>& windows) {
  Suspicions found;
  judge_analyses(system, assembly::AssembledOnce(system), {.windows = windows}, found);
  return found;
}

void judge_analyses(const model::System& system, const assembly::AssembledOnce& assembled, const Stated& stated,
                    Suspicions& found) {
  if (stated.windows.empty() && !stated.transient) return;
  const std::vector<double> natural = natural_frequencies(system, assembled);
  if (!natural.empty())
    for (const Window& window : stated.windows) judge_window(window, natural, found);
  if (stated.transient) judge_transient(system, *stated.transient, natural, found);
}

}  // namespace trivet::plausibility
