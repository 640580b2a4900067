// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/document.h"

/// The numbers of a model that --set, cases, maps and `explain` reach by one kind of path (docs/project-file.md,
/// "Paths").
namespace trivet::project {

struct Case;

/// One of them, as the file writes it.
class ModelNumber {
 public:
  /// @param path  elements."front left".at.y  @param unit  of its values; empty: SI, or as the file takes a bare number
  ModelNumber(const std::string& path, std::string unit);
  explicit ModelNumber(const MapAxis& axis) : ModelNumber(axis.parameter, axis.unit) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  /// "mass" of "bodies.machine.mass".
  [[nodiscard]] const std::string& key() const { return keys_.back(); }

  /// Its value in a case; what a file leaves out has its default. None where the file has no number there.
  [[nodiscard]] std::optional<double> read(const Case& variant) const;

  /// The change that gives it this value.
  [[nodiscard]] Node change(double value) const;

 private:
  std::string path_, unit_;
  std::vector<std::string> keys_;
};

/// Values for some numbers of a model.
using Design = std::vector<std::pair<ModelNumber, double>>;

/// The model of a case with these values, all problems at once; it answers no questions of its own. Only what they
/// touch is read anew, on any number of threads at once.
[[nodiscard]] foundation::Expected<model::System> changed_system(const Case& variant, const Design& design);

}  // namespace trivet::project
