// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/step_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include "trivet/foundation/child_process.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"

namespace trivet::solids {

namespace {

using foundation::Problems;

constexpr std::size_t step_header_bytes = 4096;  // blanks and comments may precede the first word of a STEP file
constexpr std::size_t most_shown_characters = 300;
constexpr const char* gmsh_time_limit = "TRIVET_GMSH_SECONDS";
constexpr double longest_time = 604800;  // [s] a week

tl::unexpected<Problems> refused(const std::string& finding, const std::string& rule, const std::string& remedy) {
  return foundation::failure({.subject = "file", .finding = finding, .rule = rule, .remedy = remedy});
}

foundation::Expected<void> check_step(const std::filesystem::path& file) {
  std::error_code not_a_file;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, not_a_file)) stream.open(file, std::ios::binary);  // a pipe would block
  if (!stream.is_open())
    return refused(fmt::format("{}: cannot be read", file.string()), "a STEP file is needed",
                   "check its name and its permissions");
  std::string begin(step_header_bytes, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(to_size(stream.gcount()));
  if (begin.find("ISO-10303-21") == std::string::npos)
    return refused(fmt::format("{}: is not a STEP file", file.string()), "a STEP file begins with ISO-10303-21",
                   "export the part as STEP (AP203, AP214, AP242)");
  return {};
}

/// Messages of gmsh without terminal colours and frames of asterisks, on one line.
std::string complaints(const std::string& output) {
  std::string text;
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (output[i] == '\033') i = std::min(output.find('m', i), output.size());
    else if (output[i] == '\n') text += ' ';
    else if (output[i] != '*' && !(output[i] == ' ' && text.ends_with(' '))) text += output[i];
  }
  return text.size() > most_shown_characters ? "…" + text.substr(text.size() - most_shown_characters) : text;
}

/// Writes the script, and a link to the STEP file so that the user's path never enters the script.
foundation::Expected<void> prepare(const GmshJob& job) {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::absolute(job.step_file, error);
  if (!error) std::filesystem::create_symlink(file, job.folder / "part.step", error);
  if (error)
    return refused(fmt::format("{}: cannot be linked for gmsh: {}", job.step_file.string(), error.message()),
                   "gmsh works in a temporary folder", "check the folder in TMPDIR and the current one");
  errno = 0;
  std::ofstream script(job.folder / "job.geo");
  script << "SetFactory(\"OpenCASCADE\");\nGeometry.OCCTargetUnit = \"MM\";\nMerge \"part.step\";\n" << job.script;
  script.close();
  if (!script)
    return refused(fmt::format("{}: {}", job.folder.string(), errno ? std::strerror(errno) : "cannot be written"),
                   "gmsh works in a temporary folder", "free some space, or set TMPDIR to a folder with space");
  return {};
}

/// Results must be regular files: reading a pipe would block, a folder would fail.
foundation::Expected<void> check_results(const GmshJob& job) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(job.folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string extension = entry->path().extension().string();
    const bool is_result = extension == ".txt" || extension == ".msh" || extension == ".stl";
    if (is_result && !std::filesystem::is_regular_file(entry->symlink_status(error)))
      return refused(fmt::format("{}: gmsh wrote {}, which is not a file", job.step_file.string(),
                                 entry->path().filename().string()),
                     "gmsh writes its results to files", "check the program gmsh: `gmsh --version`");
  }
  return {};
}

/// Time limit of the job, or the user's; nullopt if the user's is not a number of seconds in the range.
std::optional<double> time_limit(const GmshJob& job) {
  const char* given = std::getenv(gmsh_time_limit);
  if (!given || !*given) return job.time_limit;
  const std::string_view text = given;
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool good = error == std::errc() && end == text.data() + text.size() && seconds > 0 && seconds <= longest_time;
  return good ? std::optional<double>(seconds) : std::nullopt;
}

}  // namespace

