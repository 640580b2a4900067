// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/measurements_reader.h"
#include "trivet/project/measured/universal_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/measured/measured_axes.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/measured/measured_places.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_measurements = 100;

/// A function of the file and the result that it measures.
struct MatchedFunction {
  const MeasuredFunction* function = nullptr;
  std::string result;
  double sign = 1;
};

/// Reads one table of [measurements].
class MeasurementTable {
 public:
  MeasurementTable(TableReader& reader, const model::Description& description, const SymbolTable& symbols,
                   const ResponseRequest& response)
      : reader_(reader), description_(description), in_file_(symbols), names_(symbols), response_(response) {}

  std::optional<Measurement> read(const std::string& name) {
    const std::size_t before = reader_.errors();
    Measurement result{.name = name};
    const auto path = read_file_name(reader_, "file");
    const auto units = read_given_units(reader_);
    const bool with_coherence = reader_.boolean("coherence").value_or(false);
    reader_.also_known({"nodes", "channels", "force"});
    if (!path || !units || reader_.errors() > before) return std::nullopt;
    units_ = *units;
    result.file = reader_.text("file").value_or("");
    const auto file = read_measured_file(*path, units_, with_coherence);
    reader_.add_of_file("file", file ? file->warnings : file.error());
    if (!file) return std::nullopt;
    if (file->functions.empty() && file->modes.empty())
      reader_.error("file", "neither functions nor modes",
                    "a measurement has functions over frequency (set 58, types 0, 4, 12) or modes (set 55)",
                    "choose another file");
    MeasuredPlaces places(description_, file->nodes, file->axes);
    read_nodes(places);
    report_systems(*file, places);
    if (reader_.errors() > before) return std::nullopt;
    const std::vector<MatchedFunction> matched = read_matches(*file, places);
    add_modes(*file, places, result);
    if (reader_.errors() == before && matched.empty() && result.modes.empty()) report_no_match(*file, places);
    add_curves(matched, places, result);
    if (reader_.errors() == before) reader_.add_of_file("file", file->idle_units);
    if (reader_.errors() > before) return std::nullopt;
    check_band(result);
    for (const MeasuredCurve& curve : result.curves) check_coherence(curve);
    return reader_.errors() > before ? std::nullopt : std::optional(std::move(result));
  }

 private:
  void read_nodes(MeasuredPlaces& places) {
    const Node* table = reader_.table("nodes");
    if (!table) return;
    TableReader nodes(*table, reader_.path() + ".nodes", reader_.problems());
    for (const std::string& key : table->keys) {
      const auto place = nodes.text(key);
      const auto node = node_number(key);
      if (!node)
        nodes.error(key, foundation::quoted(key), "the key is the number of a node of the file", "for instance \"3\"");
      else if (place && !places.put(*node, *place) && !in_file_.bodies_unknown) {
        const std::string guess = foundation::nearest_name(*place, places.names());
        nodes.error(key, foundation::quoted(*place), "a place is a body, BODY.POINT or a node of the model",
                    guess.empty() ? "known are: " + foundation::comma_separated(places.names())
                                  : "did you mean \"" + guess + "\"?");
      }
    }
  }

  /// Reports nodes in coordinate systems: those without a place, and the directions of those with one.
  void report_systems(const MeasuredFile& file, const MeasuredPlaces& places) {
    std::vector<exchange::UniversalNode> placed, unplaced;
    for (const exchange::UniversalNode& node : file.nodes_in_systems)
      (places.is_put(node.label) ? placed : unplaced).push_back(node);
    reader_.add_of_file("file", judge_positions(unplaced));
    reader_.add_of_file("file", judge_directions(placed));
  }

  [[nodiscard]] bool is_result(const std::string& name) const {
    return names_.component(name, response_.selection.quantity).has_value() && !names_.is_guided(name);
  }

  /// `channels` if it is given; otherwise all functions by their nodes, names or positions.
  std::vector<MatchedFunction> read_matches(const MeasuredFile& file, const MeasuredPlaces& places) {
    std::vector<MatchedFunction> matched;
    if (const Node* table = reader_.table("channels")) {
      TableReader channels(*table, reader_.path() + ".channels", reader_.problems());
      for (const std::string& result : table->keys) add_channel(channels, result, file, matched);
      return matched;
    }
    std::vector<std::string> unmatched;
    for (const MeasuredFunction& function : file.functions) {
      if (const auto match = match_of(function, places)) matched.push_back(*match);
      else unmatched.push_back(function.name);
    }
    if (!matched.empty() && !unmatched.empty())
      reader_.problems()
          .warning(reader_.path(),
                   fmt::format("{} of {} functions: {}", unmatched.size(), file.functions.size(),
                               foundation::comma_separated(unmatched)),
                   "they belong to no place of the model, or not along an axis of its body",
                   "they are ignored; `nodes` or `channels` gives them a place")
          .origin = reader_.node("file")->origin;
    return matched;
  }

