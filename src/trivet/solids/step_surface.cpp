// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/step_surface.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "trivet/foundation/temporary_folder.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/solids/step_file.h"

namespace trivet::solids {
namespace {

using Surfaces = std::shared_ptr<const std::vector<TriangleSurface>>;
using Clock = std::chrono::steady_clock;
/// Size and time of change.
using FileState = std::pair<std::uintmax_t, std::filesystem::file_time_type>;

constexpr double file_unit = 1e-3;   // [m], see GmshJob
constexpr double longest_wait = 60;  // [s] that a drawing may wait
constexpr int failure_holds = 10;    // times as long as gmsh took to fail
constexpr const char* task = "drawing STEP";
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
                 .task = task,
                 .time_limit = longest_wait},
                foundation::thread_progress()))
    return nullptr;
  std::size_t count = 0;
  std::ifstream(folder.path() / "solids.txt") >> count;
  if (count == 0 || count > most_drawn_solids) return nullptr;
  std::vector<TriangleSurface> surfaces;
  for (std::size_t k = 1; k <= count; ++k) {
    auto surface = read_stl(folder.path() / fmt::format("surface{}.stl", k), foundation::thread_progress());
    if (!surface) return nullptr;
    surface->vertices *= file_unit;
    surfaces.push_back(std::move(*surface));
  }
  return std::make_shared<const std::vector<TriangleSurface>>(std::move(surfaces));
}

std::optional<FileState> state_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return std::nullopt;
  const auto changed = std::filesystem::last_write_time(file, error);
  return error ? std::nullopt : std::optional(FileState(size, changed));
}

/// A file with the surfaces of its newest state. Its lock is held while gmsh runs.
class DrawnFile {
 public:
  Surfaces surfaces(const std::filesystem::path& file) {
    const std::unique_lock lock = locked();
    const std::optional<FileState> now = state_of(file);
    if (now && known_ == now && (surfaces_ || Clock::now() < next_trial_)) return surfaces_;
    known_.reset();
    surfaces_ = nullptr;
    if (!now) return nullptr;
    const Clock::time_point begin = Clock::now();
    surfaces_ = meshed(file);  // throws if it is interrupted: nothing is known then
    known_ = now;
    const Clock::time_point end = Clock::now();
    next_trial_ = end + failure_holds * (end - begin);
    return surfaces_;
  }

 private:
  /// Who waits for gmsh of another thread can be interrupted, too.
  std::unique_lock<std::timed_mutex> locked() {
    std::unique_lock lock(mutex_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(100)))
      foundation::report_progress(foundation::thread_progress(), task, 0);
    return lock;
  }

  std::timed_mutex mutex_;
  std::optional<FileState> known_;
  Surfaces surfaces_;
  Clock::time_point next_trial_;  ///< if it has no surfaces
};

DrawnFile& drawn_file(const std::filesystem::path& file) {
  static std::mutex mutex;
  static std::map<std::filesystem::path, DrawnFile> files;  // its places stay where they are
  const std::scoped_lock lock(mutex);
  return files[file];
}

}  // namespace

Surfaces step_surfaces(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(file, error);
  return error ? nullptr : drawn_file(absolute).surfaces(absolute);
}

}  // namespace trivet::solids
