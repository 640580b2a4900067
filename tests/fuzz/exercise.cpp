// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/exercise.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "trivet/exchange/end_stiffness.h"
#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/named_matrix.h"
#include "trivet/fem/msh_file.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/elements/catalogue.h"
#include "trivet/project/text/changes.h"
#include "trivet/results/model/project_json.h"
#include "trivet/solids/closed_surface.h"
#include "trivet/solids/stl_file.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_coordinates = 12, most_elements = 12, most_cases = 3;
constexpr int most_reports = 300;  // of progress: an analysis stops after that many steps

/// A folder for the files that projects refer to, removed at the end. The cache is off.
const fs::path& folder() {
  static const int without_cache = ::setenv("TRIVET_CACHE", "", 1);
  static_cast<void>(without_cache);
  static const foundation::TemporaryFolder own;
  return own.path();
}

fs::path written(std::string_view bytes, const std::string& name) {
  const fs::path path = folder() / name;
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

/// Needs finite elements or the mesher, which take seconds: tests/campaign runs them.
bool is_slow(std::string_view text) {
  return text.find("finite_elements") != std::string_view::npos || text.find("solid_mount") != std::string_view::npos ||
      text.find(".st") != std::string_view::npos;
}

void ask(const project::Case& variant, const std::function<void(project::Analyses&)>& analysis) {
  project::Analyses request;
  analysis(request);
  int reports = 0;
  const foundation::Progress bounded = [&](std::string_view, double) {
    if (++reports > most_reports) throw foundation::Interrupted();
  };
  try {
    static_cast<void>(study::case_results(variant, request, bounded));
  } catch (const foundation::NotComputable&) {
  } catch (const foundation::InvalidInput&) {
  } catch (const foundation::Interrupted&) {
  }
}

void ask_quick_analyses(const project::Project& project) {
  for (std::size_t i = 0; i < std::min(project.cases.size(), most_cases); ++i) {
    const project::Case& variant = project.cases[i];
    if (project::coordinates(variant.system.description(), true) > most_coordinates ||
        variant.system.elements().size() > most_elements)
      continue;
    ask(variant, [](project::Analyses& a) { a.modes = a.roots = true; });
    ask(variant, [](project::Analyses& a) { a.response.emplace().at = {7.5}; });
    ask(variant, [](project::Analyses& a) { a.static_of = {"coordinates", "ground"}; });
    if (project::coordinates(variant.system.description(), true) <= most_coordinates / 2)
      ask(variant, [](project::Analyses& a) { a.peaks.emplace(); });
    ask(variant, [&](project::Analyses& a) {
      if (variant.analyses.random) a.random.emplace();
      a.earthquake = variant.analyses.earthquake;
    });
  }
}

void read_text(const std::string& text, const fs::path& source) {
  if (is_slow(text)) return;
  const auto project = judging::project_from_text(text, source.string());
  if (!project) {
    static_cast<void>(results::problems_json(project.error(), {}));
    return;
  }
  ask_quick_analyses(*project);
  static_cast<void>(results::results_json(*project, {}));
}

/// A valid machine, and the place in it for a file of each role.
constexpr const char* machine = R"(trivet = 1
gravity = [0, 0, -9.80665]
[bodies.frame]
mass = 10
inertia = {about = "pole", xx = 1, yy = 1, zz = 1}
[elements.spring]
type = "bushing"
on = "frame"
at = [0, 0, 0]
translation = [1e5, 1e5, 2e5]
rotation = [1e4, 1e4, 1e4]
damping = {proportional = 0.001}
[excitations.push]
type = "harmonic"
on = "frame"
at = [0, 0, 0.1]
force = [0, 1, 1]
)";

constexpr const char* element = "[elements.mount]\non = \"frame\"\nat = [0.1, 0, 0]\nfrom_at = [0.1, 0, -0.1]\n";

struct Role {
  std::string_view name;
  const char* before;  ///< text after the machine that refers to a file "data.csv"
};

