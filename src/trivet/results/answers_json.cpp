// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/answers_json.h"

#include <algorithm>

#include "trivet/foundation/message_list.h"
#include "trivet/results/json_parts.h"

namespace trivet::results {
namespace json {
namespace {

Json body_names(const project::Case& variant) {
  Json names = Json::array();
  for (const auto& body : variant.system.bodies()) names.push_back(body.name);
  return names;
}

Json element_names(const project::Case& variant) {
  Json names = Json::array();
  for (const auto& element : variant.system.elements()) names.push_back(element.name);
  return names;
}

Json screws(const std::vector<spatial::Screw>& list_of_screws) {
  Json result = Json::array();
  for (const spatial::Screw& screw : list_of_screws) {
    Json one{{"direction", list(screw.direction)}, {"point", nullptr}, {"pitch", nullptr}, {"rotation", screw.rotation}};
    if (!screw.pure_translation) {
      one["point"] = list(screw.point);
      one["pitch"] = screw.pitch;
    }
    result.push_back(std::move(one));
  }
  return result;
}

Json mode(const modal::Mode& m) {
  constexpr double turn = 6.283185307179586;
  return {{"number", m.number},
          {"eigenvalue_squared", m.eigenvalue_squared},
          {"angular_frequency", optional(m.angular_frequency)},
          {"frequency_hz", m.angular_frequency ? Json(*m.angular_frequency / turn) : Json(nullptr)},
          {"modal_mass", m.modal_mass},
          {"repeated", m.repeated},
          {"shape", list(m.shape)},
          {"shape_at_center_of_mass", list(m.shape_at_centre)},
          {"kinetic_energy_share", list(m.kinetic_energy_share)},
          {"principal_kinetic_energy_share", list(m.principal_kinetic_energy_share)},
          {"element_kinetic_energy_share", list(m.element_kinetic_energy_share)},
          {"strain_energy_share", m.strain_energy_share ? list(*m.strain_energy_share) : Json(nullptr)},
          {"screws", screws(m.screws)},
          {"name", m.name}};
}

/// Real and imaginary parts in turn: half as many brackets as pairs.
template <typename Vector>
Json complex_list(const Vector& values) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    result.push_back(values(i).real());
    result.push_back(values(i).imag());
  }
  return result;
}

Json solution_checks(const study::ResponseAnswer& answer) {
  const auto& check = answer.curves.check;
  const auto& deep = answer.deep;
  return {{"worst_backward_error", check.worst_backward_error},
          {"at_angular_frequency", check.at_angular_frequency},
          {"pivoted_fallbacks", check.fallbacks},
          {"solves", answer.curves.solves},
          {"interpolation_error", answer.curves.interpolation_error},
          {"undefined_at", check.undefined_at},
          {"second_solver",
           {{"frequencies", deep.frequencies}, {"too_near_a_resonance", deep.incomparable}, {"worst_difference", number(deep.worst_difference)}, {"allowed", number(deep.allowed)},
            {"at_angular_frequency", deep.at_angular_frequency}, {"passed", deep.passed}}}};
}

}  // namespace

Json warnings(const foundation::Problems& problems) {
  Json result = Json::array();
  foundation::Problems warnings;
  for (const auto& problem : problems.list())
    if (problem.severity == foundation::Severity::warning) warnings.add(problem);
  const foundation::Problems first = foundation::listed(warnings);
  for (const auto& problem : first.list()) result.push_back(foundation::message(problem));
  if (const std::string rest = foundation::rest_of_list(warnings); !rest.empty()) result.push_back(rest);
  return result;
}

Json modes(const project::Case& variant, const study::Answers& answers) {
  Json result{{"bodies", body_names(variant)}, {"elements", element_names(variant)}, {"modes", Json::array()}, {"free_motions", answers.free_motions}, {"warnings", warnings(answers.warnings)}};
  for (const modal::Mode& m : answers.modes.list) result["modes"].push_back(mode(m));
  return result;
}

Json roots(const project::Case& variant, const study::Answers& answers) {
  Json result{{"bodies", body_names(variant)}, {"roots", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const modal::Root& root : answers.roots.list) {
    Json shape = Json::array();
    for (Eigen::Index i = 0; i < root.shape.size(); ++i) shape.push_back(complex_number(root.shape(i)));
    result["roots"].push_back({{"eigenvalue", complex_number(root.eigenvalue)},
                               {"kind", modal::name(root.kind)},
                               {"angular_frequency", optional(root.angular_frequency)},
                               {"damped_angular_frequency", optional(root.damped_angular_frequency)},
                               {"damping_ratio", optional(root.damping_ratio)},
                               {"exact", root.exact},
                               {"shape", std::move(shape)},
                               {"nearest_mode", optional(root.nearest_mode)}});
  }
  return result;
}

Json response(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  Json result{{"angular_frequency", answer.curves.angular_frequency}, {"results", Json::array()}, {"checks", solution_checks(answer)}, {"warnings", warnings(answers.warnings)}};
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
    const response::Curve& curve = answer.curves.curves[c];
    Json values = Json::array();
    for (Eigen::Index i = 0; i < curve.value.size(); ++i) values.push_back(complex_number(curve.value(i)));
    result["results"].push_back({{"name", curve.name}, {"unit", curve.unit}, {"complex", std::move(values)}, {"phase", list(answer.phase[c])}});
  }
  return result;
}

