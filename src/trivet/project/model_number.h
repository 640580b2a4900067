// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/document.h"

/// The numbers of a model that --set, cases, maps and `explain` reach by one kind of path (docs/project-file.md,
/// "Paths").
namespace trivet::project {

struct Case;

/// One number of the model, as written in the file; or several that one parameter moves, each by its own factor.
class ModelNumber {
 public:
  /// @param path  such as elements."front left".at.y  @param unit  of its values; empty: that of a bare number (SI)
  ModelNumber(const std::string& path, const std::string& unit) : ModelNumber({{path, 1.0}}, unit) {}
  explicit ModelNumber(const DesignAxis& axis) : ModelNumber(axis.places, axis.unit) {}

  /// Value in a case, or the default of a key that is not written; none if the file has no number there, or if the
  /// places of a parameter have different values.
  [[nodiscard]] std::optional<double> read(const Case& variant) const;

  /// The value at each place, divided by its factor.
  [[nodiscard]] std::vector<std::optional<double>> values(const Case& variant) const;

  /// Change that sets the number to this value, at all places.
  [[nodiscard]] Node change(double value) const;

 private:
  ModelNumber(const std::vector<ParameterPlace>& places, std::string unit);

  struct Place {
    std::vector<std::string> keys;
    double factor;
  };
  [[nodiscard]] std::optional<double> read(const Place& place, const Case& variant) const;

  std::string unit_;
  std::vector<Place> places_;
};

/// Values for some numbers of a model.
using Design = std::vector<std::pair<ModelNumber, double>>;

}  // namespace trivet::project
