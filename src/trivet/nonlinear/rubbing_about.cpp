// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/rubbing_about.h"

#include <cmath>

namespace trivet::nonlinear {

RubbingAbout::RubbingAbout(elements::RubbingFriction law, const std::vector<elements::ElasticForce>& contact,
                           double at_rest)
    : law_(law), at_rest_(at_rest), pressed_(false) {
  for (const elements::ElasticForce& one : contact) contact_.add(one);
  pressed_ = limit(0, 0).value > 0;
}

RubbingAbout::Limit RubbingAbout::limit(double deviation, double rate) const {
  const LawAbout::Force pressing = contact_.at(at_rest_ + deviation, rate);
  const double share = pressing.force < 0 ? -law_.coefficient : law_.coefficient;
  return {share * pressing.force, share * pressing.by_deviation, share * pressing.by_rate};
}

}  // namespace trivet::nonlinear
