// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/step_file.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/gmsh_program.h"

namespace trivet::solids {
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
