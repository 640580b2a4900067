// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/project/analyses/analysis_reader.h"

namespace trivet::project {
namespace {

constexpr double most_values = 3e6;      // points × curves; with tables, page and figures each takes about 350 bytes
constexpr double longest_search = 3600;  // [s]
constexpr std::size_t most_inputs =
    100;  // correlated random inputs: every pair has a cross-spectrum with every channel

/// Time of searches on one core, measured on chains of 10 to 300 bodies; those held at one end only take longest. With
/// frequency-dependent elements (some ten bodies) every sample of a search is a solution of its own.
double seconds_of_peaks(double curves, double coordinates, bool frequency_dependent) {
  if (frequency_dependent) return curves * (0.003 + 0.07 * std::pow(coordinates / 60, 3.7));
  return 7.5e-9 * std::pow(coordinates, 3) + 3e-4 * coordinates * curves;
}
/// With the rational model of an automatic spacing, which has as many pieces as there are resonances.
double seconds_of_curves(double curves, double coordinates, bool frequency_dependent) {
  return seconds_of_peaks(curves, coordinates, frequency_dependent) + 2.5e-6 * curves * coordinates * coordinates;
}

bool is_component(const std::string& word) {
  const std::size_t dot = word.rfind('.');
  if (dot == std::string::npos) return false;
  const std::string last = word.substr(dot + 1);
  const auto is_one_of = [&](const auto& names) { return std::ranges::find(names, last) != names.end(); };
  return is_one_of(model::coordinate_names) || is_one_of(model::relative_components) ||
      last == model::approach_component;
}

class Sizes {
 public:
  Sizes(const model::Description& description) : free_(0), all_(static_cast<double>(coordinates(description))) {
    for (const model::Body& body : description.bodies)
      free_ += static_cast<double>(std::ranges::count(body.free, true));
    frequency_dependent_ = std::ranges::any_of(description.elements, [](const model::Element& element) {
      return elements::is_frequency_dependent(element.law);
    });
  }

  [[nodiscard]] double curves(const std::vector<std::string>& of) const {
    double count = 0;
    for (const std::string& word : of) count += word == "coordinates" ? free_ : is_component(word) ? 1 : 6;
    return count;
  }

  void check_curves(const std::string& analysis, double count) {
    if (count > static_cast<double>(most_curves))
      problems.error(analysis, fmt::format("{:.0f} curves", count),
                     fmt::format("at most {} are computed for one analysis", most_curves),
                     "name fewer results in " + analysis + ".of");
  }

  void check_coordinates(const std::string& analysis) {
    if (all_ > static_cast<double>(most_coordinates_of_others))
      problems.error(analysis, fmt::format("{:.0f} free coordinates", all_),
                     fmt::format("at most {} (a hundred free bodies) are computed for this analysis; modes, roots, "
                                 "static, response, peaks and transient take {}",
                                 most_coordinates_of_others, most_coordinates),
                     "constrain bodies by `free`, or split the model");
  }

  /// @param modelled  the curves are also drawn from a rational model
  void check_search(const std::string& analysis, double count, bool modelled = false) {
    check_curves(analysis, count);
    const auto estimate = modelled ? seconds_of_curves : seconds_of_peaks;
    if (const double seconds = estimate(count, all_, frequency_dependent_);
        count <= static_cast<double>(most_curves) && seconds > longest_search)
      problems.error(
          analysis,
          fmt::format(
              "resonance peaks of {:.0f} curves of a system of {:.0f} coordinates: about {:.2g} hours of search", count,
              all_, seconds / 3600),
          fmt::format("at most {:.0f} hour is allowed", longest_search / 3600),
          "name fewer results in `of`, constrain bodies by `free`, or split the model");
  }

  void check_values(const std::string& analysis, double points, double count) {
    if (points * count > most_values)
      problems.error(analysis,
                     fmt::format("{:.0f} points × {:.0f} curves = {:.3g} values", points, count, points * count),
                     fmt::format("at most {:.0e} values are computed at once", most_values),
                     "take fewer points or fewer results; an automatic spacing needs a few hundred points");
  }

  foundation::Problems problems;

