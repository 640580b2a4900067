// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/document.h"

/// `[tables.elements]`, `[tables.bodies]`, `[tables.points]`: many parts at once, one per row (docs/project-file.md,
/// "Tables of bodies and elements").
namespace trivet::project {

/// Inserts the rows of these tables into the elements, bodies and points of the document, as if each had a separate
/// table, and removes the key `tables`. Problems of a row name its line.
void put_tables_in_place(Node& document, foundation::Problems& problems);

/// Merges the same problem of a column in several rows into one, at the first row.
void gather_columns(foundation::Problems& problems);

}  // namespace trivet::project
