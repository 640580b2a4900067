// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::Optimization;

json::Json step_json(const std::optional<study::OptimizedParameter::Step>& step) {
  if (!step) return nullptr;
  return {{"value", step->value},
          {"objective", step->objective ? json::number(*step->objective) : json::Json(nullptr)},
          {"met", step->met}};
}

json::Json decoupling_json(const study::DesignSummary& summary) {
  json::Json bodies = json::Json::object();
  for (const study::BodyDecoupling& one : summary.decoupling) bodies[one.body] = one.least;
  return bodies;
}

json::Json mounts_json(const study::OptimizedMounts& mounts, const std::vector<std::size_t>& chosen) {
  json::Json names = json::Json::object();
  for (std::size_t c = 0; c < chosen.size(); ++c) names[mounts.choices[c].name] = mounts.choices[c].mounts[chosen[c]];
  return names;
}

}  // namespace

std::string optimization_json(const Optimization& found, const foundation::Problems& warnings) {
  json::Json result = json::optimization(found);
  result["warnings"] = json::warnings(warnings);
  return json::text(result, 1) + "\n";
}

json::Json json::differenced(const std::vector<std::string>& kinds, std::size_t evaluations) {
  Json list = Json::array();
  for (const std::string& kind : kinds) list.push_back({{"requirement", kind}, {"evaluations", evaluations}});
  return list;
}

json::Json json::optimization(const Optimization& found) {
  const auto number = [](double value) { return json::number(value); };
  const bool cheapest = found.mounts && found.mounts->price;
  Json result = {{"objective", found.minimizes ? Json(minimized_names(found)) : Json(cheapest ? "price" : "margin")},
                 {"weights", found.weights},
                 {"falls_short", found.falls_short},
                 {"minimized", Json::array()},
                 {"before", found.objective_before ? number(*found.objective_before) : Json(nullptr)},
                 {"after", number(found.objective_after)},
                 {"unit", found.objective_unit.empty() ? "1" : found.objective_unit},
                 {"feasible", found.feasible},
                 {"parameters", Json::array()},
                 {"cases", Json::array()},
                 {"active", Json::array()},
                 {"gone_peaks", Json::array()},
                 {"residual", found.no_slopes.empty() ? number(found.residual) : Json(nullptr)},
                 {"no_slopes", found.no_slopes},
                 {"conflicts", Json::array()},
                 {"cut_short", found.cut_short},
                 {"starts", found.starts},
                 {"agreeing", found.agreeing},
                 {"stuck", found.stuck},
                 {"others", Json::array()},
                 {"designs", found.evaluations},
                 {"failed", found.failed},
                 {"differenced", json::differenced(found.differenced, found.differences)},
                 {"looked_at", found.looked_at},
                 {"families", found.families},
                 {"no_families", found.no_families}};
  if (found.mounts) {
    const study::OptimizedMounts& mounts = *found.mounts;
    Json others = Json::array();
    for (const study::OptimizedMounts::Other& other : mounts.others)
      others.push_back({{"chosen", mounts_json(mounts, other.mounts)}, {"objective", number(other.objective)}});
    result["mounts"] = {{"chosen", mounts_json(mounts, mounts.chosen)},
                        {"combinations", mounts.combinations},
                        {"considered", mounts.considered},
                        {"optimized", mounts.optimized},
                        {"others", std::move(others)}};
    if (mounts.price) {
      result["mounts"]["price"] = number(mounts.price->amount);
      result["mounts"]["price_before"] = mounts.price_before ? number(mounts.price_before->amount) : Json(nullptr);
      result["mounts"]["currency"] = mounts.price->currency;
      result["mounts"]["some_met"] = mounts.some_met;
    }
  }
  for (const study::OptimizedParameter& p : found.parameters) {
    Json places = Json::array();
    for (const project::ParameterPlace& place : p.axis.places)
      places.push_back({{"path", place.path}, {"factor", place.factor}});
    result["parameters"].push_back({{"name", p.axis.name},
                                    {"places", std::move(places)},
                                    {"unit", axis_unit(p.axis)},
                                    {"from", p.axis.from},
                                    {"to", p.axis.to},
                                    {"given", json::optional(p.given)},
                                    {"optimum", p.best},
                                    {"as_good_from", p.least},
                                    {"as_good_to", p.most},
                                    {"at_bound", p.at_bound},
                                    {"one_percent_less", step_json(p.below)},
                                    {"one_percent_more", step_json(p.above)},
                                    {"idle", p.idle}});
  }
  for (std::size_t c = 0; c < found.after.size(); ++c)
    result["cases"].push_back(
        {{"case", found.after[c].case_name},
         {"before", json::verdict(found.before[c])},
         {"after", json::verdict(found.after[c])},
         {"angular_frequencies_before", json::list(found.summaries_before[c].angular_frequencies)},
         {"angular_frequencies_after", json::list(found.summaries_after[c].angular_frequencies)},
         {"decoupling_before", decoupling_json(found.summaries_before[c])},
         {"decoupling_after", decoupling_json(found.summaries_after[c])}});
  for (const study::ActiveRequirement& one : found.active)
    result["active"].push_back({{"case", found.after[one.result_case].case_name},
                                {"requirement", one.words},
                                {"minimized", one.minimized},
                                {"multiplier", one.multiplier}});
  for (const study::GonePeak& one : found.gone_peaks)
    result["gone_peaks"].push_back({{"case", found.after[one.result_case].case_name},
                                    {"name", one.name},
                                    {"measure", number(one.measure)},
                                    {"angular_frequency", number(one.angular_frequency)}});
  for (const study::MinimizedAmplitude& one : found.minimized)
    result["minimized"].push_back({{"case", found.after[one.result_case].case_name},
                                   {"name", one.name},
                                   {"unit", one.unit},
                                   {"limit", json::optional(one.limit)},
                                   {"before", number(one.before)},
                                   {"after", number(one.after)}});
  for (const study::Conflict& one : found.conflicts)
    result["conflicts"].push_back({{"case", found.after[one.result_case].case_name},
                                   {"requirement", one.words},
                                   {"factor", number(one.factor)},
                                   {"without", number(one.without)}});
  for (const study::OtherOptimum& other : found.others)
    result["others"].push_back(
        {{"values", json::list(other.values)}, {"objective", number(other.objective)}, {"starts", other.starts}});
  return result;
}

}  // namespace trivet::results
