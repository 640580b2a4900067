// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/known_model.h"
#include "trivet/project/text/symbol_table.h"
#include "trivet/project/text/table_reader.h"
#include "trivet/solids/rigid_solid.h"

namespace trivet::project {

/// Reads the table `bodies` into the description and reports its problems.
/// @param known  a model read earlier; unchanged bodies are copied from it
void read_bodies(TableReader& root, model::Description& description, SymbolTable& symbols,
                 const KnownModel* known = nullptr);

/// Reads `free` of a body or node, and lists its constrained coordinates.
void read_free(TableReader& reader, model::Body& body, SymbolTable& symbols);

/// Reads the table `nodes` into the description, after its bodies, and reports its problems.
void read_nodes(TableReader& root, model::Description& description, SymbolTable& symbols);

/// Reads the table `foundations` and puts the elements of `in_file.foundation_references` on them: each element gets
/// its own impedance between its end N and the ground, or all of them share the modes of one structure.
void read_foundations(TableReader& root, model::Description& description, SymbolTable& symbols);

/// Reads [relative], [sections] and [clearances], after all bodies, nodes and elements.
void read_observations(TableReader& root, model::Description& description, SymbolTable& symbols);

/// Reads `solids = [{box = [x, y, z], density = 7850, at = […]}, {file = "housing.step", density = …}, …]` into mass,
/// centre and inertia of the body. Returns false after reporting errors.
[[nodiscard]] bool read_solids(TableReader& body, solids::KnownMass known, model::Body& result);

/// Reads the choices of mounts of [parameters], with the catalogues that they name.
/// @param written  the document before element types are merged in
[[nodiscard]] std::vector<MountChoice> read_mount_choices(TableReader& root, const Node& written);

}  // namespace trivet::project
