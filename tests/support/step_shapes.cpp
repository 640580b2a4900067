// SPDX-License-Identifier: BSD-3-Clause
#include "support/step_shapes.h"

#include <fstream>
#include <stdexcept>

#include "trivet/foundation/child_process.h"
#include "trivet/foundation/temporary_folder.h"

namespace trivet::test {

void write_step(const std::filesystem::path& file, const std::string& commands) {
  const auto program = foundation::program_on_path("gmsh");
  if (!program) throw std::runtime_error("gmsh is missing: scripts/packages tests");
  const foundation::TemporaryFolder folder;
  std::ofstream(folder.path() / "shape.geo") << "SetFactory(\"OpenCASCADE\");\n"
                                             << commands << "\nSave \"shape.step\";\n";
  const foundation::CommandOutcome outcome =
      foundation::run({.program = *program, .arguments = {"shape.geo", "-", "-v", "2"}, .folder = folder.path()});
  if (!outcome.succeeded()) throw std::runtime_error(outcome.output);
  std::filesystem::copy_file(folder.path() / "shape.step", file, std::filesystem::copy_options::overwrite_existing);
}

}  // namespace trivet::test
