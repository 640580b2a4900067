// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/step_surface.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <system_error>
#include <tuple>

#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/step_file.h"

namespace trivet::solids {
namespace {

using Surfaces = std::shared_ptr<const std::vector<TriangleSurface>>;
using FileState = std::tuple<std::filesystem::path, std::uintmax_t, std::filesystem::file_time_type>;

constexpr double file_unit = 1e-3;   // [m], see GmshJob
constexpr double longest_wait = 60;  // [s] that a drawing may wait
constexpr std::size_t most_drawn_solids = 10000;

/// Physical groups choose what is saved. Edges are as long as the curvature of their own surface asks for.
constexpr const char* surface_script = R"(
Mesh.MeshSizeFromCurvature = 36;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.Binary = 1;
solids() = Volume{:};
Mesh 2;
For k In {0 : #solids() - 1}
  Delete Physicals;
  Physical Surface(1) = Abs(Boundary{ Volume{solids(k)}; });
  Save Sprintf("surface%g.stl", k + 1);
EndFor
Printf("%g", #solids()) > "solids.txt";
)";

Surfaces meshed(const std::filesystem::path& file) {
  const foundation::TemporaryFolder folder;
  if (!run_gmsh({.step_file = file,
                 .folder = folder.path(),
                 .script = surface_script,
                 .task = "drawing STEP",
                 .time_limit = longest_wait}))
    return nullptr;
  std::size_t count = 0;
  std::ifstream(folder.path() / "solids.txt") >> count;
  if (count == 0 || count > most_drawn_solids) return nullptr;
  std::vector<TriangleSurface> surfaces;
  for (std::size_t k = 1; k <= count; ++k) {
    auto surface = read_stl(folder.path() / fmt::format("surface{}.stl", k));
    if (!surface) return nullptr;
    surface->vertices *= file_unit;
    surfaces.push_back(std::move(*surface));
  }
  return std::make_shared<const std::vector<TriangleSurface>>(std::move(surfaces));
}

}  // namespace

Surfaces step_surfaces(const std::filesystem::path& file) {
  static std::mutex mutex;
  static std::map<FileState, Surfaces> known;
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(file, error);
  const std::uintmax_t size = error ? 0 : std::filesystem::file_size(absolute, error);
  if (error) return nullptr;
  const auto changed = std::filesystem::last_write_time(absolute, error);
  if (error) return nullptr;
  const std::scoped_lock lock(mutex);
  const auto [entry, is_new] = known.try_emplace({absolute, size, changed});
  if (is_new) entry->second = meshed(absolute);
  return entry->second;
}

}  // namespace trivet::solids
