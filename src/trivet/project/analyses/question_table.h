// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The independent questions of [analyses], in the order of their answers: each is a command, a table of [analyses] and
/// a part of the results. The files and objects of a question have its name:
///
///   project/analyses/NAME_question.cpp   NAME_question   how its keys are read, and what it needs of the model
///   study/analyses/NAME_answer.cpp                NAME_answer     how it is answered
///   results/NAME_results.cpp             NAME_results    its JSON, CSV and text
///
/// A name without one of these does not link. Questions about the same curves of harmonic response (response, peaks,
/// limits, limit lines, map), and those that every model answers (modes, roots, static), are fields of `Analyses`.
// clang-format off
#define TRIVET_QUESTIONS(row) \
  row(random) \
  row(transient) \
  row(orders) \
  row(transmissibility) \
  row(power) \
  row(shapes) \
  row(steady) \
  row(backbone) \
  row(shock_spectrum) \
  row(earthquake)
// clang-format on

namespace trivet::project {

/// A row of a list of such objects, with its name set.
template <typename Row>
[[nodiscard]] Row named(const char* name, Row row) {
  row.name = name;
  return row;
}

}  // namespace trivet::project
