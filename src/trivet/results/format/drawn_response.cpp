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

Json drawn_response(const study::CaseResults& results) {
  const study::ResponseResult& found = *results.response;
  if (!found.model) return response(results);
  const response::CurveModel& model = *found.model;
  Json result{{"band", {model.band.from, model.band.to}},
              {"delays", model.delays},
              {"pieces", Json::array()},
              {"continuous_phase", found.continuous_phase},
              {"undefined_at", found.curves.check.undefined_at},
              {"results", Json::array()}};
  for (const response::ModelPiece& piece : model.pieces) {
    Json values = Json::array();
    for (Eigen::Index row = 0; row < piece.fit.values.rows(); ++row)
      values.push_back(complex_list(piece.fit.values.row(row)));
    result["pieces"].push_back({{"band", {piece.band.from, piece.band.to}},
                                {"nodes", list(piece.fit.nodes)},
                                {"weights", complex_list(piece.fit.weights)},
                                {"values", std::move(values)}});
  }
  for (std::size_t c = 0; c < found.curves.curves.size(); ++c) {
    Json extrema = Json::array();
    for (const response::Extremum& extremum : found.extrema[c])
      extrema.push_back({extremum.angular_frequency, extremum.maximum ? Json(extremum.amplitude) : Json(nullptr)});
    const Eigen::VectorXd& phase = found.phase[c];
    const auto first = std::ranges::find_if(phase, [](double angle) { return std::isfinite(angle); });
    result["results"].push_back({{"name", found.curves.curves[c].name},
                                 {"unit", found.curves.curves[c].unit},
                                 {"extrema", std::move(extrema)},
                                 {"first_phase", first == phase.end() ? Json(nullptr) : Json(*first)}});
  }
  return result;
}

}  // namespace trivet::results::json