  void add_channel(TableReader& channels, const std::string& result, const MeasuredFile& file,
                   std::vector<MatchedFunction>& matched) {
    const auto source = channels.text(result);
    if (!is_result(result)) {
      channels.error(result, "no such result", "the key is one component: \"BODY.x\", \"BODY.POINT.rz\"",
                     "check the name");
      return;
    }
    if (!source) return;
    std::vector<std::string> known;
    for (const MeasuredFunction& function : file.functions) {
      const auto& texts = function.texts;
      const bool by_text = std::ranges::find(texts, *source) != texts.end();
      exchange::UniversalPoint turned = function.response;
      turned.direction = -turned.direction;
      const bool opposite = function.response.node != 0 && point_name(turned) == *source;
      if (by_text || function.name == *source || opposite) {
        matched.push_back({&function, result, opposite ? -1.0 : 1.0});
        if (!reads_force()) return;
      }
      known.push_back(function.name);
    }
    if (!matched.empty() && matched.back().result == result) return;
    channels.error(result, foundation::quoted(*source), "no function of the file has this name, node and direction",
                   "the file has: " + foundation::comma_separated(known));
  }

  [[nodiscard]] bool reads_force() const { return reader_.has("force"); }

  std::optional<MatchedFunction> match_of(const MeasuredFunction& function, const MeasuredPlaces& places) const {
    const auto by_node = places.component(function.response);
    if (places.is_put(function.response.node) && by_node && is_result(by_node->result))
      return MatchedFunction{&function, by_node->result, by_node->sign};
    for (const std::string& text : function.texts)
      if (is_result(text)) return MatchedFunction{&function, text, function.response.direction < 0 ? -1.0 : 1.0};
    if (by_node && is_result(by_node->result)) return MatchedFunction{&function, by_node->result, by_node->sign};
    return std::nullopt;
  }

  void report_no_match(const MeasuredFile& file, const MeasuredPlaces& places) {
    std::vector<std::string> measured;
    for (const MeasuredFunction& function : file.functions)
      if (std::ranges::find(measured, function.name) == measured.end()) measured.push_back(function.name);
    for (const exchange::UniversalMode& mode : file.modes)
      for (const exchange::UniversalNodeMotion& node : mode.nodes)
        if (const std::string name = fmt::format("node {} of modes", node.node);
            std::ranges::find(measured, name) == measured.end())
          measured.push_back(name);
    const auto is_placed = [&](const MeasuredFunction& f) {
      return f.response.node != 0 && places.place(f.response.node) && f.response.direction != 0;
    };
    if (std::ranges::any_of(file.functions, is_placed))
      return static_cast<void>(reader_.error(
          "file", "the file has: " + foundation::comma_separated(measured),
          "their places are known, but their directions are not along axes of the bodies, which results have",
          "measure along the axes of a turned body, or place a point on a body that is not turned"));
    reader_.error("file", "the file has: " + foundation::comma_separated(measured),
                  "none of it is at a place of the model: " + foundation::comma_separated(places.names()),
                  "add nodes = {\"3\" = \"BODY.POINT\"} with the numbers of the file, or channels = {\"BODY.z\" = "
                  "\"NAME or 3:+z\"}");
  }

  // ------------------------------------------------------------------------------------------- curves

  const model::Excitation* read_force() {
    const auto name = reader_.text("force");
    if (!name) return nullptr;
    for (const model::Excitation& excitation : description_.excitations)
      if (excitation.name == *name) return &excitation;
    const std::vector<std::string>& known = in_file_.harmonic_excitations;
    if (std::ranges::find(known, *name) != known.end()) return nullptr;  // reported elsewhere
    const std::string guess = foundation::nearest_name(*name, known);
    reader_.error(
        "force", foundation::quoted(*name), "no harmonic excitation has this name",
        guess.empty() ? "known are: " + foundation::comma_separated(known) : "did you mean \"" + guess + "\"?");
    return nullptr;
  }

