// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/modal/modes.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/response/steady/peaks.h"

/// Measured curves and shapes compared with computed ones. Nothing is fitted. Formulas: docs/measurements.md.
namespace trivet::study {

class CaseContext;

/// A peak of a measured curve, and the computed resonance peak nearest to its frequency.
struct PeakDifference {
  double angular_frequency = 0;  ///< measured, between lines [rad/s]
  double amplitude = 0;
  double resolution = 0;  ///< half the distance of the two lines around the highest one [rad/s]
  std::optional<response::Peak> computed;

  /// Measured over computed frequency, minus 1; NaN without a computed peak.
  [[nodiscard]] double frequency_difference() const;
  /// 20 lg of measured over computed height [dB]; NaN without a computed peak of finite height.
  [[nodiscard]] double height_db() const;
};

/// A measured curve and the computed one at its frequencies inside the band.
struct ChannelComparison {
  std::string result;
  std::string source;  ///< in the file
  std::string unit;
  std::vector<double> angular_frequency;  ///< [rad/s]
  Eigen::VectorXcd measured, computed;
  Eigen::VectorXd coherence;  ///< empty if it is not measured
  bool vanishes = false;      ///< the computed curve is round-off: nothing below is computed
  double rms_db = 0;          ///< of 20 lg |measured / computed|; NaN if no line has both
  double largest_db = 0;      ///< the value of largest magnitude, with its sign
  double largest_at = 0;      ///< [rad/s]
  double assurance = 0;       ///< FRAC, 0 … 1
  std::optional<double> mean_coherence;
  std::vector<PeakDifference> peaks;
};

/// A measured mode and the computed one of the most similar shape.
struct ShapeComparison {
  int measured = 0;  ///< its number in the file
  double measured_frequency = 0, damping_ratio = 0;
  int mode = 0;                             ///< computed, 0: none
  std::optional<double> angular_frequency;  ///< of the computed mode [rad/s]
  double assurance = 0;                     ///< MAC, 0 … 1

  /// Measured over computed frequency, minus 1; NaN if that is 0.
  [[nodiscard]] double frequency_difference() const;
};

/// A table of [measurements] compared with the results of a case.
struct MeasurementComparison {
  std::string name, file;
  std::string excitation;   ///< the only one that acts; empty: those of the response
  bool of_response = true;  ///< the excitations are those of the response
  assembly::Band band;      ///< of the response
  std::vector<ChannelComparison> channels;
  std::size_t components = 0;  ///< of the shapes
  std::vector<ShapeComparison> shapes;
  Eigen::MatrixXd assurance;  ///< MAC, measured modes × computed modes
};

/// FRAC |Σ m c*|² / (Σ|m|² Σ|c|²); NaN if a sum is zero. Of shapes it is the MAC.
[[nodiscard]] double assurance(const Eigen::VectorXcd& measured, const Eigen::VectorXcd& computed);

/// Peaks of a measured curve: local maxima that rise by more than a fifth above both minima around them and are higher
/// than a hundredth of the curve, with a coherence of at least 0.8 if it is measured. Their tops are those of a
/// parabola through 1/|m|² at three lines, which is the curve of a single resonance.
[[nodiscard]] std::vector<PeakDifference> measured_peaks(const std::vector<double>& angular_frequency,
                                                         const Eigen::VectorXcd& measured,
                                                         const Eigen::VectorXd& coherence = {});

/// @throws foundation::NotComputable with the reason if there is no result
[[nodiscard]] std::vector<MeasurementComparison> measurement_comparisons(const CaseContext& context,
                                                                         const project::Analyses& analyses,
                                                                         const assembly::Band& band);

}  // namespace trivet::study
