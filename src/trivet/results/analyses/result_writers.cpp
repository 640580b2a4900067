// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/message_list.h"
#include "trivet/results/design/map_document.h"
#include "trivet/results/design/map_json.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/results/format/written_results.h"

namespace trivet::results {
namespace json {

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

Json curve(const response::Curve& c) { return {{"name", c.name}, {"unit", c.unit}, {"complex", list(c.value)}}; }

Json curves(const std::vector<response::Curve>& list) {
  Json result = Json::array();
  for (const response::Curve& one : list) result.push_back(curve(one));
  return result;
}

}  // namespace json

namespace {

/// The map as one of the results of a run; the command `map` writes it with its own options.
const ResultWriter map_results = {
    .has_result = [](const project::Case&,
                     const study::CaseResults& results) { return results.map || !results.map_pairs.empty(); },
    .document =
        [](const project::Case&, const study::CaseResults& results) {
          return results.map ? map_document(*results.map) : map_pairs_document(results.map_pairs);
        },
    .json = [](const project::Case&, const study::CaseResults& results) -> json::Json {
      if (results.map) return json::design_map(*results.map, MapColours({&*results.map, 1}));
      json::Json pairs = json::Json::array();
      const MapColours colours(results.map_pairs);
      for (const study::DesignMap& map : results.map_pairs) pairs.push_back(json::design_map(map, colours));
      return {{"pairs", pairs}};
    },
    .tables = {{"map.csv",
                [](const project::Case&, const study::CaseResults& results) {
                  return results.map ? map_csv(*results.map) : map_pairs_csv(results.map_pairs);
                }}},
    .arrays =
        [](const project::Case&, const study::CaseResults& results, LabelledArrays& list) {
          if (results.map) add_map_arrays(*results.map, "", list);
          for (std::size_t k = 0; k < results.map_pairs.size(); ++k)
            add_map_arrays(results.map_pairs[k], fmt::format("pair{}.", k + 1), list);
        },
};

}  // namespace

namespace {

template <auto field>
ResultWriter of_field(const char* name, ResultWriter writer) {
  writer.has_result = [](const project::Case&, const study::CaseResults& results) {
    return (results.*field).has_value();
  };
  return project::named(name, std::move(writer));
}

std::vector<ResultWriter> with_tables(std::vector<ResultWriter> list) {
  for (ResultWriter& writer : list) {
    const auto add = [&writer](const char* file, bool (*is_in)(const study::CaseResults&)) {
      writer.tables.push_back(
          {file,
           [document = writer.document, file](const project::Case& variant, const study::CaseResults& results) {
             return as_csv(document(variant, results), file);
           },
           is_in});
    };
    for (const char* file : writer.files) add(file, nullptr);
    if (writer.optional_file.name) add(writer.optional_file.name, writer.optional_file.is_in);
  }
  return list;
}

}  // namespace

const std::vector<ResultWriter>& result_writers() {
#define TRIVET_WRITER(name) project::named(#name, name##_results),
#define TRIVET_OWN_WRITER(name) of_field<&study::CaseResults::name>(#name, name##_results),
  static const std::vector<ResultWriter> list = with_tables(
      {TRIVET_WRITER(modes) TRIVET_WRITER(roots) TRIVET_WRITER(response) TRIVET_WRITER(peaks) TRIVET_WRITER(static)
           TRIVET_ANALYSES(TRIVET_OWN_WRITER) TRIVET_WRITER(limit_lines) TRIVET_WRITER(measurements) TRIVET_WRITER(map)
               TRIVET_WRITER(optimize) TRIVET_WRITER(sample) TRIVET_WRITER(load_sharing)});
#undef TRIVET_OWN_WRITER
#undef TRIVET_WRITER
  return list;
}

json::Json written_json(const ResultWriter& writer, const project::Case& variant, const study::CaseResults& results) {
  return writer.json ? writer.json(variant, results) : as_json(writer.document(variant, results));
}

std::string written_text(const ResultWriter& writer, const project::Case& variant, const study::CaseResults& results,
                         Form form) {
  return as_text(writer.document(variant, results), variant.display, form);
}

Single warnings_part(const study::CaseResults& results) {
  return {.name = "warnings", .value = json::warnings(results.warnings)};
}

namespace {

const ResultWriter& writer_of(const std::string& analysis) {
  const auto& list = result_writers();
  const auto found = std::ranges::find(list, analysis, &ResultWriter::name);
  if (found == list.end()) throw foundation::InvalidInput("no result is called \"" + analysis + "\"");
  return *found;
}

}  // namespace

std::string result_json(const std::string& analysis, const project::Case& variant, const study::CaseResults& results) {
  return json::text(written_json(writer_of(analysis), variant, results), 1) + "\n";
}

std::string result_csv(const std::string& analysis, const project::Case& variant, const study::CaseResults& results) {
  return writer_of(analysis).tables.front().csv(variant, results);
}

std::string result_text(const std::string& analysis, const project::Case& variant, const study::CaseResults& results) {
  return written_text(writer_of(analysis), variant, results, on_screen);
}

Document result_document(const std::string& analysis, const project::Case& variant, const study::CaseResults& results) {
  return writer_of(analysis).document(variant, results);
}

std::string result_html(const std::string& analysis, const project::Case& variant, const study::CaseResults& results) {
  const ResultWriter& writer = writer_of(analysis);
  return writer.is_there(variant, results) ? as_html(writer.document(variant, results), variant.display) : "";
}

const std::vector<ResultTable>& result_tables(const std::string& analysis) { return writer_of(analysis).tables; }

LabelledArrays result_arrays(const std::string& analysis, const project::Case& variant,
                             const study::CaseResults& results) {
  LabelledArrays list;
  const ResultWriter& writer = writer_of(analysis);
  if (writer.arrays) writer.arrays(variant, results, list);
  else add_arrays(writer.document(variant, results), list);
  return list;
}

std::vector<ResultFile> result_files(const project::Case& variant, const study::CaseResults& results) {
  std::vector<ResultFile> files;
  for (const ResultWriter& writer : result_writers())
    if (writer.is_there(variant, results))
      for (const ResultTable& table : writer.tables)
        if (!table.is_in || table.is_in(results)) files.push_back({table.file, table.csv(variant, results)});
  return files;
}

std::string results_summary(const project::Case& variant, const study::CaseResults& results, std::size_t width) {
  std::string text;
  for (const ResultWriter& writer : result_writers()) {
    if (!writer.is_there(variant, results)) continue;
    const std::string one = as_text(writer.document(variant, results), variant.display, in_summary, width);
    if (!one.empty()) text += one + "\n";
  }
  return text;
}

}  // namespace trivet::results