  void add_curves(const std::vector<MatchedFunction>& matched, const MeasuredPlaces& places, Measurement& result) {
    const std::size_t before = reader_.errors();
    const model::Excitation* excitation = read_force();
    std::optional<MeasuredForce> force;
    if (excitation) force.emplace(description_, places, *excitation);
    if (force && force->unsuitable()) {
      reader_.error("force", *force->unsuitable(), "it is a harmonic force, or a moment, on a body",
                    "name such an excitation");
      return;
    }
    if (excitation) result.excitation = excitation->name;
    if (matched.empty() || reader_.errors() > before) return;
    std::vector<std::string> of_other_force, repeated;
    for (const MatchedFunction& match : matched) {
      if (!has_known_unit(match)) return;
      const auto factor = factor_of(match, force);
      if (!factor) {
        of_other_force.push_back(match.function->name + " over " + places.words(match.function->reference));
        continue;
      }
      const auto& curves = result.curves;
      if (std::ranges::any_of(curves, [&](const auto& c) { return c.result == match.result; }))
        repeated.push_back(match.function->name);
      else add_curve(match, *factor, force ? force->delay() : 0, result);
    }
    if (reader_.errors() > before) return;
    warn_of_assumed_units(matched);
    if (result.curves.empty())
      reader_.error("force", "references of the file: " + foundation::comma_separated(of_other_force),
                    "none is on the body, at the place and along the direction of the " + force->words(),
                    "name the excitation at the reference, or add the node of the reference to `nodes`");
    else if (!repeated.empty())
      warn("functions of the same results again: " + foundation::comma_separated(repeated),
           "one function of each result is compared, the first", "name it: channels = {\"BODY.z\" = \"3:+z\"}");
  }

  void warn(const std::string& finding, const std::string& rule, const std::string& remedy) {
    reader_.problems().warning(reader_.path(), finding, rule, remedy).origin = reader_.node("file")->origin;
  }

  /// Reports a function without a unit, or one of another quantity than its result.
  bool has_known_unit(const MatchedFunction& match) {
    const auto wanted = names_.component(match.result, response_.selection.quantity);
    const auto& unit = match.function->unit;
    if (match.function->unit_error) {
      foundation::Problems of_file;
      of_file.add(*match.function->unit_error);
      reader_.add_of_file("file", of_file);
      return false;
    }
    if (!unit && !units_.empty()) {
      reader_.error("unit", fmt::format("{} is not for {}", unit_words(units_), match.function->name),
                    fmt::format("{} is measured in {}, perhaps per force, and the file states no unit of it",
                                match.result, si_unit(*wanted)),
                    "state several units: unit = [\"g/N\", \"(rad/s2)/N\"]");
      return false;
    }
    if (!unit) {
      reader_.error("file", "the unit of " + foundation::quoted(match.function->name) + " is not known",
                    "axis types and set 164 of the file, or brackets in the heading of a table, state it",
                    "add unit = \"m/s2\", \"mm\" or \"(m/s)/N\", the unit of its numbers");
      return false;
    }
    if (underived(unit->quantity) == underived(*wanted)) return true;
    reader_.error("file", fmt::format("{} [{}]", match.function->name, si_unit(unit->quantity)),
                  fmt::format("{} is measured in {}", match.result, si_unit(*wanted)),
                  "check the unit, or map the function to another result by `channels`");
    return false;
  }

  void warn_of_assumed_units(const std::vector<MatchedFunction>& matched) {
    std::vector<std::string> assumed;
    for (const MatchedFunction& match : matched)
      if (match.function->unit->assumed) assumed.push_back(match.function->name);
    if (assumed.empty()) return;
    foundation::Problems of_file;
    of_file.add(assumed_units(units_, assumed, reader_.text("file").value_or("")));
    reader_.add_of_file("file", of_file);
  }

  /// Factor of the measured values: sign, and amplitude of the force; none if the reference does not fit.
  std::optional<std::complex<double>> factor_of(const MatchedFunction& match,
                                                const std::optional<MeasuredForce>& force) {
    if (!match.function->unit->per_load) {
      if (force)
        reader_.error("force", foundation::quoted(match.function->name) + " is not per force",
                      "`force` multiplies functions that are measured per force", "remove it");
      return match.sign;
    }
    if (!force) {
      if (!reader_.has("force"))
        reader_.error("file", foundation::quoted(match.function->name) + " is per force",
                      "the response is that to the forces of the model", "name the force: force = \"EXCITATION\"");
      return match.sign;
    }
    const auto amplitude = force->amplitude(match.function->reference);
    return amplitude ? std::optional(match.sign * *amplitude) : std::nullopt;
  }

  void add_curve(const MatchedFunction& match, std::complex<double> factor, double delay, Measurement& result) const {
    const MeasuredFunction& function = *match.function;
    const int power = derivatives_of(*names_.component(match.result, response_.selection.quantity)) -
        derivatives_of(function.unit->quantity);
    MeasuredCurve curve{match.result, function.name, function.angular_frequency, function.value, function.coherence};
    for (Eigen::Index i = 0; i < curve.value.size(); ++i) {
      const std::complex<double> s(0, curve.angular_frequency[i]);
      curve.value(i) *= factor * std::pow(s, power) * std::exp(-s * delay);
    }
    result.curves.push_back(std::move(curve));
  }

  // ------------------------------------------------------------------------------------------- band and coherence

  [[nodiscard]] std::optional<assembly::Band> band() const {
    if (response_.band) return response_.band;
    if (response_.at.empty()) return std::nullopt;
    const auto [low, high] = std::ranges::minmax_element(response_.at);
    return assembly::Band{*low, *high};
  }

