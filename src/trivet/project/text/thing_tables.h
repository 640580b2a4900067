// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/text/document.h"

/// `[tables.elements]`, `[tables.bodies]`, `[tables.points]`: many things at once, one per row (docs/project-file.md,
/// "Tables of things").
namespace trivet::project {

/// Puts the rows of the tables of a document among its elements, bodies and points, as if each had a table of its own;
/// the key `tables` goes. What is wrong with a row is a problem that names its line.
void put_tables_in_place(Node& document, foundation::Problems& problems);

/// A column that several rows cannot have is one problem, at the first of them.
void gather_columns(foundation::Problems& problems);

}  // namespace trivet::project
