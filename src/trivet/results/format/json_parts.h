// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "trivet/documents/json_text.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::results {
class MapColours;
}

/// JSON values of Trivet's data; shared by the single results and the result file.
namespace trivet::results::json {

[[nodiscard]] Json warnings(const foundation::Problems& problems);
/// Position of an end of an element: "on", "at", "in_ground", "axes_in_ground".
[[nodiscard]] Json end(const project::Case& variant, const model::End& end);
[[nodiscard]] Json response(const study::CaseResults& results);
/// A model of curves as rational functions: docs/json.md, "curves". @param found  with a model
[[nodiscard]] Json curve_model(const study::ResponseResult& found);
/// Name, unit, exact extrema and first phase of one of its curves.
[[nodiscard]] Json drawn_curve(const study::ResponseResult& found, std::size_t curve);
/// The response for drawing in a page: the curve model if there is one, instead of a long table.
[[nodiscard]] Json drawn_response(const study::CaseResults& results);
/// @param colours  of all maps that are shown with this one
[[nodiscard]] Json design_map(const study::DesignMap& map, const MapColours& colours);
[[nodiscard]] Json verdict(const study::CaseVerdict& judged);
/// Least and largest static values over all cases.
[[nodiscard]] Json envelope(const study::Envelope& envelope);

}  // namespace trivet::results::json
