// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/single_mount_forces.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/isolation_reader.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::study {
namespace {

/// Largest length of Re(v e^{iωt}) over a period: the longer half axis of its ellipse.
double longer_half_axis(const Eigen::Vector3cd& v) {
  const double square = std::abs((v.array() * v.array()).sum());
  return std::sqrt(0.5 * (v.squaredNorm() + square));
}

/// An excitation of unit size and what it transmits: the total along its axes, then six components of each mount.
struct MountTransmission {
  response::ExcitationTransmission total;
  std::vector<std::size_t> mounts;
  std::vector<assembly::Channel> channels;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the mounts' points on the ground
};

MountTransmission mount_transmission(const CaseContext& c, const std::string& force) {
  MountTransmission result{
      response::excitation_transmission(c.system, c.assembled, force), response::mounts(c.system), {}};
  result.channels = result.total.channels;
  for (const std::size_t e : result.mounts) {
    const model::Element& mount = c.system.elements()[e];
    std::vector<std::string> names;
    for (const char* kind : {"force", "moment"})
      for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("{}.{}.{}", mount.name, kind, axis));
    for (assembly::Channel& one :
         assembly::channels(c.system, c.assembled, names, assembly::MotionQuantity::displacement))
      result.channels.push_back(std::move(one));
    result.centre += mount.n.at / static_cast<double>(result.mounts.size());
  }
  return result;
}

/// Shares of a unit excitation at one frequency.
struct MountShares {
  double angular_frequency = 0;
  double total = 0;  ///< largest |T| of its axes
  double sum = 0;    ///< of the single mounts
  double largest = 0;
  std::size_t at = 0;          ///< the mount with the largest share
  Eigen::Index component = 0;  ///< and its largest component of force
};

MountShares mount_shares(const CaseContext& c, const MountTransmission& of, double omega) {
  const auto curves = response::frequency_response(c.assembled, of.channels, of.total.loading, {omega}).curves;
  MountShares result{.angular_frequency = omega};
  const std::size_t axes = of.total.channels.size();
  for (std::size_t i = 0; i < axes; ++i) result.total = std::max(result.total, std::abs(curves[i].value(0)));
  for (std::size_t m = 0; m < of.mounts.size(); ++m) {
    Eigen::Vector3cd force, moment;
    for (std::size_t j = 0; j < 3; ++j) {
      force(to_index(j)) = curves[axes + 6 * m + j].value(0);
      moment(to_index(j)) = curves[axes + 6 * m + 3 + j].value(0);
    }
    if (of.total.directions.front().rotation)
      moment += (c.system.elements()[of.mounts[m]].n.at - of.centre).cast<std::complex<double>>().cross(force);
    const double share = longer_half_axis(of.total.directions.front().rotation ? moment : force);
    result.sum += share;
    if (share <= result.largest) continue;
    result.largest = share;
    result.at = of.mounts[m];
    force.cwiseAbs().maxCoeff(&result.component);
  }
  return result;
}

/// The ends of a band and its natural frequencies.
std::vector<double> examined_frequencies(const CaseContext& c, const assembly::Band& band) {
  std::vector<double> omegas = {band.from};
  if (band.to > band.from && std::isfinite(band.to)) omegas.push_back(band.to);
  for (const modal::Mode& mode : c.modes.list)
    if (mode.angular_frequency && *mode.angular_frequency > band.from && *mode.angular_frequency < band.to)
      omegas.push_back(*mode.angular_frequency);
  return omegas;
}

/// What the mounts may transmit singly: the excitation; of a moment not less than it gives at rest, where the places
/// of the mounts alone decide.
double allowed_singly(const CaseContext& c, const MountTransmission& of) {
  if (!of.total.directions.front().rotation) return 1;
  double slowest = 0;  // a table of stiffness may begin above 0 Hz
  for (const assembly::ElementMap& map : c.assembled.elements) slowest = std::max(slowest, map.defined_from);
  const double slow = mount_shares(c, of, slowest).sum;
  return std::isfinite(slow) ? std::max(1.0, slow) : 1;
}

