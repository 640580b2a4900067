// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/problems.h"
#include "trivet/solids/closed_surface.h"

namespace trivet::solids {

/// A script for the program gmsh (Debian package gmsh; GPL, therefore only run as a child process) on one STEP file.
/// The script finds the file as part.step, in millimetres regardless of the unit in the file, and writes its results to
/// the same folder.
struct GmshJob {
  std::filesystem::path step_file;
  std::filesystem::path folder;  ///< an empty folder for the job; the caller removes it
  std::string script;            ///< runs after the solids of the file have been read
  std::string task;              ///< name of the task in progress reports
  double time_limit = 3600;      ///< [s] > 0; the environment variable TRIVET_GMSH_SECONDS overrides it
};

/// Runs the job on one thread, without the user's gmsh settings, so that equal files give equal results. Errors have
/// the subject "file": gmsh or the file is missing, not a STEP file, a failed script with the messages of gmsh.
[[nodiscard]] foundation::Expected<void> run_gmsh(const GmshJob& job, const foundation::Progress& progress = {});

/// Volume, centre and second moment [m] of every solid in a STEP file, in the order and the frame of the file,
/// integrated over its exact surfaces (not over triangles) by the OpenCASCADE kernel of gmsh. The length unit of
/// the file is applied. Problems have the subject "file": no gmsh, not a STEP file, no solid in it, a solid without
/// volume.
[[nodiscard]] foundation::Expected<std::vector<VolumeIntegrals>> step_volumes(
    const std::filesystem::path& file, const foundation::Progress& progress = {});

}  // namespace trivet::solids
