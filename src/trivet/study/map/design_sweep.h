// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/response/steady/curve_model.h"

namespace trivet::study {

/// One number of the model and its values.
struct SweptNumber {
  std::string path;                                          ///< as in --set: "elements.mount.scale"
  std::vector<double> values;                                ///< as bare numbers of the file: SI
  std::optional<project::Quantity> quantity = std::nullopt;  ///< of the values; none if it is not known
};

/// A value of the project file: a number in SI, or a text with a unit.
using WrittenValue = std::variant<double, std::string>;

/// The number with its values in SI, texts read as the project file reads them. @throws foundation::InvalidInput for
/// texts that are no numbers in a unit of this number, all of them at once
[[nodiscard]] SweptNumber swept_number(const project::Case& variant, const std::string& path,
                                       const std::vector<WrittenValue>& values);

struct SweepRequest {
  std::vector<SweptNumber> numbers;
  std::vector<std::string> of;           ///< results as in `peaks`; empty: those of the case's peaks
  std::vector<std::string> excitations;  ///< harmonic ones that act; empty: those of the case's peaks
  assembly::Band band = {0, std::numeric_limits<double>::infinity()};  ///< [rad/s]
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

/// Largest amplitudes over all combinations of values.
struct DesignSweep {
  std::vector<std::string> results, units;
  /// Combinations × results, the last number fastest; infinite at an undamped resonance, NaN if it has no valid model
  /// or cannot be computed.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> highest;
  std::size_t in_kernels = 0, one_by_one = 0;  ///< combinations
  std::size_t without_model = 0;  ///< combinations with NaN: without a valid model, or that cannot be computed
  std::string no_kernels;         ///< why all were computed one by one; else empty
  std::string first_failure;      ///< reason of the first combination with NaN
};

/// Combinations that a sweep may have, times its results.
inline constexpr std::size_t most_swept_values = 200'000'000;

/// The largest amplitude of every result in the band, under all harmonic excitations. The matrices of all designs are
/// interpolated (design::SumFamily) where that is exact to round-off, between values with a valid model, and their
/// peaks found by kernels over designs; designs beyond, and those that these do not prove, are computed one by one.
/// @throws foundation::InvalidInput for an empty or too large sweep, or a number or result that does not exist;
/// NotComputable without excitation
[[nodiscard]] DesignSweep design_sweep(const project::Case& variant, const SweepRequest& request,
                                       const foundation::Progress& progress = {});

}  // namespace trivet::study
