// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/study/analyses.h"
#include "trivet/study/table_reader.h"

/// One function per part of a project file; each adds to the description and reports its problems.
namespace trivet::study {

void read_bodies(TableReader& root, model::Description& description);
void read_elements(TableReader& root, model::Description& description);
void read_system_damping(TableReader& root, model::Description& description);
void read_excitations(TableReader& root, model::Description& description);
[[nodiscard]] Analyses read_analyses(TableReader& root, const model::Description& description);

/// The body of that name; an unknown name is a problem at `key`.
[[nodiscard]] std::optional<std::size_t> body_named(TableReader& reader, const std::string& key, const model::Description& description);

}  // namespace trivet::study
