// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/results/format/json_parts.h"

namespace trivet::results::json {
namespace {

/// Real and imaginary parts alternating in one list, which is shorter than a list of pairs.
template <typename Vector>
Json complex_list(const Vector& values) {
  NumberList result;
  for (const std::complex<double>& value : values) {
    result.add(value.real());
    result.add(value.imag());
  }
  return std::move(result).json();
}

}  // namespace

Json curve_model(const study::ResponseResult& found) {
  const response::CurveModel& model = *found.model;
  Json result{{"delays", model.delays}, {"pieces", Json::array()}};
  for (const response::ModelPiece& piece : model.pieces) {
    Json values = Json::array();
    for (Eigen::Index row = 0; row < piece.fit.values.rows(); ++row)
      values.push_back(complex_list(piece.fit.values.row(row)));
    result["pieces"].push_back({{"band", {piece.band.from, piece.band.to}},
                                {"nodes", list(piece.fit.nodes)},
                                {"weights", complex_list(piece.fit.weights)},
                                {"values", std::move(values)}});
  }
  result["continuous_phase"] = found.continuous_phase;
  result["undefined_at"] = found.curves.check.undefined_at;
  return result;
}

Json drawn_curve(const study::ResponseResult& found, std::size_t curve) {
  Json extrema = Json::array();
  for (const response::Extremum& extremum : found.extrema[curve])
    extrema.push_back({extremum.angular_frequency, extremum.maximum ? Json(extremum.amplitude) : Json(nullptr)});
  const Eigen::VectorXd& phase = found.phase[curve];
  const auto first = std::ranges::find_if(phase, [](double angle) { return std::isfinite(angle); });
  return {{"name", found.curves.curves[curve].name},
          {"unit", found.curves.curves[curve].unit},
          {"extrema", std::move(extrema)},
          {"first_phase", first == phase.end() ? Json(nullptr) : Json(*first)}};
}

Json drawn_response(const study::CaseResults& results) {
  const study::ResponseResult& found = *results.response;
  if (!found.model) return response(results);
  Json result{{"band", {found.model->band.from, found.model->band.to}}};
  result.update(curve_model(found));
  result["results"] = Json::array();
  for (std::size_t c = 0; c < found.curves.curves.size(); ++c) result["results"].push_back(drawn_curve(found, c));
  return result;
}

}  // namespace trivet::results::json
