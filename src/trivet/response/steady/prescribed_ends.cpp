// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/deep_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

using Extended = long double;
using ExtendedComplex = std::complex<Extended>;
}  // namespace

PrescribedEnds::PrescribedEnds(const model::System& system, const std::vector<std::string>& excitations)
    : description_(system.description()) {
  for (const model::Excitation& excitation : description_.excitations) {
    if (model::is_selected(excitation, excitations) && !excitation.action.body &&
        std::holds_alternative<model::Harmonic>(excitation.course))
      moving_.push_back(&excitation);
  }
  impedance_of_.assign(description_.foundations.size(), -1);
  for (std::size_t e = 0; e < description_.elements.size(); ++e) {
    const model::Element& element = description_.elements[e];
    if (model::joins_foundation_to_ground(element))
      impedance_of_[element.k.foundation->foundation] = static_cast<int>(e);
  }
}

/// Motion of the ground, six components in ground axes; `element`: the one with its ground end at this place.
PrescribedEnds::Motion PrescribedEnds::ground_at(const Eigen::Vector3d& place, std::size_t element,
                                                 Extended omega) const {
  Motion sum = Motion::Zero();
  const ExtendedComplex s(0, omega);
  for (const model::Excitation* excitation : moving_) {
    const model::Action& action = excitation->action;
    const bool as_one = action.elements.empty() && !action.wave;
    if (!action.elements.empty() && std::ranges::find(action.elements, element) == action.elements.end()) continue;
    Motion motion = action.amplitude.cast<ExtendedComplex>();
    Extended later = action.delay;
    if (as_one) {  // u + θ × (r − at)
      using Vector3 = Eigen::Matrix<Extended, 3, 1>;
      const Vector3 arm = (place - action.at).cast<Extended>(), real = motion.tail<3>().real(),
                    imaginary = motion.tail<3>().imag();
      // Real and imaginary part separately: Eigen's product of complex vectors is the conjugate one.
      motion.head<3>() += real.cross(arm).cast<ExtendedComplex>() +
          ExtendedComplex(0, 1) * imaginary.cross(arm).cast<ExtendedComplex>();
    } else if (action.wave) {
      later += action.wave->direction.dot(place) / action.wave->speed;
    }
    const int power = std::get<model::Harmonic>(excitation->course).power_of_frequency;
    ExtendedComplex factor = std::exp(-s * later) * std::pow(omega, Extended(power));
    for (int i = 0; i < action.derivative; ++i) factor /= s;
    sum += factor * motion;
  }
  return sum;
}

bool PrescribedEnds::can_move(std::size_t element) const {
  const model::Element& one = description_.elements[element];
  return !moving_.empty() && (!one.n.body || !one.k.body);
}

PrescribedEnds::Vector PrescribedEnds::at(std::size_t index, double angular_frequency) const {
  Vector ends = Vector::Zero(12);
  const model::Element& element = description_.elements[index];
  int first = 0;
  for (const model::End* end : {&element.n, &element.k}) {
    Motion motion = Motion::Zero();
    if (end->on_ground()) motion = ground_at(end->at, index, angular_frequency);
    if (end->foundation && impedance_of_[end->foundation->foundation] >= 0) {
      const auto joint = to_size(impedance_of_[end->foundation->foundation]);
      motion = end->foundation->fixed_directions.cast<ExtendedComplex>() *
          ground_at(description_.elements[joint].n.at, joint, angular_frequency);
    }
    const Eigen::Matrix<ExtendedComplex, 3, 3> local = end->axes.transpose().cast<ExtendedComplex>();
    ends.segment<3>(first) = local * motion.head<3>();
    ends.segment<3>(first + 3) = local * motion.tail<3>();
    first += 6;
  }
  return ends;
}

}  // namespace trivet::response
