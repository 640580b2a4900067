// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "core/commands.h"

namespace trivet::python {

/// A checked project with the text that it was read from.
struct OpenProject {
  ProjectPointer project;
  std::string text;                   ///< of the project file
  std::string source;                 ///< its name
  std::vector<std::string> settings;  ///< "elements.mount.scale = 1.5"
  std::string content;                ///< a hash, equal for equal projects
};

void bind_project(nanobind::module_& module);
/// Commands, as methods of the project.
void bind_commands(nanobind::class_<OpenProject>& of);
/// Matrices, state space, sweep.
void bind_studies(nanobind::module_& module, nanobind::class_<OpenProject>& of);

}  // namespace trivet::python
