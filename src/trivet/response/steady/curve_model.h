// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/numerics/linalg/rational_fit.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::response {

/// Rational functions for all curves over a part of the band, one row of values per delay and curve.
struct ModelPiece {
  assembly::Band band;
  numerics::RationalFit fit;
};

/// All curves of a loading over a band, evaluated anywhere in it from few solves. Parts of different delay are
/// separate: y_c(ω) = Σ_d e^{−iωd} r_{d,c}(ω).
struct CurveModel {
  assembly::Band band;
  Eigen::Index curves = 0;
  std::vector<double> delays;      ///< [s], at least one
  std::vector<ModelPiece> pieces;  ///< ascending, adjacent; missing where no solve succeeded
  SolutionCheck check;             ///< of the solves; `undefined_at`: frequencies without a solution
  int solves = 0;                  ///< frequencies at which the dynamic stiffness was solved
  int tests = 0;                   ///< solves and extrema that were compared with the fits and not used in them
  double worst_error =
      0;  ///< in these tests: |model − truth| / |truth|, or near a zero of the curve / a thousandth of its neighbours
  double worst_error_at = 0;  ///< [rad/s]

  /// Values, curves × points; NaN outside the band and where undefined.
  [[nodiscard]] Eigen::MatrixXcd at(const std::vector<double>& angular_frequency) const;
};

struct CurveModelOptions {
  double tolerance = 1e-4;  ///< of `worst_error`: a tenth of the allowed error of a plot
  int most_solves = 3000;   ///< limit; `worst_error` then states the accuracy of the model
};

/// Model of all curves over a band. With constant matrices it has all poles and interpolates solves. Otherwise it
/// solves around the poles and over the band and fits. It is compared with new solves where it is least certain and
/// with the extrema of `peaks`, and a fit is repeated where they disagree. A band of curves that no rational function
/// of few poles fits (corners of tables, very many resonances) is halved, and each half has its own model.
/// @param poles  of the response at iω = λ: all of them with constant matrices, otherwise as far as they are known
/// @param peaks  of the same curves; may be empty
[[nodiscard]] CurveModel curve_model(const assembly::Assembled& assembled,
                                     const std::vector<assembly::Channel>& channels, const assembly::Loading& loading,
                                     const Eigen::VectorXcd& poles, const Peaks& peaks, const assembly::Band& band,
                                     const CurveModelOptions& options = {}, const foundation::Progress& progress = {});

/// All finite extrema of each curve inside a band, ascending, with the refined frequencies and heights of the peaks.
[[nodiscard]] std::vector<std::vector<Extremum>> extrema(const Peaks& peaks, const assembly::Band& band);

/// The curves of a model on a grid, with the exact amplitudes at the maxima.
[[nodiscard]] FrequencyResponse interpolated(const CurveModel& model, const std::vector<assembly::Channel>& channels,
                                             const Peaks& peaks, const std::vector<double>& angular_frequency);

}  // namespace trivet::response
