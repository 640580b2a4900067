// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/model/system.h"

namespace trivet::project {

/// Kind of excitations that act in a result.
enum class Drive { none, harmonic, random, time, orders, harmonic_or_orders };

/// Path of the table of an analysis in the file: "analyses.orders", "operation".
[[nodiscard]] std::string table_path(const std::string& analysis);

/// Kind of excitations of an analysis; harmonic for response and peaks.
[[nodiscard]] Drive drive_of(const std::string& analysis);

[[nodiscard]] bool drives(const model::Excitation& excitation, Drive drive);

/// True if an excitation of this kind exists in the model.
[[nodiscard]] bool is_driven(const model::System& system, Drive drive);

/// Message texts if the model has no excitation of a kind.
struct MissingExcitation {
  const char* finding;
  const char* remedy;
};
[[nodiscard]] MissingExcitation missing_excitation(Drive drive);

}  // namespace trivet::project
