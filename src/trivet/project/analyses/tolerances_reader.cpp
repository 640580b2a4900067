// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/batch_file.h"
#include "trivet/project/analyses/design_axis_reader.h"
#include "trivet/project/analyses/request_readers.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

using numerics::Distribution;
using numerics::DistributionShape;

/// A deviation [SI], or a share of the number.
struct Deviation {
  double value = 0;
  bool relative = false;
};

/// One table of [tolerances] while it is read.
class ToleranceReader {
 public:
  ToleranceReader(TableReader& root, TableReader& reader) : root_(root), reader_(reader) {}

  Tolerance read(const std::string& name) {
    const std::size_t before = reader_.errors();
    tolerance_.name = name;
    tolerance_.places = read_places(root_, reader_, "tolerance");
    if (reader_.errors() == before) refuse_unwritten();
    path_is_wrong_ = reader_.errors() > before;
    tolerance_.together = reader_.boolean("together").value_or(false);
    if (!tolerance_.places.empty()) quantity_ = quantity_at(root_.content(), path_keys(tolerance_.places.front().path));
    if (reader_.has("file")) read_batch();
    else read_distribution();
    read_correlations();
    reader_.finish();
    return std::move(tolerance_);
  }

 private:
  /// A last key that the table in the file does not have: a typing error, or a number that the file leaves out.
  void refuse_unwritten() {
    for (const ParameterPlace& place : tolerance_.places) {
      std::vector<std::string> keys = path_keys(place.path);
      if (node_at(root_.content(), keys) || default_number(keys)) continue;
      const std::string key = keys.back();
      keys.pop_back();
      const Node* table = node_at(root_.content(), keys);
      std::vector<std::string> known = numbers_with_default();
      if (table) known.insert(known.end(), table->keys.begin(), table->keys.end());
      const std::string guess = foundation::nearest_name(key, known);
      reader_.error("path", foundation::quoted(place.path),
                    fmt::format("the file has no {} there", foundation::quoted(foundation::shortened(key))),
                    guess.empty() ? "a tolerance is around a number of the file: write it there, or name another one"
                                  : "did you mean " + foundation::quoted(guess) + "?");
    }
  }

  /// The number in the file at each place, or its default; none if it cannot be read.
  [[nodiscard]] std::optional<double> given(const ParameterPlace& place) const {
    const std::vector<std::string> keys = path_keys(place.path);
    if (const Node* node = node_at(root_.content(), keys)) {
      const auto number = written_number(*node);
      return number ? in_unit(*number, "") : std::nullopt;
    }
    const auto plain = default_number(keys);
    return plain ? std::optional(plain->value) : std::nullopt;
  }

  std::optional<Deviation> read_deviation(const std::string& key) {
    const Node* node = reader_.node(key);
    if (!node || path_is_wrong_) return std::nullopt;  // the unit of the number is not known
    const auto number = written_number(*node);
    const bool relative = number && unit_ratio(number->unit, "%").has_value() && !number->unit.empty();
    const std::size_t before = reader_.errors();
    const auto value = reader_.number(key, relative ? Quantity::pure : quantity_.value_or(Quantity::pure));
    if (!value || reader_.errors() > before) return std::nullopt;
    if (*value > 0 && std::isfinite(*value)) return Deviation{*value, relative};
    reader_.error(key, value_text(*node), "a deviation is > 0",
                  "give it as a share of the number, \"15 %\", or in its unit, \"2 mm\"");
    return std::nullopt;
  }

