// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "trivet/documents/document.h"
#include "trivet/documents/labelled_arrays.h"
#include "trivet/foundation/hertz.h"
#include "trivet/project/analyses/analysis_table.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/format/written_results.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// Writes the result of one analysis. Each is defined in NAME_document.cpp.
struct ResultWriter {
  const char* name = nullptr;  ///< name of the analysis in [analyses], of its command and of its key in results.json;
                               ///< set by result_writers()
  /// Those of project/analyses/analysis_table.h leave it to result_writers(): their field is there.
  bool (*has_result)(const project::Case& variant, const study::CaseResults& results) = nullptr;
  /// The result described once.
  Document (*document)(const project::Case& variant, const study::CaseResults& results) = nullptr;
  std::vector<const char*> files = {};  ///< of the tables and curves of `document`, for `tables`
  /// One more table, that only some results have.
  struct OptionalFile {
    const char* name = nullptr;
    bool (*is_in)(const study::CaseResults& results) = nullptr;
  };
  OptionalFile optional_file = {};
  json::Json (*json)(const project::Case& variant,
                     const study::CaseResults& results) = nullptr;  ///< nullptr: that of `document`
  std::vector<ResultTable> tables = {};  ///< tables of the result folder; --csv prints the first one
  /// Its numbers; nullptr: those of `document`. A list of rows has an axis, "peak"; a curve is an array over its
  /// frequencies with its own name. Names are unique, and an axis has the same size in all arrays.
  void (*arrays)(const project::Case& variant, const study::CaseResults& results, LabelledArrays& list) = nullptr;

  [[nodiscard]] bool is_there(const project::Case& variant, const study::CaseResults& results) const {
    return has_result(variant, results);
  }
};

/// The result in one form, from its document if it has one.
[[nodiscard]] json::Json written_json(const ResultWriter& writer, const project::Case& variant,
                                      const study::CaseResults& results);
[[nodiscard]] std::string written_text(const ResultWriter& writer, const project::Case& variant,
                                       const study::CaseResults& results, Form form);

/// "warnings" in JSON.
[[nodiscard]] Single warnings_part(const study::CaseResults& results);
/// Names of the excitations that act together in an analysis.
[[nodiscard]] std::vector<std::string> excited_names(const project::Case& variant, const std::string& analysis);
/// The excitations that act together, if there are several; not in summaries.
[[nodiscard]] Sentence excited_part(const project::Case& variant, const std::string& analysis);
[[nodiscard]] Sentence excited_part(const std::vector<std::string>& names);

extern const ResultWriter modes_results, roots_results, response_results, peaks_results, static_results,
    limit_lines_results, measurements_results, optimize_results, sample_results, load_sharing_results;
#define TRIVET_WRITER(name) extern const ResultWriter name##_results;
TRIVET_ANALYSES(TRIVET_WRITER)
#undef TRIVET_WRITER

/// All of them with their names, in the order of the result file.
[[nodiscard]] const std::vector<ResultWriter>& result_writers();

using foundation::hertz;
/// Units of the translations and rotations in a shape: those of a mass-normalized mode, or of a root, whose largest
/// translation is 1.
struct ShapeUnits {
  const char *translation, *rotation;
};
/// The axis "coordinate" of shapes: names and units of the six coordinates of each body.
[[nodiscard]] std::vector<std::string> shape_coordinates(const project::Case& variant);
void add_shape_coordinates(const project::Case& variant, const ShapeUnits& shape, Document& document);
/// Names of the ends on flexible foundations, in the order of the elements; nothing without foundations.
void add_feet(const project::Case& variant, Document& document);
template <typename Named>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& one : list) names.push_back(one.name);
  return names;
}
/// The axis "coordinate" of one motion: x … rz in metres and radians.
void add_motion_coordinates(Document& document);
/// The limit lines, also part of the response.
[[nodiscard]] Table limit_line_table(const study::CaseResults& results, const project::DisplayUnits& display);
/// The table of loads, as part of the static results on the screen, if it was requested.
void add_load_sharing(const project::Case& variant, const study::CaseResults& results, Document& document);
/// Unit of the numbers on an axis; "1" if they have none, or if it is not known.
[[nodiscard]] std::string array_unit(const project::DesignAxis& axis);
/// @param before  begins the name of every array and axis: "pair1."
void add_map_arrays(const study::DesignMap& map, const std::string& before, LabelledArrays& list);

namespace json {
/// A curve with its complex values, and a list of curves.
[[nodiscard]] Json curve(const response::Curve& c);
[[nodiscard]] Json curves(const std::vector<response::Curve>& list);
}  // namespace json

}  // namespace trivet::results