constexpr Role file_roles[] = {
    {"table", "type = \"table\"\nfile = \"data.csv\"\n"},
    {"measured", "type = \"measured\"\nload_cases = \"data.csv\"\nlength_unit = \"1 mm\"\nangle_unit = \"1 deg\"\n"},
    {"loops",
     "type = \"bushing\"\ntranslation = [1e5, 1e5, 1e6]\nrotation = [100, 100, 100]\ndamping = {loops = \"data.csv\", "
     "law = \"best\"}\n"},
    {"imported", "type = \"imported\"\nfile = \"data.csv\"\nformat = \"csv\"\n"},
    {"mobility",
     "type = \"bushing\"\ntranslation = [1e5, 1e5, 1e6]\nfoundation = \"deck\"\n[foundations.deck]\ntype = "
     "\"mobility\"\nfile = \"data.csv\"\n"},
};
constexpr Role other_roles[] = {
    {"spectrum",
     "[excitations.road]\ntype = \"random\"\nbase = true\ntranslation = [0, 0, 1]\npsd = {file = "
     "\"data.csv\"}\n[analyses]\nrandom = {}\n"},
    {"history",
     "[excitations.shock]\ntype = \"time\"\non = \"frame\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {file = "
     "\"data.csv\"}\n[analyses]\ntransient = {to = 1, step = 0.1}\n"},
    {"earthquake", "[analyses]\nearthquake = {file = \"data.csv\", direction = \"x\"}\n"},
    {"limit line", "[analyses]\nresponse = {at = [5]}\n[limit_lines.line]\nof = \"frame.z\"\nfile = \"data.csv\"\n"},
    {"pressure",
     "[excitations.engine]\ntype = \"orders\"\non = \"frame\"\nat = [0, 0, 0]\nengine = {layout = \"inline\", "
     "cylinders = 1, crank_radius = 0.05, rod_length = 0.2, oscillating_mass = 1, pressure = "
     "{file = \"data.csv\", bore = 0.1}}\n"},
};

void use_matrix(const foundation::Expected<exchange::NamedMatrix>& matrix) {
  if (!matrix || matrix->values.rows() > 60) return;
  static_cast<void>(exchange::reduce_to_rows(*matrix, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  if (!matrix->labels.empty())
    static_cast<void>(exchange::reduce_to_ends(*matrix, exchange::NodeEnd{matrix->labels.front().node},
                                               exchange::NodeEnd{matrix->labels.back().node}));
}

void read_matrices(const std::string& text) {
  use_matrix(exchange::read_matrix_market(text, "input"));
  use_matrix(exchange::read_numpy_array(text, "input"));
  use_matrix(exchange::read_csv_matrix(text, "input"));
  use_matrix(exchange::read_nastran_dmig(text, "input"));
  use_matrix(exchange::read_abaqus_matrix(text, "input"));
  use_matrix(exchange::read_matrix_storage(text, "input", text, "input"));
}

void read_file_in_role(std::string_view role, std::string_view bytes) {
  const fs::path source = folder() / "project.toml";
  if (role == "matrix") return read_matrices(std::string(bytes));
  if (role == "setting") return static_cast<void>(project::parse_setting(std::string(bytes)));
  if (role == "msh") return static_cast<void>(fem::read_msh(written(bytes, "data.msh")));
  if (role == "catalogue") return static_cast<void>(project::catalogue_from_text(std::string(bytes), "input"));
  if (role == "stl") {
    const auto surface = solids::read_stl(written(bytes, "data.stl"));
    if (surface) static_cast<void>(solids::enclosed_volume(*surface));
    return;
  }
  static_cast<void>(written(bytes, "data.csv"));
  for (const Role& one : file_roles)
    if (one.name == role) return read_text(std::string(machine) + element + one.before, source);
  for (const Role& one : other_roles)
    if (one.name == role) return read_text(std::string(machine) + one.before, source);
}

}  // namespace

void exercise(std::string_view input) {
  constexpr std::string_view mark = "#role ";
  const std::size_t end = input.find('\n');
  if (!input.starts_with(mark) || end == std::string_view::npos)
    return read_text(std::string(input), folder() / "project.toml");
  const std::string_view role = input.substr(mark.size(), end - mark.size());
  if (role == "project") return read_text(std::string(input.substr(end + 1)), folder() / "project.toml");
  read_file_in_role(role, input.substr(end + 1));
}

std::vector<std::string_view> roles() {
  std::vector<std::string_view> names = {"project", "matrix", "setting", "msh", "catalogue", "stl"};
  for (const Role& one : file_roles) names.push_back(one.name);
  for (const Role& one : other_roles) names.push_back(one.name);
  return names;
}

}  // namespace trivet::fuzz
