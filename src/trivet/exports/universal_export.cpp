// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/csv_field.h"
#include "trivet/exchange/universal/universal_writing.h"
#include "trivet/exports/format_table.h"
#include "trivet/exports/universal_model.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/analysis_commands.h"

/// Universal files: units, nodes, lines, modes (set 55), and the response as functions (set 58). In text, frequencies
/// have six digits: they are rounded first, and the results are computed there, so that every value is exact at the
/// frequency beside it. Node numbers and names are in NAME_nodes.csv.
namespace trivet::exports {
namespace {

using exchange::FunctionForm;
using exchange::UniversalFunctionType;
using exchange::UniversalQuantity;

/// Frequencies that the file can hold [Hz], each once.
std::vector<double> held_frequencies(const std::vector<double>& angular_frequency, FunctionForm form) {
  std::vector<double> hertz;
  for (const double omega : angular_frequency) {
    const double f = omega / foundation::two_pi;
    const double held =
        form == FunctionForm::ascii ? exchange::as_universal_abscissa(f) : static_cast<double>(static_cast<float>(f));
    if (hertz.empty() || held > hertz.back()) hertz.push_back(held);
  }
  return hertz;
}

/// Warns where six digits are coarser than a tenth of the width of a peak.
void warn_of_coarse_digits(const Content& content, const std::vector<double>& hertz, std::vector<std::string>& notes) {
  if (hertz.empty()) return;
  constexpr double share = 0.1, digits = 1e-5;  // of six digits: half a unit of the last is 5e-6 … 5e-5
  const model::System& system = content.variant.system;
  const modal::Roots roots = modal::roots(system);
  for (const modal::Root& root : roots.list) {
    if (!root.damped_angular_frequency || !root.damping_ratio || root.eigenvalue.imag() < 0) continue;
    const double f = *root.damped_angular_frequency / foundation::two_pi, width = 2 * *root.damping_ratio * f;
    const double step = digits * std::pow(10.0, std::floor(std::log10(f)));
    if (f < hertz.front() || f > hertz.back() || step <= share * width) continue;
    notes.push_back(
        fmt::format("six digits of frequency are {:.2g} Hz apart near the peak at {:.10g} Hz, which is {:.2g} "
                    "Hz wide: export it as universal_binary, or read the peak from `peaks`",
                    step, f, width));
  }
}

/// The response at frequencies [Hz], with the results and the quantity of the file.
study::CaseResults response_at(const Content& content, const std::vector<double>& hertz,
                               const foundation::Progress& progress) {
  project::Analyses request = study::analysis_command("response").request(content.variant);
  request.response->band.reset();
  request.response->at.clear();
  for (const double f : hertz) request.response->at.push_back(foundation::two_pi * f);
  request.limit_lines.clear();
  study::CaseResults results = study::case_results(content.variant, request, progress);
  if (!results.response)
    throw foundation::NotComputable(results.failures.empty() ? "response: none" : results.failures.front());
  return results;
}

/// The one force in one direction that excites the model, if there is no other excitation in its results.
struct SingleForce {
  exchange::UniversalPoint point;
  double amplitude = 0;
  bool moment = false;
};

std::optional<SingleForce> single_force(const Content& content, const UniversalGeometry& geometry) {
  const model::System& system = content.variant.system;
  std::optional<SingleForce> found;
  const std::vector<std::string> request =
      study::analysis_command("response").request(content.variant).response->selection.excitations;
  for (const model::Excitation& excitation : system.description().excitations) {
    if (!project::drives(excitation, project::Drive::harmonic)) continue;
    if (!request.empty() && std::ranges::find(request, excitation.name) == request.end()) continue;
    const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
    const model::Action& action = excitation.action;
    if (found || !harmonic || harmonic->power_of_frequency != 0 || !action.body || action.delay != 0)
      return std::nullopt;
    const model::Body& body = system.bodies()[*action.body];
    std::string place = action.at.isZero(0) ? body.name : "";
    for (const auto& point : body.points)
      if (point.at == action.at) place = body.name + "." + point.name;
    if (geometry.label(place) == 0 || !body.pose.rotation.isIdentity(0)) return std::nullopt;
    SingleForce force;
    for (int j = 0; j < 6; ++j) {
      const std::complex<double> amplitude = action.amplitude(j);
      if (amplitude == std::complex<double>(0)) continue;
      if (force.amplitude != 0 || amplitude.imag() != 0) return std::nullopt;
      force = {{"", geometry.label(place), j + 1}, amplitude.real(), j >= 3};
    }
    if (force.amplitude == 0) return std::nullopt;
    found = force;
  }
  return found;
}

/// Axis of a result with this unit. The type does not distinguish a force from a moment: the direction does, and the
/// label of the unit.
exchange::UniversalAxis axis_of(const std::string& unit) {
  std::string label = unit;
  if (const std::size_t square = label.find("²"); square != std::string::npos) label.replace(square, 2, "^2");
  if (unit == "m" || unit == "rad") return {UniversalQuantity::displacement, {}, "Displacement", label};
  if (unit == "m/s" || unit == "rad/s") return {UniversalQuantity::velocity, {}, "Velocity", label};
  if (unit == "m/s²" || unit == "rad/s²") return {UniversalQuantity::acceleration, {}, "Acceleration", label};
  if (unit == "N" || unit == "N m")
    return {UniversalQuantity::reaction_force, {}, unit == "N" ? "Force" : "Moment", label};
  return {UniversalQuantity::general, {}, "", label};
}

/// A text that fits; cut and noted once if it does not.
std::string fitting(const std::string& text, std::vector<std::string>& lost) {
  if (text.empty() || exchange::fits_universal_line(text)) return text;
  const std::string note = "cut to 80 characters, or without characters that the format does not know: " + text;
  if (std::ranges::find(lost, note) == lost.end()) lost.push_back(note);
  return foundation::shortened(text, exchange::universal_id_width);
}

std::vector<exchange::UniversalFunction> functions(const Content& content, const UniversalGeometry& geometry,
                                                   const std::vector<double>& hertz, FunctionForm form,
                                                   std::vector<std::string>& lost,
                                                   const foundation::Progress& progress) {
  const study::CaseResults results = response_at(content, hertz, progress);
  const std::optional<SingleForce> force = single_force(content, geometry);
  std::vector<exchange::UniversalFunction> all;
  for (const response::Curve& curve : results.response->curves.curves) {
    exchange::UniversalFunction function;
    function.ids[0] = fitting(curve.name, lost);
    function.ids[1] = fitting(content.words(), lost);
    function.type = force ? UniversalFunctionType::frequency_response : UniversalFunctionType::spectrum;
    function.identifier = static_cast<int>(all.size()) + 1;
    function.response = universal_point(geometry, curve.name);
    if (function.response.node == 0 && geometry.label(curve.name.substr(0, curve.name.rfind('.'))) != 0)
      lost.push_back(curve.name + ": its axis is not an axis of the ground, so it has no node and direction");
    if (force) function.reference = force->point;
    function.abscissa_axis = {UniversalQuantity::frequency, {}, "Frequency", "Hz"};
    function.numerator = axis_of(curve.unit);
    if (force)
      function.denominator = {
          UniversalQuantity::excitation_force, {}, force->moment ? "Moment" : "Force", force->moment ? "N m" : "N"};
    function.abscissa = hertz;
    const double scale = force ? 1 / force->amplitude : 1;
    for (const std::complex<double>& value : curve.value) function.values.push_back(scale * value);
    if (form == FunctionForm::binary) function.precision = exchange::UniversalPrecision::single_precision;
    all.push_back(std::move(function));
  }
  return all;
}

constexpr const char* nodes_header = "node,name,x [m],y [m],z [m]";

std::string nodes_csv(const UniversalGeometry& geometry) {
  std::string text = std::string(nodes_header) + "\n";
  for (std::size_t i = 0; i < geometry.nodes.size(); ++i) {
    const Eigen::Vector3d& at = geometry.nodes[i].position;
    text += fmt::format("{},{},{},{},{}\n", geometry.nodes[i].label, results::csv_field(geometry.places[i].name),
                        at.x(), at.y(), at.z());
  }
  return text;
}

std::vector<std::string> written_universal(const Content& content, const Target& target, FunctionForm form,
                                           const foundation::Progress& progress) {
  const model::System& system = content.variant.system;
  const UniversalGeometry geometry = universal_geometry(system);
  exchange::UniversalFile file;
  std::vector<std::string> notes;
  file.header.model = fitting(content.project.title.empty() ? content.words() : content.project.title, notes);
  file.header.description = fitting(content.words(), notes);
  file.header.program = "Trivet";
  file.nodes = geometry.nodes;
  file.lines = geometry.lines;
  if (const Group* modes = content.find("modes")) file.modes = universal_modes(system, geometry, modes->results->modes);
  if (const Group* response = content.find("response")) {
    const std::vector<double> hertz = held_frequencies(response->results->response->curves.angular_frequency, form);
    if (form == FunctionForm::ascii) warn_of_coarse_digits(content, hertz, notes);
    else notes.emplace_back("binary functions are single precision: values have seven digits");
    file.functions = functions(content, geometry, hertz, form, notes, progress);
  }
  write_bytes(target.side(), nodes_csv(geometry));
  write_bytes(target.path(), exchange::universal_text(file, form));
  return notes;
}

std::vector<std::string> write_universal(const Content& content, const Target& target,
                                         const foundation::Progress& progress) {
  return written_universal(content, target, FunctionForm::ascii, progress);
}
std::vector<std::string> write_universal_binary(const Content& content, const Target& target,
                                                const foundation::Progress& progress) {
  return written_universal(content, target, FunctionForm::binary, progress);
}

}  // namespace

const Format universal_format = {"universal",
                                 "universal file (.uff, .unv): nodes, lines, modes, functions as text",
                                 Target::Kind::file,
                                 {"modes", "response"},
                                 false,
                                 write_universal,
                                 {"_nodes.csv", nodes_header}};
const Format universal_binary_format = {"universal_binary",
                                        "the same with binary functions (set 58b)",
                                        Target::Kind::file,
                                        {"modes", "response"},
                                        false,
                                        write_universal_binary,
                                        {"_nodes.csv", nodes_header}};

}  // namespace trivet::exports