Json drawn_response(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  if (!answer.model) return response(answers);
  const response::CurveModel& model = *answer.model;
  Json result{{"band", {model.band.from, model.band.to}}, {"delays", model.delays}, {"pieces", Json::array()}, {"solves", model.solves}, {"tests", model.tests},
              {"worst_error", model.worst_error}, {"worst_error_at", model.worst_error_at}, {"continuous_phase", answer.continuous_phase},
              {"results", Json::array()}, {"checks", solution_checks(answer)}};
  for (const response::ModelPiece& piece : model.pieces) {
    Json values = Json::array();
    for (Eigen::Index row = 0; row < piece.fit.values.rows(); ++row) values.push_back(complex_list(piece.fit.values.row(row)));
    result["pieces"].push_back({{"band", {piece.band.from, piece.band.to}}, {"nodes", list(piece.fit.nodes)}, {"weights", complex_list(piece.fit.weights)}, {"values", std::move(values)}});
  }
  for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
    Json extrema = Json::array();
    for (const response::Extremum& extremum : answer.extrema[c]) extrema.push_back({extremum.angular_frequency, extremum.maximum ? Json(extremum.amplitude) : Json(nullptr)});
    const Eigen::VectorXd& phase = answer.phase[c];
    const auto first = std::find_if(phase.begin(), phase.end(), [](double angle) { return std::isfinite(angle); });
    result["results"].push_back({{"name", answer.curves.curves[c].name}, {"unit", answer.curves.curves[c].unit}, {"extrema", std::move(extrema)},
                                 {"first_phase", first == phase.end() ? Json(nullptr) : Json(*first)}});
  }
  return result;
}

Json peaks(const study::Answers& answers) {
  const response::Peaks& found = answers.peaks->peaks;
  Json result{{"peaks", Json::array()}, {"curves", Json::array()}, {"searched", {found.searched_from, json::number(found.searched_to)}}, {"min_prominence", answers.peaks->min_prominence},
              {"peak_tolerance", answers.peaks->peak_tolerance}, {"warnings", warnings(answers.warnings)}};
  for (const response::Peak& peak : found.list) {
    result["peaks"].push_back({{"name", found.curves[peak.curve].name},
                               {"unit", found.curves[peak.curve].unit},
                               {"angular_frequency", peak.angular_frequency},
                               {"amplitude", number(peak.amplitude)},
                               {"prominence", number(peak.prominence)},
                               {"relative_prominence", number(relative_prominence(peak))},
                               {"ratio_to_static", peak.ratio_to_static ? number(*peak.ratio_to_static) : Json(nullptr)},
                               {"nearest_mode", optional(peak.nearest_mode)},
                               {"unbounded", std::isinf(peak.amplitude)},
                               {"angular_frequency_uncertainty", peak.frequency_uncertainty},
                               {"amplitude_uncertainty", peak.amplitude_uncertainty},
                               {"method", response::method(found, peak)}});
  }
  for (const response::CurveSummary& curve : found.curves)
    result["curves"].push_back({{"name", curve.name},
                                {"unit", curve.unit},
                                {"peaks", curve.peaks},
                                {"static_amplitude", optional(curve.static_amplitude)},
                                {"highest", number(curve.highest)},
                                {"highest_at", number(curve.highest_at)},
                                {"vanishes", curve.vanishes}});
  return result;
}

Json statics(const study::Answers& answers) {
  Json result{{"results", Json::array()}, {"backward_error", answers.statics->backward_error}, {"warnings", warnings(answers.warnings)}};
  for (const response::StaticValue& value : answers.statics->values) result["results"].push_back({{"name", value.name}, {"unit", value.unit}, {"value", value.value}});
  return result;
}

}  // namespace json

std::string modes_json(const project::Case& variant, const study::Answers& answers) { return json::text(json::modes(variant, answers), 1) + "\n"; }
std::string roots_json(const project::Case& variant, const study::Answers& answers) { return json::text(json::roots(variant, answers), 1) + "\n"; }
std::string response_json(const study::Answers& answers) { return json::text(json::response(answers), 1) + "\n"; }
std::string peaks_json(const study::Answers& answers) { return json::text(json::peaks(answers), 1) + "\n"; }
std::string static_json(const study::Answers& answers) { return json::text(json::statics(answers), 1) + "\n"; }

}  // namespace trivet::results
