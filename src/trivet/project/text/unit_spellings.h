// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Units as people write them, for `units` only.
namespace trivet::project {

/// The unit in the spelling of the database: superscripts as digits, "short ton" as one word, and 1/min, min⁻¹ and
/// U/min as rpm if a rotational speed is expected. @param si  the expected SI unit
[[nodiscard]] std::string database_spelling(std::string_view unit, std::string_view si);

/// Why a unit with a word of several meanings is rejected, with the words to choose from; empty for any other.
[[nodiscard]] std::string reason_against_ambiguous(std::string_view unit, std::string_view si);

/// The unit with each word replaced: "lb/in" with lb → lbf is "lbf/in". Equal to `unit` if the word is not there.
[[nodiscard]] std::string with_word_replaced(std::string_view unit, std::string_view word, std::string_view by);

/// Words of mass that catalogues write for a force, with the unit of force that is meant.
struct MassForForce {
  const char *mass, *force;
};
[[nodiscard]] const std::vector<MassForForce>& masses_for_forces();

}  // namespace trivet::project
