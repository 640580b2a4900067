// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/band_reader.h"
#include "trivet/project/text/mentioned.h"

namespace trivet::project {

/// What can be asked for: motions of bodies, points and ends of elements, forces of elements and on the ground.
class ResultNames {
 public:
  explicit ResultNames(const Mentioned& mentioned);

  [[nodiscard]] const std::vector<std::string>& groups() const { return groups_; }
  [[nodiscard]] bool is_group(const std::string& name) const;

  /// What a full name (group, dot, component) measures, if it is one.
  [[nodiscard]] std::optional<Quantity> component(const std::string& name, assembly::Quantity wanted) const;

  /// A force or moment, or a group of them: displacement, velocity and acceleration are the same to it.
  [[nodiscard]] bool is_force(const std::string& name) const;

  /// All full names.
  [[nodiscard]] std::vector<std::string> components() const;

  /// What to do about a name that is none: the components that it lacks, the group it resembles, or to look again.
  [[nodiscard]] std::string remedy(const std::string& name) const;

  /// A coordinate that the `free` of its body leaves out: it does not move.
  [[nodiscard]] bool is_guided(const std::string& name) const;

 private:
  std::vector<std::string> motions_, forces_, groups_, guided_;
};

/// The names under `key`: each must name a result.
void read_of(TableReader& reader, const ResultNames& names, std::vector<std::string>& of);

/// `of`, `quantity` and `excitations`, the latter out of the known names; `kind` says what they are.
void read_wanted(TableReader& reader, const ResultNames& result_names, const std::vector<std::string>& known,
                 const std::string& kind, Wanted& wanted);

/// `min_prominence`, a share of the whole curve's height, and `peak_tolerance`, a share of the minimum beside a peak,
/// which may be more than 1.
void read_peak_shares(TableReader& reader, double& min_prominence, double& peak_tolerance);

/// A limit on what is no answer with components.
void refuse_limit(TableReader& reader, const ResultNames& names, const std::string& name);

/// `excitations` alone.
[[nodiscard]] std::vector<std::string> read_selected(TableReader& reader, const std::vector<std::string>& known,
                                                     const std::string& kind);

/// Harmonic ones alone; those of other types are refused as such.
[[nodiscard]] std::vector<std::string> read_selected_harmonic(TableReader& reader, const Mentioned& mentioned);

/// What the model has in place of harmonic excitations: "engine" is of type orders, …; empty if nothing.
[[nodiscard]] std::string other_excitations(const Mentioned& mentioned);

/// `limit_lines` of the file: each an answer of the response and a line over frequency.
void read_limit_lines(TableReader& root, const ResultNames& names, Analyses& result);

}  // namespace trivet::project