std::optional<MountShares> worst_shares(const CaseContext& c, const MountTransmission& of, const assembly::Band& band) {
  constexpr double round_off = 1e-9;
  const double allowed = (1 + round_off) * allowed_singly(c, of);
  std::optional<MountShares> worst;
  for (const double omega : examined_frequencies(c, band)) {
    constexpr double aside = 1e-6;  // of an undamped resonance, where the forces are unbounded
    MountShares one = mount_shares(c, of, omega);
    if (!std::isfinite(one.sum)) one = mount_shares(c, of, (1 + aside) * omega);
    if (one.sum > allowed && one.total <= 1 + round_off && (!worst || one.sum > worst->sum)) worst = one;
  }
  return worst;
}

std::string nearest_natural_frequency(const CaseContext& c, double omega) {
  std::optional<double> nearest;
  for (const modal::Mode& mode : c.modes.list)
    if (const double own = mode.angular_frequency.value_or(0);
        own > 0 && (!nearest || std::abs(std::log(own / omega)) < std::abs(std::log(*nearest / omega))))
      nearest = own;
  if (!nearest) return "";
  return fmt::format(" (the nearest natural frequency is {:.5g} Hz)", *nearest / foundation::two_pi);
}

/// Is the largest component of the force of this mount limited anyway?
bool is_limited(const CaseContext& c, const project::Analyses& analyses, const MountShares& found) {
  const std::string name = fmt::format("{}.force.{}", c.system.elements()[found.at].name, "xyz"[found.component]);
  const auto is_it = [&](const auto& limit) { return limit.name == name; };
  const auto& limits = analyses.requirements->limits;
  return std::ranges::any_of(analyses.limits, is_it) || std::ranges::any_of(limits, is_it);
}

void warn_of_shares(const CaseContext& c, const std::string& force, const MountTransmission& of,
                    const MountShares& found, foundation::Problems& warnings) {
  const bool moment = of.total.directions.front().rotation;
  const std::string& mount = c.system.elements()[found.at].name;
  warnings.warning(
      "requirements.isolation",
      fmt::format("{} at {:.5g} Hz: the {} on the ground is {:.3g} of it in total, but the {} of the single mounts add "
                  "up to {:.3g} times it; {} alone transmits {:.3g}",
                  foundation::quoted(force), found.angular_frequency / foundation::two_pi, moment ? "moment" : "force",
                  found.total, moment ? "moments" : "forces", found.sum, foundation::quoted(mount), found.largest),
      "a transmissibility judges the sum along the excitation, in which forces of pitch, roll and twist cancel; the "
      "ground under each mount is not isolated",
      fmt::format("limit the forces of the single mounts too, for instance limits = {{\"{}.force.{}\" = \"5 N\"}}, or "
                  "move this resonance{}",
                  mount, "xyz"[found.component], nearest_natural_frequency(c, found.angular_frequency)));
}

}  // namespace

foundation::Problems single_mount_warnings(const CaseContext& c, const project::Analyses& analyses) {
  foundation::Problems warnings;
  if (!analyses.requirements) return warnings;
  std::vector<std::pair<std::string, assembly::Band>> done;
  for (const project::Isolation& wanted : analyses.requirements->isolation)
    for (const std::string& force : project::isolated_forces(wanted, c.system)) {
      if (!model::reason_without_transmission(c.system, force).empty()) continue;  // the requirement says so
      const MountTransmission of = mount_transmission(c, force);
      for (const assembly::Band& band : project::isolated_at(wanted, c.system, force)) {
        if (std::ranges::find(done, std::pair(force, band)) != done.end()) continue;
        done.emplace_back(force, band);
        const auto found = worst_shares(c, of, band);
        if (found && !is_limited(c, analyses, *found)) warn_of_shares(c, force, of, *found, warnings);
      }
    }
  return warnings;
}

}  // namespace trivet::study
