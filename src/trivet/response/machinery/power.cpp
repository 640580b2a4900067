// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/power.h"

#include <cassert>
#include <variant>

#include "trivet/foundation/index.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/response/steady/steady_motion.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;

/// ½ Re(F · conj v) for the velocity v = iω d.
template <typename Force, typename Displacement>
double mean_power(const Force& force, const Displacement& displacement, double omega) {
  return 0.5 * (Complex(0, omega) * displacement).dot(force).real();
}

/// System damping: the part of B that does not come from elements and foundations.
struct SystemDamping {
  Eigen::MatrixXd free, ground;  ///< empty without system damping
};

SystemDamping system_damping(const model::System& system, const assembly::Assembled& assembled) {
  if (std::holds_alternative<std::monostate>(system.description().damping)) return {};
  const Eigen::Index n = assembled.layout.before_last();
  SystemDamping rest{
      (assembled.frequency_dependent() ? assembled.constant.B : assembled.matrices.B).topLeftCorner(n, n),
      assembled.ground.B.topRows(n)};
  for (const assembly::ElementMap& map : assembled.elements) {
    if (map.frequency_dependent()) continue;
    const Eigen::MatrixXd force = map.ends.transpose() * map.matrices.damping;
    rest.free(map.rows, map.rows) -= force * map.ends;
    rest.ground(map.rows, map.ground_rows) -= force * map.ground_ends;
  }
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f) {
    const Eigen::MatrixXd& damping = system.description().foundations[f].damping;
    const Eigen::Index first = assembled.layout.foundation_row(f);
    rest.free.block(first, first, damping.rows(), damping.cols()) -= damping;
  }
  return rest;
}

/// Power absorbed by the impedances of flexible foundations.
double foundation_power(const model::System& system, const assembly::Assembled& assembled, const SteadyMotion& motion) {
  double sum = 0;
  const double omega = motion.angular_frequency;
  for (std::size_t f = 0; f < system.description().foundations.size(); ++f) {
    const model::Foundation& foundation = system.description().foundations[f];
    const Eigen::VectorXcd p = motion.free.segment(assembled.layout.foundation_row(f), foundation.mass.rows());
    const Eigen::VectorXcd force =
        (foundation.stiffness - omega * omega * foundation.mass) * p + Complex(0, omega) * (foundation.damping * p);
    sum += mean_power(force, p, omega);
  }
  return sum;
}

}  // namespace

PowerFlow power_flow(const model::System& system, const assembly::Assembled& assembled,
                     const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                     const foundation::Progress& progress) {
  const std::vector<std::size_t> standing = mounts(system);
  const SystemDamping of_system = system_damping(system, assembled);
  const auto count = to_index(angular_frequency.size());
  const auto rows = [](const auto& list) { return to_index(list.size()); };
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(count);
  PowerFlow flow{angular_frequency,
                 {},
                 Eigen::MatrixXd::Zero(rows(standing), count),
                 none,
                 none,
                 none,
                 {},
                 Eigen::MatrixXd::Zero(rows(system.elements()), count),
                 none,
                 none};
  for (const std::size_t e : standing) flow.mounts.push_back(system.elements()[e].name);
  for (const model::Element& element : system.elements()) flow.elements.push_back(element.name);
  const std::vector<SteadyMotion> motions = steady_motions(assembled, loading, angular_frequency);
  assert(to_index(motions.size()) == count);
  for (Eigen::Index i = 0; i < count; ++i) {
    foundation::report_progress(progress, "power", static_cast<double>(i) / static_cast<double>(count));
    const SteadyMotion& motion = motions[i];
    const double omega = motion.angular_frequency;
    const Eigen::VectorXcd force = loading.force.at(omega).head(motion.free.size());
    flow.by_forces(i) = mean_power(force, motion.free, omega);
    for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
      const assembly::ElementMap& map = assembled.elements[e];
      const Eigen::VectorXcd d = element_motion(map, motion), wrench = element_wrenches(map, d, omega);
      flow.dissipated(to_index(e), i) = mean_power(wrench, d, omega);
      flow.by_ground(i) += mean_power(wrench, map.moved_by_ground(motion.ground).head(wrench.size()), omega);
      for (std::size_t m = 0; m < standing.size(); ++m)
        if (standing[m] == e) flow.into_ground(to_index(m), i) = -mean_power(wrench.head<6>(), d.head<6>(), omega);
    }
    flow.dissipated_by_foundations(i) = foundation_power(system, assembled, motion);
    if (of_system.free.size() > 0) {
      const Eigen::VectorXcd held =
          Complex(0, omega) * (of_system.free * motion.free + of_system.ground * motion.ground);
      flow.dissipated_by_system(i) = mean_power(held, motion.free, omega);
    }
  }
  flow.into_ground_in_total = flow.into_ground.colwise().sum().transpose();
  return flow;
}

}  // namespace trivet::response
