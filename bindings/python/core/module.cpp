// SPDX-License-Identifier: BSD-3-Clause
#include "core/answers.h"
#include "core/command.h"
#include "core/errors.h"
#include "core/project.h"
#include "core/result.h"
#include "core/task.h"

NB_MODULE(_core, module) {
  module.doc() = "The compiled part of trivet. Use the package trivet.";
  trivet::python::bind_errors(module);
  trivet::python::bind_result(module);
  trivet::python::bind_project(module);
  trivet::python::bind_answers(module);
  trivet::python::bind_command(module);
  module.def("wait_for_interrupted_work", &trivet::python::wait_for_interrupted_work, nanobind::arg("seconds"));
}
