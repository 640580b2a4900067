// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/foundation/problems.h"
#include "trivet/project/measured/measured_unit.h"

namespace trivet::project {

/// Quantity of the values by the type of the numerator and its direction; none if the type is not one of a motion or a
/// load.
[[nodiscard]] std::optional<Quantity> quantity_of_numerator(const exchange::UniversalFunction& function);

/// What is known about the unit of the numbers of a function.
struct FunctionUnit {
  std::optional<MeasuredUnit> unit;          ///< its factor is that of the values as they were read; none: not known
  std::optional<foundation::Problem> error;  ///< two statements that disagree, or a label that is not known
};

/// Units of functions of a universal file. They are stated by set 164, by the labels of the axes ("g"), and by `unit`
/// of the project; two that disagree are an error, which names both. A `unit` of the project decides between set 164
/// and a label. It is for the functions that it fits: those of its quantity, per force or per moment as it is. A unit
/// of translations leaves the rotations to what the file states, and the reverse; one of a velocity contradicts an
/// acceleration.
class MeasuredAxes {
 public:
  /// @param given   `unit` of the project
  /// @param source  name of the file
  MeasuredAxes(const GivenUnits& given, std::string source) : given_(given), source_(std::move(source)) {}

  [[nodiscard]] FunctionUnit unit_of(const exchange::UniversalFunction& function);

  /// Errors of units of the project that neither fit nor contradict any of the functions.
  [[nodiscard]] foundation::Problems judge_idle_units() const;

 private:
  const MeasuredUnit* fitting(const exchange::UniversalFunction& function);

  const GivenUnits& given_;
  std::string source_;
  std::set<const MeasuredUnit*> met_;  ///< units of the project that fit or contradict a function
};

/// Warns that the units of the project are not those of functions, of which the file states none either.
/// @param names  of these functions, not empty
[[nodiscard]] foundation::Problem assumed_units(const GivenUnits& given, const std::vector<std::string>& names,
                                                const std::string& source);

}  // namespace trivet::project
