// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

#include "trivet/exchange/universal_file.h"
#include "trivet/foundation/problems.h"
#include "trivet/project/measured_unit.h"

namespace trivet::project {

/// Units of functions of a universal file. They are stated by set 164, by the labels of the axes ("g"), and by `unit`
/// of the project; two that disagree are an error, which names both. A `unit` of the project decides between set 164
/// and a label.
class MeasuredAxes {
 public:
  /// @param given   `unit` of the project
  /// @param source  name of the file
  MeasuredAxes(const std::optional<MeasuredUnit>& given, std::string source, foundation::Problems& found)
      : given_(given), source_(std::move(source)), found_(found) {}

  /// Unit of the numbers of a function: its factor is that of the values as they were read. None if nothing states it,
  /// or after an error.
  [[nodiscard]] std::optional<MeasuredUnit> unit_of(const exchange::UniversalFunction& function);

 private:
  /// Reports each problem once, for the first function that has it.
  void error(const exchange::UniversalFunction& function, const std::string& finding, const std::string& rule,
             const std::string& remedy);

  const std::optional<MeasuredUnit>& given_;
  std::string source_;
  foundation::Problems& found_;
  std::set<std::string> reported_;
};

}  // namespace trivet::project
