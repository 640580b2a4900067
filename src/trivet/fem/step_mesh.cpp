// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/step_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "trivet/fem/msh_file.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/step_file.h"

namespace trivet::fem {
namespace {

using foundation::Problems;

constexpr double one_millimetre = 1e-3;
constexpr double most_elements =
    1e6;  // about 4 million unknowns: more than a direct solver can hold in a few gigabytes
constexpr double volume_of_element = 0.118;  // regular tetrahedron / edge³

Problems problems_of(const StepMeshOptions& options) {
  Problems problems;
  const auto must_be = [&](const char* name, double value, bool good, const char* rule) {
    if (!good)
      problems.error(name, std::isnan(value) ? "not given" : fmt::format("{:.6g}", value), rule,
                     "give a length with its unit");
  };
  must_be("size", options.size, options.size > 0 && std::isfinite(options.size),
          "the size of the finite elements must be > 0");
  must_be("rim_size", options.rim_size, options.rim_size >= 0 && !(options.rim_size > options.size),
          "must be between 0 and size; 0 means size/4");
  must_be("rim_distance", options.rim_distance, options.rim_distance >= 0 && std::isfinite(options.rim_distance),
          "must be ≥ 0; 0 means twice the size");
  must_be("scale", options.scale, options.scale > 0 && std::isfinite(options.scale), "must be > 0");
  must_be("time_limit", options.time_limit, options.time_limit > 0, "must be > 0");
  return problems;
}

std::string numbers(const std::vector<StepFace>& faces) {
  std::string list;
  for (const StepFace& face : faces) list += fmt::format("{}{}", list.empty() ? "" : ", ", face.number);
  return list;
}

/// Twelve elements around a full turn of any curved surface; with fewer, second-order elements invert there. The size
/// grows from the outer rims of the bonded faces of each plate (edges inside one plate do not count).
std::string script(const StepMesh& step, const StepMeshOptions& options) {
  const double unit = one_millimetre * options.scale;
  const double size = options.size / unit,
               rim_size = (options.rim_size > 0 ? options.rim_size : options.size / 4) / unit,
               distance = (options.rim_distance > 0 ? options.rim_distance : 2 * options.size) / unit;
  return joining_script +
      fmt::format(R"(
rims() = Abs(CombinedBoundary{{ Surface{{ {} }}; }});
rims() += Abs(CombinedBoundary{{ Surface{{ {} }}; }});
points = 20;
For k In {{0 : #rims() - 1}}
  length = Mass Curve{{rims(k)}};
  points = (points > 2 * length / {:.17g}) ? points : Ceil(2 * length / {:.17g});
EndFor
Field[1] = Distance;
Field[1].CurvesList = {{rims()}};
Field[1].NumPointsPerCurve = points;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = {:.17g};
Field[2].SizeMax = {:.17g};
Field[2].DistMin = 0;
Field[2].DistMax = {:.17g};
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 12;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 2.2;
Mesh.SaveAll = 1;
Mesh 3;
Save "mesh.msh";
)",
                  numbers(step.faces_n), numbers(step.faces_k), rim_size, rim_size, rim_size, size, distance);
}

Eigen::Vector3d centre_of(const std::vector<StepFace>& faces) {
  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const StepFace& face : faces) area += face.area, moment += face.area * face.centre;
  return moment / area;
}

std::vector<StepFace> chosen_faces(const StepFaces& all, const std::vector<std::size_t>& chosen) {
  std::vector<StepFace> faces;
  for (const std::size_t i : chosen) faces.push_back(all.faces[i]);
  return faces;
}

/// Nodes of some faces, by their new numbers, ascending.
std::vector<int> nodes_on(const MshFile& file, const std::vector<StepFace>& faces, const std::vector<int>& renumbered) {
  std::set<int> wanted, nodes;
  for (const StepFace& face : faces) wanted.insert(face.number);
  for (std::size_t t = 0; t < file.face.size(); ++t)
    if (wanted.contains(file.face[t]))
      for (int k = 0; k < 6; ++k) nodes.insert(renumbered[file.triangles(k, to_index(t))]);
  return {nodes.begin(), nodes.end()};
}

/// The tetrahedra with only their own nodes, in the file's order.
Mesh mesh_of(const MshFile& file, const StepMesh& step, double unit) {
  std::vector<int> renumbered(to_size(file.nodes.cols()), -1);
  for (const int node : file.tetrahedra.reshaped()) renumbered[node] = 0;
  std::vector<int> kept;
  for (std::size_t i = 0; i < renumbered.size(); ++i)
    if (renumbered[i] == 0) {
      renumbered[i] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(i));
    }
  Mesh mesh;
  mesh.kind = Mesh::Kind::tet10;
  mesh.nodes = unit * file.nodes(Eigen::all, kept);
  mesh.elements = file.tetrahedra.unaryExpr([&](int node) { return renumbered[node]; });
  const std::set<int> solids(file.solid.begin(), file.solid.end());
  for (const int solid : file.solid)
    mesh.material.push_back(static_cast<int>(std::distance(solids.begin(), solids.find(solid))));
  mesh.plate_n = nodes_on(file, step.faces_n, renumbered);
  mesh.plate_k = nodes_on(file, step.faces_k, renumbered);
  return mesh;
}

void check_count(const StepFaces& all, const StepMeshOptions& options, Problems& problems) {
  const double count = all.volume / (volume_of_element * std::pow(options.size, 3));
  if (count > most_elements)
    problems.error(
        "size",
        fmt::format("{:.4g} m; a volume of {:.4g} m³ needs about {:.2g} elements", options.size, all.volume, count),
        fmt::format("at most about {:.2g} elements can be computed", most_elements),
        fmt::format("use a size above {:.3g} m", std::cbrt(all.volume / (volume_of_element * most_elements))));
}

void check_apart(const StepMesh& step, Problems& problems) {
  for (const StepFace& n : step.faces_n)
    for (const StepFace& k : step.faces_k)
      if (n.number == k.number)
        problems.error("plate_k", fmt::format("face {} is also bonded to plate N", k.number),
                       "a face must belong to one plate only", "select other faces");
}

}  // namespace