  void read_distribution() {
    const auto word = reader_.choice("distribution", {"uniform", "triangular", "normal", "lognormal"});
    const bool has_half_width = reader_.has("half_width"), has_deviation = reader_.has("standard_deviation");
    const bool is_normal = !has_half_width && (has_deviation || reader_.has("truncated_at"));
    const std::string shape = word.value_or(is_normal ? "normal" : "uniform");
    const bool bounded = shape == "uniform" || shape == "triangular";
    const char *key = bounded ? "half_width" : "standard_deviation",
               *other = bounded ? "standard_deviation" : "half_width";
    if (reader_.has(other)) {
      static_cast<void>(reader_.node(other));
      reader_.error(other, fmt::format("{} of a {} distribution", other, shape),
                    "half_width is of uniform and triangular ones, standard_deviation of normal and lognormal ones",
                    fmt::format("give {} instead, or another distribution", key));
    } else if (!reader_.has(key)) {
      reader_.missing(key, fmt::format("{} = \"15 %\" of the number, or in its unit; or file = \"batch.csv\"", key));
    }
    const auto spread = read_deviation(key);
    Distribution& distribution = tolerance_.distribution;
    distribution.shape = shape == "uniform" ? DistributionShape::uniform
        : shape == "triangular"             ? DistributionShape::triangular
        : shape == "normal"                 ? DistributionShape::normal
                                            : DistributionShape::lognormal;
    if (!spread) return static_cast<void>(reader_.node("truncated_at"));
    tolerance_.relative = spread->relative;
    distribution.spread = spread->value;
    distribution.mean = spread->relative ? 1 : 0;
    if (shape == "lognormal" && !spread->relative)
      reader_.error(key, value_text(*reader_.node(key)), "the deviation of a lognormal number is a share of the number",
                    "give it in %");
    read_truncation(bounded, shape);
    if (spread->relative) refuse_shares_of_zero(key);
  }

  void read_truncation(bool bounded, const std::string& shape) {
    if (!reader_.has("truncated_at")) return;
    const auto at = read_deviation("truncated_at");
    if (bounded)
      reader_.error("truncated_at", fmt::format("of a {} distribution", shape), "this one ends at its half width",
                    "remove it, or choose normal or lognormal");
    else if (at && at->relative != tolerance_.relative)
      reader_.error("truncated_at", value_text(*reader_.node("truncated_at")),
                    "it is given as the standard deviation is: both in %, or both in the unit of the number",
                    "change one of them");
    else if (at) tolerance_.distribution.truncated_at = at->value;
  }

  void refuse_shares_of_zero(const char* key) {
    for (const ParameterPlace& place : tolerance_.places)
      if (given(place) == 0.0)
        reader_.error(key, fmt::format("{} of 0 at {}", value_text(*reader_.node(key)), foundation::quoted(place.path)),
                      "a share of 0 is no tolerance", "give the deviation in the unit of the number");
  }

  void read_batch() {
    for (const char* key : {"distribution", "half_width", "standard_deviation", "truncated_at"})
      if (reader_.has(key)) {
        static_cast<void>(reader_.node(key));
        reader_.error(key, "beside file", "a measured batch is the distribution itself", "remove one of them");
      }
    auto batch = read_batch_file(reader_, quantity_);
    if (!batch) return;
    std::optional<double> common;
    for (const ParameterPlace& place : tolerance_.places) {
      const auto here = given(place);
      if (!here) return;
      constexpr double same = 1e-9;
      if (common && std::abs(*here - *common) > same * std::abs(*common)) {
        reader_.error("path", fmt::format("{:.6g} and {:.6g}", *common, *here),
                      "the numbers of a measured batch are those of every place, which have one value in the file",
                      "make tolerances of their own, or change the file");
        return;
      }
      common = here;
    }
    const double number = common.value_or(0);
    tolerance_.relative = number != 0;
    for (double& one : *batch) one = number != 0 ? one / number : one;
    std::ranges::sort(*batch);
    tolerance_.distribution.shape = DistributionShape::measured;
    tolerance_.distribution.mean = number != 0 ? 1 : 0;
    tolerance_.distribution.measured = std::move(*batch);
  }

  void read_correlations() {
    const Node* node = reader_.node("correlation");
    if (!node) return;
    const auto add = [&](const Node& one) {
      if (one.kind != Node::Kind::table) {
        reader_.error("correlation", kind_name(one.kind), "a correlation is {with = \"NAME\", value = 0.5}",
                      "write it so, or several in a list");
        return;
      }
      TableReader reader(one, reader_.path() + ".correlation", reader_.problems());
      const std::string with = reader.required_text("with");
      const double value = reader.required_number("value", Quantity::pure);
      if (reader.has("value") && !(std::abs(value) < 1))
        reader.error("value", fmt::format("{:.6g}", value), "a correlation is between -1 and 1, both excluded",
                     "for numbers that move together, name all their paths and add together = true");
      else if (!with.empty()) tolerance_.correlations.push_back({with, value});
      reader.finish();
    };
    if (node->kind == Node::Kind::array)
      for (const Node& one : node->items) add(one);
    else add(*node);
  }

