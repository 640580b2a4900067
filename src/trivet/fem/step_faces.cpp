// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/step_faces.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "trivet/fem/msh_file.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/step_file.h"

namespace trivet::fem {
namespace {

using foundation::Problems;

constexpr double millimetre = 1e-3;
constexpr double same_place = 1e-6;  // of the solid's diagonal: coordinates of STEP files have more digits than that
constexpr double same_volume = 1e-6;
constexpr std::size_t most_listed_faces = 12;

/// Appends the number of solids and their volumes to faces.txt.
constexpr const char* volumes_script = R"(
solids() = Volume{:};
Printf("%g", #solids()) >> "faces.txt";
For k In {0 : #solids() - 1}
  volume = Mass Volume{solids(k)};
  Printf("%.17g", volume) >> "faces.txt";
EndFor
)";

constexpr const char* faces_script = R"(
faces() = Abs(Boundary{ Volume{:}; });
For k In {0 : #faces() - 1}
  area = Mass Surface{faces(k)};
  centre() = CenterOfMass Surface{faces(k)};
  Printf("%g %.17g %.17g %.17g %.17g", faces(k), area, centre(0), centre(1), centre(2)) >> "faces.txt";
EndFor
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 2.2;
Mesh.SaveAll = 1;
Mesh 2;
Save "faces.msh";
)";

tl::unexpected<Problems> refused(const std::string& subject, const std::string& finding, const std::string& rule,
                                 const std::string& remedy) {
  return foundation::failure({.subject = subject, .finding = finding, .rule = rule, .remedy = remedy});
}

std::vector<double> read_volumes(std::istream& stream) {
  std::size_t count = 0;
  stream >> count;
  std::vector<double> volumes;
  for (double volume; volumes.size() < count && stream >> volume;) volumes.push_back(volume);
  return volumes;
}

bool nearly_equal(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
      std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) <= same_volume * x; });
}

/// Points of each face of a mesh, by the face's number.
std::map<int, Eigen::Matrix3Xd> points_by_face(const MshFile& mesh, double unit) {
  std::map<int, std::vector<int>> nodes;
  for (std::size_t t = 0; t < mesh.face.size(); ++t)
    for (int k = 0; k < 6; ++k) nodes[mesh.face[t]].push_back(mesh.triangles(k, to_index(t)));
  std::map<int, Eigen::Matrix3Xd> points;
  for (auto& [face, list] : nodes) {
    std::ranges::sort(list);
    list.erase(std::ranges::unique(list).begin(), list.end());
    points[face] = unit * mesh.nodes(Eigen::all, list);
  }
  return points;
}

/// True if a face fulfils a selection.
struct Fulfils {
  const StepFaces& all;
  double tolerance;

  bool operator()(const FurthestFaces& furthest, const StepFace& face) const {
    const Eigen::Vector3d direction = furthest.direction.normalized();
    double most = -std::numeric_limits<double>::infinity();
    for (const StepFace& other : all.faces) most = std::max(most, (direction.transpose() * other.points).maxCoeff());
    return (direction.transpose() * face.points).minCoeff() >= most - tolerance;
  }
  bool operator()(const FacesInBox& box, const StepFace& face) const {
    return (face.low.array() >= box.low.array() - tolerance).all() &&
        (face.high.array() <= box.high.array() + tolerance).all();
  }
  bool operator()(const FacesOnCylinder& cylinder, const StepFace& face) const {
    const Eigen::Vector3d axis = cylinder.axis.normalized();
    const Eigen::Matrix3Xd from_point = face.points.colwise() - cylinder.point;
    const Eigen::Matrix3Xd across = from_point - axis * (axis.transpose() * from_point);
    return ((across.colwise().norm().array() - cylinder.radius).abs() <= tolerance).all();
  }
  bool operator()(const FacesByNumber& named, const StepFace& face) const {
    return std::ranges::find(named.numbers, face.number) != named.numbers.end();
  }
};

std::string selection_text(const FaceSelection& selection, const StepFaces& all) {
  struct SelectionText {
    const StepFaces& all;
    std::string operator()(const FurthestFaces& s) const {
      return fmt::format("no plane face normal to ({:.4g}, {:.4g}, {:.4g}) at the end of the solid in this direction",
                         s.direction.x(), s.direction.y(), s.direction.z());
    }
    std::string operator()(const FacesInBox& s) const {
      return fmt::format("no face between ({:.4g}, {:.4g}, {:.4g}) m and ({:.4g}, {:.4g}, {:.4g}) m", s.low.x(),
                         s.low.y(), s.low.z(), s.high.x(), s.high.y(), s.high.z());
    }
    std::string operator()(const FacesOnCylinder& s) const {
      return fmt::format("no face on the cylinder of radius {:.6g} m", s.radius);
    }
    std::string operator()(const FacesByNumber& s) const {
      for (const int number : s.numbers)
        if (std::ranges::none_of(all.faces, [&](const StepFace& face) { return face.number == number; }))
          return fmt::format("no face {}", number);
      return "no face is selected";
    }
  };
  return std::visit(SelectionText{all}, selection);
}