  void check_band(const Measurement& measurement) {
    const auto request = band();
    if (!request || measurement.curves.empty()) return;
    double low = foundation::infinity, high = 0;
    for (const MeasuredCurve& curve : measurement.curves)
      for (const double omega : curve.angular_frequency) {
        low = std::min(low, omega), high = std::max(high, omega);
        if (covers(*request, omega)) return;
      }
    const double hertz = 1 / foundation::two_pi;
    reader_.error("file", fmt::format("measured from {:.6g} to {:.6g} Hz", low * hertz, high * hertz),
                  fmt::format("the response has no frequency there: {:.6g} to {:.6g} Hz", request->from * hertz,
                              request->to * hertz),
                  "widen the band of analyses.response");
  }

  void check_coherence(const MeasuredCurve& curve) {
    constexpr double poor = 0.5, share = 0.5;
    std::size_t lines = 0, poor_lines = 0;
    const auto request = band();
    for (Eigen::Index i = 0; i < curve.coherence.size(); ++i) {
      if (request && !covers(*request, curve.angular_frequency[i])) continue;
      ++lines;
      poor_lines += curve.coherence(i) < poor;
    }
    if (lines == 0 || static_cast<double>(poor_lines) <= share * static_cast<double>(lines)) return;
    warn(fmt::format("coherence of {} below {} at {} of {} frequencies", curve.result, poor, poor_lines, lines),
         "such a function is mostly noise, leakage or the effect of other forces",
         "check the measurement before you change the model");
  }

  // ------------------------------------------------------------------------------------------- modes

  /// Components of nodes with a place that move in any mode: a direction with zeros alone is not measured.
  [[nodiscard]] std::vector<std::pair<int, int>> measured_directions(const MeasuredFile& file,
                                                                     const MeasuredPlaces& places) const {
    std::set<std::pair<int, int>> moving;
    for (const exchange::UniversalMode& mode : file.modes)
      for (const exchange::UniversalNodeMotion& node : mode.nodes)
        for (int axis = 0; axis < 3; ++axis)
          if (node.components[axis] != std::complex<double>(0) && places.place(node.node))
            moving.insert({node.node, axis});
    return {moving.begin(), moving.end()};
  }

  void add_modes(const MeasuredFile& file, const MeasuredPlaces& places, Measurement& result) {
    constexpr std::size_t fewest = 3;
    if (file.modes.empty()) return;
    const auto directions = measured_directions(file, places);
    if (directions.empty()) return;
    if (directions.size() < fewest)
      warn(fmt::format("{} measured components of mode shapes", directions.size()),
           "shapes with so few components look alike", "measure more places, or give the nodes places by `nodes`");
    for (const auto& [node, axis] : directions) {
      const MeasuredPlace* place = places.place(node);
      result.components.push_back({place->body, place->at, axis});
    }
    for (const exchange::UniversalMode& mode : file.modes) {
      MeasuredMode measured{mode.number, foundation::two_pi * exchange::natural_frequency_hz(mode),
                            exchange::damping_ratio(mode), Eigen::VectorXcd::Zero(to_index(directions.size()))};
      for (std::size_t c = 0; c < directions.size(); ++c)
        for (const exchange::UniversalNodeMotion& node : mode.nodes)
          if (node.node == directions[c].first) measured.shape(to_index(c)) = node.components[directions[c].second];
      result.modes.push_back(std::move(measured));
    }
  }

  TableReader& reader_;
  const model::Description& description_;
  const SymbolTable& in_file_;
  const ResultNames names_;
  const ResponseRequest& response_;
  GivenUnits units_;
};

}  // namespace

void read_measurements(TableReader& root, const model::Description& description, const SymbolTable& symbols,
                       Analyses& analyses) {
  const Node* table = root.table("measurements");
  if (!table) return;
  if (!analyses.response) {
    root.error("measurements", "no response to compare with",
               "measurements are compared over the band of "
               "analyses.response",
               "add response = {…} to [analyses]");
    return;
  }
  if (table->keys.size() > most_measurements) {
    root.error("measurements", fmt::format("{} of them", table->keys.size()),
               fmt::format("at most {} are allowed", most_measurements), "keep those that are needed");
    return;
  }
  TableReader all(*table, "measurements", root.problems());
  for (const std::string& name : table->keys) {
    const Node* node = all.table(name);
    if (!node) continue;
    TableReader reader(*node, "measurements." + name, root.problems());
    auto measurement = MeasurementTable(reader, description, symbols, *analyses.response).read(name);
    reader.finish();
    if (measurement) analyses.measurements.push_back(std::make_shared<const Measurement>(std::move(*measurement)));
  }
}

}  // namespace trivet::project