foundation::Expected<void> run_gmsh(const GmshJob& job, const foundation::Progress& progress) {
  if (const auto step = check_step(job.step_file); !step) return step;
  const auto program = foundation::program_on_path("gmsh");
  if (!program)
    return refused(fmt::format("{}: the program gmsh is not installed", job.step_file.string()),
                   "STEP files are read by the program gmsh",
                   "install it (Debian package gmsh), or describe the solid by primitives or STL");

  const std::optional<double> limit = time_limit(job);
  if (!limit)
    return refused(fmt::format("{} = \"{}\"", gmsh_time_limit, std::getenv(gmsh_time_limit)),
                   fmt::format("the time that gmsh may take is > 0 s and at most {:.0f} s", longest_time),
                   "correct the environment variable, or remove it");
  if (const auto prepared = prepare(job); !prepared) return prepared;
  const foundation::Command command{
      .program = *program,
      .arguments = {"job.geo", "-", "-nt", "1", "-v", "2"},
      .folder = job.folder,
      .environment = {"HOME=" + job.folder.string(), "GMSH_HOME=" + job.folder.string(), "LC_ALL=C"},
      .time_limit = *limit,
      .task = job.task};
  foundation::CommandOutcome outcome;
  try {
    outcome = run(command, progress);
  } catch (const std::system_error& error) {
    return refused(fmt::format("{}: gmsh cannot be started: {}", job.step_file.string(), error.code().message()),
                   "STEP files are read by the program gmsh", fmt::format("check {}", program->string()));
  }
  if (outcome.end == foundation::CommandOutcome::End::time_limit)
    return refused(
        fmt::format("{}: gmsh had not finished after {:.4g} s and was stopped", job.step_file.string(), *limit),
        "gmsh must read and mesh the solids of the file in time",
        fmt::format("use larger elements if it was meshing, or set {} to more seconds", gmsh_time_limit));
  if (!outcome.succeeded())
    return refused(
        fmt::format("{}: gmsh failed ({}): {}", job.step_file.string(), how_it_ended(outcome, command),
                    complaints(outcome.output)),
        "gmsh must be able to read and mesh the solids of the file",
        "use smaller elements if it was meshing; otherwise repair the solid in the CAD program and export it again");
  return check_results(job);
}

namespace {

using foundation::Problems;

constexpr double millimetre = 1e-3;
constexpr std::size_t most_solids = 100000;  // 8 MB; gmsh itself takes hours for so many

constexpr const char* script = R"(
solids() = Volume{:};
Printf("%g", #solids()) > "volumes.txt";
For k In {0 : #solids() - 1}
  volume = Mass Volume{solids(k)};
  centre() = CenterOfMass Volume{solids(k)};
  inertia() = MatrixOfInertia Volume{solids(k)};
  Printf("%.17g %.17g %.17g %.17g", volume, centre(0), centre(1), centre(2)) >> "volumes.txt";
  Printf("%.17g %.17g %.17g %.17g %.17g %.17g", inertia(0), inertia(4), inertia(8), inertia(1),
    inertia(2), inertia(5)) >> "volumes.txt";
EndFor
)";

/// One solid as the script writes it: volume, centre, Jxx, Jyy, Jzz, Jxy, Jxz, Jyz (tensor entries) about the centre;
/// mm.
bool read_volume(std::istream& stream, VolumeIntegrals& v) {
  double xx, yy, zz, xy, xz, yz;
  if (!(stream >> v.volume >> v.centre.x() >> v.centre.y() >> v.centre.z() >> xx >> yy >> zz >> xy >> xz >> yz))
    return false;
  Eigen::Matrix3d inertia;
  inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  v.volume *= std::pow(millimetre, 3);
  v.centre *= millimetre;
  // J = tr(M) I − M, hence tr J = 2 tr M.
  v.second_moment = std::pow(millimetre, 5) * (inertia.trace() / 2 * Eigen::Matrix3d::Identity() - inertia);
  return true;
}

}  // namespace

foundation::Expected<std::vector<VolumeIntegrals>> step_volumes(const std::filesystem::path& file,
                                                                const foundation::Progress& progress) {
  const foundation::TemporaryFolder folder;
  const auto done =
      run_gmsh({.step_file = file, .folder = folder.path(), .script = script, .task = "reading STEP"}, progress);
  if (!done) return tl::unexpected(done.error());

  std::ifstream stream(folder.path() / "volumes.txt");
  std::size_t count = 0;
  Problems problems;
  if (!(stream >> count) || count == 0) {
    problems.error("file", fmt::format("{}: contains no solid", file.string()),
                   "volumes are needed, not surfaces or curves alone", "export the part as a solid body");
    return tl::unexpected(problems);
  }
  if (count > most_solids) {
    problems.error("file", fmt::format("{}: {} solids according to gmsh", file.string(), count),
                   fmt::format("a file holds at most {} solids", most_solids),
                   "check the program gmsh: `gmsh --version`");
    return tl::unexpected(problems);
  }
  std::vector<VolumeIntegrals> volumes(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!read_volume(stream, volumes[i]) || !(volumes[i].volume > 0))
      problems.error(
          "file",
          fmt::format("{}: solid {} of {} has the volume {:.6g} m³", file.string(), i + 1, count, volumes[i].volume),
          "a solid has a volume > 0", "repair the solid in the CAD program and export it again");
  if (problems.has_errors()) return tl::unexpected(problems);
  return volumes;
}

}  // namespace trivet::solids