  TableReader& root_;
  TableReader& reader_;
  Tolerance tolerance_;
  std::optional<Quantity> quantity_;
  bool path_is_wrong_ = false;
};

/// Checks the correlations of all tolerances with each other.
class CorrelationCheck {
 public:
  CorrelationCheck(TableReader& root, const std::vector<Tolerance>& tolerances)
      : root_(root), tolerances_(tolerances) {}

  void run() {
    for (std::size_t a = 0; a < tolerances_.size(); ++a)
      for (const Tolerance::Correlation& one : tolerances_[a].correlations) add(a, one);
    const numerics::GaussianCopula copula(tolerances_.size(), found_);
    if (!copula.impossible()) return;
    const auto& pair = found_[*copula.impossible()];
    if (numerics::GaussianCopula(2, {{0, 1, pair.value}}).impossible())
      return error(pair.a,
                   fmt::format("{} of {} and {}", pair.value, foundation::quoted(tolerances_[pair.a].name),
                               foundation::quoted(tolerances_[pair.b].name)),
                   "a correlation is between -1 and 1, both excluded by more than 1e-12",
                   "for numbers that move together, name all their paths and add together = true");
    error(pair.a,
          fmt::format("{:.6g} of {} and {}", pair.value, foundation::quoted(tolerances_[pair.a].name),
                      foundation::quoted(tolerances_[pair.b].name)),
          "no numbers have this correlation together with the others", "lower it, or the others of these tolerances");
  }

 private:
  void add(std::size_t a, const Tolerance::Correlation& one) {
    const auto other = std::ranges::find(tolerances_, one.with, &Tolerance::name);
    if (other == tolerances_.end()) {
      std::vector<std::string> names;
      for (const Tolerance& tolerance : tolerances_) names.push_back(tolerance.name);
      const std::string guess = foundation::nearest_name(one.with, names);
      return error(a, foundation::quoted(one.with), "no tolerance has this name",
                   guess.empty() ? "name a table of [tolerances]" : "did you mean " + foundation::quoted(guess) + "?");
    }
    const auto b = static_cast<std::size_t>(other - tolerances_.begin());
    const std::string pair =
        fmt::format("{} and {}", foundation::quoted(tolerances_[a].name), foundation::quoted(other->name));
    if (a == b) return error(a, pair, "a tolerance is correlated with another one", "remove it");
    for (const std::size_t each : {a, b})
      if (tolerances_[each].draws() > 1)
        return error(a, pair,
                     fmt::format("{} has {} numbers that draw for themselves; a correlation is of two numbers",
                                 foundation::quoted(tolerances_[each].name), tolerances_[each].draws()),
                     "add together = true, or make tolerances of their own");
    const bool twice = std::ranges::any_of(found_, [&](const numerics::GaussianCopula::Correlation& known) {
      return (known.a == a && known.b == b) || (known.a == b && known.b == a);
    });
    if (twice) return error(a, pair, "the correlation of a pair is given once", "remove one of them");
    found_.push_back({a, b, one.value});
  }

  void error(std::size_t tolerance, const std::string& finding, const std::string& rule, const std::string& remedy) {
    const std::string key = foundation::path_key(tolerances_[tolerance].name) + ".correlation";
    root_.problems().error("tolerances." + key, finding, rule, remedy).origin =
        deepest(*root_.node("tolerances"), tolerances_[tolerance].name + ".correlation").origin;
  }

  TableReader& root_;
  const std::vector<Tolerance>& tolerances_;
  std::vector<numerics::GaussianCopula::Correlation> found_;
};