 private:
  double free_, all_;
  bool frequency_dependent_ = false;
};

void check_response(Sizes& sizes, const ResponseRequest& request) {
  const double count = sizes.curves(request.selection.of);
  const bool searched = request.continuous_phase || (request.at.empty() && request.spacing == Spacing::automatic);
  if (searched) sizes.check_search("analyses.response", count, request.at.empty());
  else sizes.check_curves("analyses.response", count);
  if (!request.at.empty()) sizes.check_values("analyses.response.at", static_cast<double>(request.at.size()), count);
  else if (request.spacing != Spacing::automatic) sizes.check_values("analyses.response.points", request.points, count);
}

void check_bands(Sizes& sizes, const SampleRequest& request, const ResponseRequest& response) {
  const double count = sizes.curves(request.bands),
               points = response.at.empty() ? request.band_points : static_cast<double>(response.at.size());
  if (points * count > most_band_values)
    sizes.problems.error(
        "analyses.sample.bands",
        fmt::format("{:.0f} frequencies × {:.0f} results = {:.0f} distributions", points, count, points * count),
        fmt::format("a case counts at most {:.0f}", most_band_values), "name fewer results, or give fewer band_points");
}

void check_inputs(Sizes& sizes, const model::Description& description) {
  std::size_t together = 0;
  for (const model::Excitation& excitation : description.excitations)
    if (const auto* random = std::get_if<model::Random>(&excitation.course); random && !random->partners.empty())
      ++together;
  if (together > most_inputs)
    sizes.problems.error("excitations", fmt::format("{} random excitations with a coherence", together),
                         fmt::format("at most {} may be correlated", most_inputs),
                         "combine neighbouring ones, or make them uncorrelated");
}

}  // namespace

std::size_t coordinates(const model::Description& description, bool with_laws) {
  std::size_t count = 0;
  for (const model::Body& body : description.bodies) count += to_size(std::ranges::count(body.free, true));
  for (const model::Element& element : description.elements)
    if (with_laws || !elements::is_frequency_dependent(element.law))
      count += to_size(elements::matrices(element.law).stiffness.rows() - 12);  // of its inner coordinates
  for (const model::Foundation& foundation : description.foundations) count += to_size(foundation.mass.rows());
  return count;
}

bool lowest_modes_suffice(const Analyses& request) {
  const bool at_given_frequencies = !request.response ||
      (!request.response->continuous_phase &&
       (!request.response->at.empty() || (request.response->band && request.response->spacing != Spacing::automatic)));
  return request.lowest_modes > 0 && at_given_frequencies && !request.roots && !request.peaks && !request.static_of &&
      !request.load_sharing && !request.map && request.limit_lines.empty() && request.measurements.empty() &&
      request.limits.empty() && !request.requirements && independent_analyses(request).empty();
}

foundation::Problems too_large(const model::Description& description, const Analyses& request) {
  Sizes sizes(description);
  const bool lowest = lowest_modes_suffice(request);
  if (const std::size_t count = coordinates(description),
      most = lowest ? most_coordinates_of_lowest_modes : most_coordinates;
      count > most) {
    sizes.problems.error(
        "bodies", fmt::format("{} free coordinates", count),
        lowest ? fmt::format("at most {} are computed: a thousand free bodies", most)
               : fmt::format("at most {} are computed: three hundred free bodies; {} with modes = {{lowest = 20}}, and "
                             "with a response at given "
                             "frequencies (band, points, spacing)",
                             most, most_coordinates_of_lowest_modes),
        "constrain bodies by `free` where they cannot move, join bodies that move together, or split the model");
    return sizes.problems;
  }
  if (const std::size_t count = coordinates(description, true);
      count > most_with_laws && count > coordinates(description)) {
    sizes.problems.error(
        "elements", fmt::format("{} coordinates with those of their laws", count),
        fmt::format("at most {} are computed; a fractional law adds 21 for each direction", most_with_laws),
        "take kelvin_voigt, zener or maxwell laws for some elements, or split the model");
    return sizes.problems;
  }
  check_inputs(sizes, description);
  if (request.response) check_response(sizes, *request.response);
  if (request.sample && request.response) check_bands(sizes, *request.sample, *request.response);
  if (request.peaks) sizes.check_search("analyses.peaks", sizes.curves(request.peaks->selection.of));
  if (request.static_of) sizes.check_curves("analyses.static", sizes.curves(*request.static_of));
  for (const AnalysisReader& reader : analysis_readers()) {
    const Analysis* analysis = reader.of(request);
    if (!analysis) continue;
    const double count = reader.curves ? reader.curves(request) : sizes.curves(analysis->selection.of);
    const std::string subject = table_path(reader.name);
    if (!reader.of_large_systems) sizes.check_coordinates(subject);
    if (reader.searches_peaks) sizes.check_search(subject, count);
    else sizes.check_curves(subject, count);
  }
  if (!request.limits.empty()) sizes.check_search("limits", static_cast<double>(request.limits.size()));
  if (request.requirements)
    sizes.check_search(
        "requirements",
        sizes.curves(request.requirements->no_peak) + static_cast<double>(request.requirements->limits.size()));
  if (!request.limit_lines.empty()) sizes.check_search("limit_lines", static_cast<double>(request.limit_lines.size()));
  double measured = 0;
  for (const auto& measurement : request.measurements) measured += static_cast<double>(measurement->curves.size());
  if (measured > 0) sizes.check_search("measurements", measured);
  return sizes.problems;
}

int deep_check_frequencies(Eigen::Index coordinates) {
  constexpr int most = 64, fewest = 4;
  // Coordinates of a fully coupled system that is solved in a quarter of a millisecond; the work grows with the third
  // power. (Chains need less; their number of frequencies is the same.)
  constexpr double quick = 36;
  return std::clamp(
      static_cast<int>(most * std::pow(quick / static_cast<double>(std::max<Eigen::Index>(coordinates, 1)), 3)), fewest,
      most);
}

}  // namespace trivet::project
