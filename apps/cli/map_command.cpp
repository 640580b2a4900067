// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/strictness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/report/map_figure.h"
#include "trivet/results/map_json.h"
#include "trivet/results/map_text.h"
#include "trivet/study/answers.h"

namespace trivet::cli {
namespace {

/// Numbers of points from "1000x1000", or one number for both axes.
study::MapOptions sizes(const std::string& text) {
  study::MapOptions options;
  if (text.empty()) return options;
  const auto whole = [&](const std::string& part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value < 2)
      throw BadArgument(fmt::format(
          "--points {}: give the points of both axes as in 200x150, or one number for both, each 2 or more", text));
    return value;
  };
  const std::size_t cross = text.find('x');
  options.nx = whole(text.substr(0, cross));
  options.ny = cross == std::string::npos ? options.nx : whole(text.substr(cross + 1));
  if (static_cast<double>(options.nx) * options.ny > project::most_designs)
    throw BadArgument(fmt::format("--points {}: {:.3g} designs; a map has at most {:.0e}; take fewer points", text,
                                  static_cast<double>(options.nx) * options.ny, project::most_designs));
  return options;
}

/// Warnings that concern every answer of this model.
foundation::Problems model_warnings(const project::Case& variant) {
  project::Analyses asked;
  asked.map = variant.analyses.map;
  return study::answers(variant, asked).warnings;
}

const results::TextSink to_output = [](std::string_view piece) { write_output(std::string(piece)); };

void write_map(const study::DesignMap& map, const foundation::Problems& warnings, const Options& options) {
  if (options.json) results::write_map_json(map, warnings, to_output);
  else if (options.csv) results::write_map_csv(map, to_output);
  else write_output(results::map_text(map));
}

void write_pairs(const std::vector<study::DesignMap>& maps, const foundation::Problems& warnings,
                 const Options& options) {
  if (options.json) results::write_map_pairs_json(maps, warnings, to_output);
  else if (options.csv) results::write_map_pairs_csv(maps, to_output);
  else write_output(results::map_pairs_text(maps));
}

}  // namespace

int map_command(const Options& options) {
  const auto project = read_or_complain(options,
                                        questions_of(options,
                                                     {"map", "parameters", "requirements", "clearances", "limit_lines",
                                                      "response", "peaks", "limits", "random", "transient"}));
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    if (!variant.analyses.map)
      throw BadArgument(
          "map: none given; add map = {x = {parameter = \"elements.mount.scale\", from = 0.5, to = 2}, y = {…}, "
          "no_peak = \"coordinates\"} to [analyses]");
    const study::MapOptions map_options = sizes(options.points);
    const std::unique_ptr<results::PictureFile> picture = new_picture(options);
    const project::MapRequest& request = *variant.analyses.map;
    std::vector<study::DesignMap> maps = study::design_maps(*project, variant, request, map_options, progress());
    const bool pairs = !maps.empty();
    if (!pairs) maps.push_back(study::design_map(*project, variant, request, map_options, progress()));
    foundation::Problems warnings = model_warnings(variant);
    for (const study::DesignMap& map : maps) warnings.add(map.warnings);
    if (pairs) warnings.sort_by_origin();  // and drop what several maps repeat
    if (!options.json) write_problems(warnings);
    if (pairs) write_pairs(maps, warnings, options);
    else write_map(maps.front(), warnings, options);
    if (picture)
      picture->publish(
          (pairs ? report::map_matrix_figure(maps, project->title) : report::map_figure(maps.front(), project->title))
              .svg);
    Strictness strictness;
    for (const study::DesignMap& map : maps) strictness.add(map);
    strictness.add(warnings);
    return strictness.exit_code(options.strict, done);
  } catch (const BadArgument& bad) {
    write_failure(bad);
    return wrong_input;
  }
}

}  // namespace trivet::cli