double diagonal(const StepFaces& all) {
  Eigen::AlignedBox3d box;
  for (const StepFace& face : all.faces) box.extend(face.low).extend(face.high);
  return box.diagonal().norm();
}

std::string list_of(const StepFaces& all) {
  const double rounding = same_place * diagonal(all);
  const auto without_round_off = [&](double x) { return std::abs(x) < rounding ? 0.0 : x; };
  std::string list;
  for (std::size_t i = 0; i < std::min(all.faces.size(), most_listed_faces); ++i) {
    const StepFace& face = all.faces[i];
    list += fmt::format("{}{} at ({:.4g}, {:.4g}, {:.4g}) m with {:.4g} m²", i > 0 ? ", " : "", face.number,
                        without_round_off(face.centre.x()), without_round_off(face.centre.y()),
                        without_round_off(face.centre.z()), face.area);
  }
  return all.faces.size() > most_listed_faces ? list + fmt::format(" and {} more", all.faces.size() - most_listed_faces)
                                              : list;
}

bool all_numbers_exist(const FaceSelection& selection, const StepFaces& all) {
  const FacesByNumber* named = std::get_if<FacesByNumber>(&selection);
  return !named || std::ranges::all_of(named->numbers, [&](int number) {
    return std::ranges::any_of(all.faces, [&](const StepFace& face) { return face.number == number; });
  });
}

}  // namespace

const char* const joining_script = R"(
solids() = Volume{:};
If (#solids() > 1)
  BooleanFragments{ Volume{:}; Delete; }{}
EndIf
)";

foundation::Expected<StepFaces> step_faces(const std::filesystem::path& file, double scale,
                                           const foundation::Progress& progress) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw foundation::InvalidInput(fmt::format("scale = {}; must be > 0", scale));
  const foundation::TemporaryFolder folder;
  // Joining keeps the solids and their order unless they overlap; the volumes before and after show this.
  const std::string script = std::string(volumes_script) + joining_script + volumes_script + faces_script;
  const auto done = solids::run_gmsh(
      {.step_file = file, .folder = folder.path(), .script = script, .task = "reading STEP"}, progress);
  if (!done) return tl::unexpected(done.error());

  std::ifstream stream(folder.path() / "faces.txt");
  const std::vector<double> apart = read_volumes(stream), joined = read_volumes(stream);
  if (apart.empty())
    return refused("file", fmt::format("{}: contains no solid", file.string()), "a mount must be a solid body",
                   "export the part as a solid body");
  if (!nearly_equal(apart, joined))
    return refused(
        "file",
        fmt::format("{}: {} solids become {} when joined: they overlap", file.string(), apart.size(), joined.size()),
        "solids may touch but not overlap", "cut them in the CAD program so that they touch");
  const auto mesh = read_msh(folder.path() / "faces.msh");
  if (!mesh) return tl::unexpected(mesh.error());

  const double unit = millimetre * scale;
  const std::map<int, Eigen::Matrix3Xd> points = points_by_face(*mesh, unit);
  StepFaces all;
  all.solids = static_cast<int>(joined.size());
  for (const double volume : joined) all.volume += volume * unit * unit * unit;
  for (StepFace face; stream >> face.number >> face.area >> face.centre.x() >> face.centre.y() >> face.centre.z();) {
    const auto found = points.find(face.number);
    if (found == points.end()) continue;
    face.area *= unit * unit;
    face.centre *= unit;
    face.points = found->second;
    face.low = face.points.rowwise().minCoeff();
    face.high = face.points.rowwise().maxCoeff();
    all.faces.push_back(face);
  }
  std::ranges::sort(all.faces, {}, &StepFace::number);
  return all;
}

foundation::Expected<std::vector<std::size_t>> selected_faces(const StepFaces& all, const FaceSelection& selection,
                                                              const std::string& subject) {
  const Fulfils fulfils{all, same_place * diagonal(all)};
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < all.faces.size(); ++i)
    if (std::visit([&](const auto& wanted) { return fulfils(wanted, all.faces[i]); }, selection)) chosen.push_back(i);
  if (chosen.empty() || !all_numbers_exist(selection, all))
    return refused(subject, selection_text(selection, all),
                   fmt::format("a plate must be bonded to faces of the solid: {}", list_of(all)),
                   "select its faces by number, box, cylinder or direction");
  return chosen;
}

}  // namespace trivet::fem
