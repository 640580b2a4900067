// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/gmsh_program.h"

#include <fmt/format.h>

#include <fstream>

#include "trivet/foundation/child_process.h"

namespace trivet::solids {
namespace {

using foundation::Problems;

constexpr std::size_t step_header_bytes = 4096;  // blanks and comments may stand before the first word of a STEP file
constexpr std::size_t words_told = 300;

tl::unexpected<Problems> refused(const std::string& finding, const std::string& rule, const std::string& remedy) {
  Problems problems;
  problems.error("file", finding, rule, remedy);
  return tl::unexpected(problems);
}

foundation::Expected<void> check_step(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code not_a_file;
  const bool readable = stream && std::filesystem::is_regular_file(file, not_a_file);
  if (!readable) return refused(fmt::format("{}: cannot be read", file.string()), "a STEP file is wanted", "check its name and its rights");
  std::string begin(step_header_bytes, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(stream.gcount()));
  if (begin.find("ISO-10303-21") == std::string::npos)
    return refused(fmt::format("{}: is not a STEP file", file.string()), "a STEP file begins with ISO-10303-21", "export the part as STEP (AP203, AP214, AP242)");
  return {};
}

/// gmsh's complaints without terminal colours and frames of asterisks, on one line.
std::string complaints(const std::string& output) {
  std::string text;
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (output[i] == '\033') i = std::min(output.find('m', i), output.size());
    else if (output[i] == '\n') text += ' ';
    else if (output[i] != '*' && !(output[i] == ' ' && text.ends_with(' '))) text += output[i];
  }
  return text.size() > words_told ? "…" + text.substr(text.size() - words_told) : text;
}

}  // namespace

foundation::Expected<void> run_gmsh(const GmshJob& job, const foundation::Progress& progress) {
  if (const auto step = check_step(job.step_file); !step) return step;
  const auto program = foundation::program_on_path("gmsh");
  if (!program)
    return refused(fmt::format("{}: the program gmsh is not installed", job.step_file.string()), "STEP files are read by the program gmsh",
                   "install it (Debian package gmsh), or describe the solid by primitives or STL");

  // The user's path never enters the script: a link stands for it.
  std::filesystem::create_symlink(std::filesystem::absolute(job.step_file), job.folder / "part.step");
  std::ofstream(job.folder / "job.geo") << "SetFactory(\"OpenCASCADE\");\nGeometry.OCCTargetUnit = \"MM\";\nMerge \"part.step\";\n" << job.script;
  const foundation::Command command{.program = *program,
                                    .arguments = {"job.geo", "-", "-nt", "1", "-v", "2"},
                                    .folder = job.folder,
                                    .environment = {"HOME=" + job.folder.string(), "GMSH_HOME=" + job.folder.string(), "LC_ALL=C"},
                                    .time_limit = job.time_limit,
                                    .task = job.task};
  const foundation::CommandOutcome outcome = run(command, progress);
  if (!outcome.succeeded())
    return refused(fmt::format("{}: gmsh failed ({}): {}", job.step_file.string(), how_it_ended(outcome, command), complaints(outcome.output)),
                   "gmsh must be able to read and mesh the solids of the file", "take smaller elements if it was meshing; else heal the solid in the CAD program and export it again");
  return {};
}

}  // namespace trivet::solids
