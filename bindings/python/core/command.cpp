// SPDX-License-Identifier: BSD-3-Clause
#include "core/command.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

#include "cli/main_program.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;

/// @param words  the name of the program, then its arguments
int main_program(std::vector<std::string> words) {
  const nb::gil_scoped_release released;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return cli::main_program(static_cast<int>(words.size()), arguments.data());
}

}  // namespace

void bind_command(nb::module_& module) {
  module.def("main_program", main_program, nb::arg("words"),
             "The program `trivet` in this process, whose signals it takes over. Returns the exit code.");
}

}  // namespace trivet::python
