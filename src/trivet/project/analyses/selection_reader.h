// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/symbol_table.h"

namespace trivet::project {

/// Names of results: motions of bodies, points and ends of elements, forces of elements and on the ground.
class ResultNames {
 public:
  explicit ResultNames(const SymbolTable& symbols);

  [[nodiscard]] const std::vector<std::string>& groups() const { return groups_; }
  [[nodiscard]] bool is_group(const std::string& name) const;

  /// Quantity of a full name (group, dot, component); none if it is not one.
  [[nodiscard]] std::optional<Quantity> component(const std::string& name, assembly::MotionQuantity quantity) const;

  /// True for a force or moment, or a group of them: `quantity` has no effect on it.
  [[nodiscard]] bool is_force(const std::string& name) const;

  /// All full names.
  [[nodiscard]] std::vector<std::string> components() const;

  /// Reports a name that is no result: names its components or the most similar group.
  /// @param known  what may be named here, in words
  void refuse(TableReader& reader, const std::string& key, const std::string& name, const std::string& known) const;

  /// True for a coordinate that is not in `free` of its body: it does not move.
  [[nodiscard]] bool is_guided(const std::string& name) const;

 private:
  std::vector<std::string> motions_, forces_, relatives_, clearances_, groups_, guided_;
};

/// The names under `of`: each must name a result.
void read_of(TableReader& reader, const ResultNames& names, std::vector<std::string>& of);

/// The same under another key; none without it. @param without  what removing the key means, for an empty list
[[nodiscard]] std::optional<std::vector<std::string>> read_result_names(TableReader& reader, const ResultNames& names,
                                                                        const std::string& key,
                                                                        const std::string& without);

/// `of` and `quantity`.
void read_results(TableReader& reader, const ResultNames& result_names, ChannelSelection& selection);

/// `of`, `quantity` and `excitations`, the latter out of the known names; `kind` is their type, for messages.
void read_selection(TableReader& reader, const ResultNames& result_names, const std::vector<std::string>& known,
                    const std::string& kind, ChannelSelection& selection);

/// Reads `min_prominence`, a share of the whole curve's height, and `peak_tolerance`, a share of the minimum next to a
/// peak, which may exceed 1.
void read_peak_shares(TableReader& reader, double& min_prominence, double& peak_tolerance);

/// Reports a limit on something that is not one component of a result.
void refuse_limit(TableReader& reader, const ResultNames& names, const std::string& name);

/// Reads `excitations` only.
[[nodiscard]] std::vector<std::string> read_selected(TableReader& reader, const std::vector<std::string>& known,
                                                     const std::string& kind);

/// Reads `excitations`, harmonic ones only; those of other types are rejected with their type.
[[nodiscard]] std::vector<std::string> read_selected_harmonic(TableReader& reader, const SymbolTable& symbols);

/// Lists the excitations that are not harmonic, for messages: "engine" is of type orders, …; empty if there are none.
[[nodiscard]] std::string other_excitations(const SymbolTable& symbols);

/// Reads `limit_lines` of the file: each is a channel of the response and a line over frequency.
void read_limit_lines(TableReader& root, const ResultNames& names, const SymbolTable& symbols, Analyses& result);

}  // namespace trivet::project
