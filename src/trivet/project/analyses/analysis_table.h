// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The independent analyses of [analyses], in the order of their results: each is a command, a table of [analyses] (or,
/// of `operation`, of the file) and a part of the results. The files and objects of an analysis have its name:
///
///   project/analyses/NAME_analysis.cpp   NAME_analysis   how its keys are read, and what it needs of the model
///   study/analyses/NAME_run.cpp          NAME_run        how it is computed
///   results/analyses/NAME_document.cpp   NAME_results    its parts: tables, curves and sentences
///
/// A name without one of these does not link. Its request is the field NAME of `Analyses`, its result the field NAME of
/// `CaseResults`. Analyses of the same curves of harmonic response (response, peaks, limits, limit lines, map), and
/// those that every model has (modes, roots, static), have fields too, and functions of their own.
// clang-format off
#define TRIVET_ANALYSES(row) \
  row(operation) \
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