/// `bands` and `band_points`.
void read_sampled_bands(TableReader& reader, const ResultNames& names, const std::optional<ResponseRequest>& response,
                        SampleRequest& request) {
  if (auto bands = read_result_names(reader, names, "bands", "remove `bands`, or name the results"))
    request.bands = std::move(*bands);
  if (const auto points = read_whole(reader, "band_points", fewest_band_points, most_band_points, "200 is usual"))
    request.band_points = static_cast<int>(*points);
  if (reader.has("bands") && !response)
    reader.error("bands", "no response", "bands are over the frequencies of analyses.response, under its excitations",
                 "add response = {band = [\"1 Hz\", \"50 Hz\"]} to [analyses]");
  if (!reader.has("band_points")) return;
  if (!reader.has("bands"))
    reader.error("band_points", "band_points without bands", "they are the frequencies of bands",
                 "add bands = [\"BODY.z\"], or remove it");
  else if (response && !response->at.empty())
    reader.error("band_points", "band_points beside single frequencies", "the response has at: bands are there too",
                 "remove it, or give the response a band in place of at");
}

}  // namespace

std::vector<Tolerance> read_tolerances(TableReader& root) {
  std::vector<Tolerance> tolerances;
  const Node* table = root.table("tolerances");
  if (!table) return tolerances;
  const std::size_t before = root.errors();
  for (std::size_t i = 0; i < table->keys.size(); ++i) {
    const std::string subject = "tolerances." + foundation::path_key(table->keys[i]);
    if (table->items[i].kind != Node::Kind::table) {
      root.problems()
          .error(subject, kind_name(table->items[i].kind), "a tolerance is a table",
                 "write [tolerances.NAME] with path and half_width")
          .origin = table->items[i].origin;
      continue;
    }
    TableReader reader(table->items[i], subject, root.problems());
    tolerances.push_back(ToleranceReader(root, reader).read(table->keys[i]));
  }
  std::vector<NamedPlaces> named;
  for (const Tolerance& one : tolerances) named.push_back({one.name, one.places});
  refuse_shared_numbers(named, "tolerances", "tolerance", root);
  if (root.errors() == before) CorrelationCheck(root, tolerances).run();
  return tolerances;
}

std::optional<double> read_whole(TableReader& reader, const std::string& key, double least, double most,
                                 const std::string& remedy) {
  const auto value = reader.number(key, Quantity::pure);
  if (!value || (*value >= least && *value <= most && *value == std::floor(*value))) return value;
  reader.error(key, fmt::format("{:.6g}", *value),
               fmt::format("a whole number from {:.0f} to {:.0f} is expected", least, most), remedy);
  return std::nullopt;
}

std::optional<SampleRequest> read_sample(TableReader& root, TableReader& analyses, const ResultNames& names,
                                         const std::optional<ResponseRequest>& response) {
  const Node* table = analyses.table("sample");
  if (!table) return std::nullopt;
  TableReader reader(*table, "analyses.sample", root.problems());
  SampleRequest request;
  if (const auto designs = read_whole(reader, "designs", fewest_sampled, most_sampled, "100_000 is usual"))
    request.designs = static_cast<std::size_t>(*designs);
  if (const auto seed = read_whole(reader, "seed", 0, most_seed, "seed = 1 is as good as any"))
    request.seed = static_cast<std::uint64_t>(*seed);
  request.sobol = reader.choice("sampling", {"sobol", "random"}) != "random";
  request.worst_case = reader.boolean("worst_case").value_or(false);
  request.yield = reader.number("yield", Quantity::pure);
  if (request.yield && !(*request.yield >= least_wanted_yield && *request.yield < 1))
    reader.error("yield", value_text(*reader.node("yield")),
                 fmt::format("a share from {:.0f} % to below 100 % is expected", 100 * least_wanted_yield),
                 *request.yield == 1
                     ? "write yield = \"99.9 %\", or worst_case = true: no number of designs shows that all machines "
                       "meet the requirements"
                     : "write yield = \"99 %\"");
  read_sampled_bands(reader, names, response, request);
  reader.finish();
  if (!root.has("tolerances"))
    reader.error("", "no tolerances", "sampled designs differ in at least one number",
                 "write [tolerances.NAME] with path and half_width");
  return request;
}

}  // namespace trivet::project