foundation::Expected<StepMesh> mesh_step(const std::filesystem::path& file, const StepMeshOptions& options,
                                         const foundation::Progress& progress) {
  Problems problems = problems_of(options);
  if (problems.has_errors()) return tl::unexpected(problems);
  const auto all = step_faces(file, options.scale, progress);
  if (!all) return tl::unexpected(all.error());
  const auto chosen_n = selected_faces(*all, options.plate_n, "plate_n"),
             chosen_k = selected_faces(*all, options.plate_k, "plate_k");
  if (!chosen_n) problems.add(chosen_n.error());
  if (!chosen_k) problems.add(chosen_k.error());
  check_count(*all, options, problems);
  if (problems.has_errors()) return tl::unexpected(problems);

  StepMesh step{.mesh = {},
                .faces_n = chosen_faces(*all, *chosen_n),
                .faces_k = chosen_faces(*all, *chosen_k),
                .centre_n = {},
                .centre_k = {},
                .solids = all->solids,
                .volume = all->volume};
  step.centre_n = centre_of(step.faces_n);
  step.centre_k = centre_of(step.faces_k);
  check_apart(step, problems);
  if (problems.has_errors()) return tl::unexpected(problems);

  const foundation::TemporaryFolder folder;
  const auto done = solids::run_gmsh({.step_file = file,
                                      .folder = folder.path(),
                                      .script = script(step, options),
                                      .task = "meshing STEP",
                                      .time_limit = options.time_limit},
                                     progress);
  if (!done) return tl::unexpected(done.error());
  const auto msh = read_msh(folder.path() / "mesh.msh");
  if (!msh) return tl::unexpected(msh.error());
  step.mesh = mesh_of(*msh, step, one_millimetre * options.scale);
  return step;
}

}  // namespace trivet::fem
