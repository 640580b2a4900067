// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <optional>
#include <string>

#include "trivet/project/measured/measured_places.h"

namespace trivet::project {

/// The harmonic force by which functions per force are multiplied.
class MeasuredForce {
 public:
  MeasuredForce(const model::Description& description, const MeasuredPlaces& places, const model::Excitation& force)
      : description_(description), places_(places), force_(force) {}

  /// Reason why functions per force cannot be compared with this excitation: it is no force on a body.
  [[nodiscard]] std::optional<std::string> unsuitable() const;

  /// Amplitude along the reference of a function (its delay excluded); none if body, place or direction do not fit. A
  /// moment may be measured at any place of its body. Without a reference in the file (node 0), the measured force is
  /// positive along the axis of the body on which the excitation acts; a force along no axis is positive in its own
  /// direction.
  [[nodiscard]] std::optional<std::complex<double>> amplitude(const exchange::UniversalPoint& reference) const;

  [[nodiscard]] double delay() const { return force_.action.delay; }
  /// "force of push at (0.1, 0, 0) m along (0, 0, 10) of "frame"": place in the ground frame [m], magnitudes of the
  /// components along the axes of the body [N or N m].
  [[nodiscard]] std::string words() const;

 private:
  [[nodiscard]] std::optional<std::complex<double>> along_itself() const;
  /// True for a node at the place of a force, or at any place of the body of a moment.
  [[nodiscard]] bool acts_at(int node) const;

  const model::Description& description_;
  const MeasuredPlaces& places_;
  const model::Excitation& force_;
};

}  // namespace trivet::project
