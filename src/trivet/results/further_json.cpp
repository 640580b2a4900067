// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/further_json.h"

#include <limits>
#include <numbers>

#include "trivet/results/json_parts.h"

namespace trivet::results {
namespace json {
namespace {

Json curve(const response::Curve& c) {
  Json values = Json::array();
  for (Eigen::Index i = 0; i < c.value.size(); ++i) values.push_back(complex_number(c.value(i)));
  return {{"name", c.name}, {"unit", c.unit}, {"complex", std::move(values)}};
}

Json extreme(const response::Extreme& e) { return {{"value", number(e.value)}, {"time", number(e.time)}}; }

Json place(const response::MovingPlace& p) {
  Json motion = Json::array();
  for (Eigen::Index j = 0; j < 6; ++j) motion.push_back(complex_number(p.motion(j)));
  return {{"name", p.name}, {"position", list(p.position)}, {"motion", std::move(motion)}};
}

}  // namespace

Json random(const study::Answers& answers) {
  const study::RandomResult& random = *answers.random;
  Json result{{"results", Json::array()}, {"method", response::name(random.response.method)}, {"remark", random.response.remark}, {"inputs", random.inputs},
              {"band", {random.response.from, number(random.response.to)}}, {"angular_frequency", random.curves.angular_frequency}, {"warnings", warnings(answers.warnings)}};
  if (!random.total_values.empty()) {
    result["vibration_total_values"] = Json::object();
    result["vibration_total_axes"] = Json::object();
    for (const study::TotalValue& total : random.total_values) {
      result["vibration_total_values"][total.name] = total.value;
      result["vibration_total_axes"][total.name] = total.axes;
    }
  }
  for (std::size_t i = 0; i < random.response.answers.size(); ++i) {
    const response::RandomAnswer& a = random.response.answers[i];
    Json density = Json::array();
    for (const double s : random.curves.density[i]) density.push_back(number(2 * std::numbers::pi * s));
    Json infinite = Json::array();
    for (const auto& [is, what] : {std::pair{a.infinite_rms, "rms"}, {a.infinite_rms_of_derivative, "rms_of_derivative"}, {a.infinite_weighted_rms, "weighted_rms"}})
      if (is) infinite.push_back(what);
    result["results"].push_back({{"name", a.name}, {"unit", a.unit}, {"rms", optional(a.rms)}, {"three_sigma", optional(a.three_sigma)}, {"rms_of_derivative", optional(a.rms_of_derivative)},
                                 {"zero_crossings", optional(a.zero_crossings)}, {"weighted_rms", optional(a.weighted_rms)}, {"infinite", std::move(infinite)}, {"variance_share", a.variance_share}, {"vanishes", a.vanishes},
                                 {"estimated_error", number(a.estimated_error)}, {"reason", a.reason}, {"density_per_hz", std::move(density)}});
  }
  return result;
}

Json transient(const study::Answers& answers) {
  const response::TransientResponse& found = answers.transient->response;
  Json result{{"time", list(found.time)}, {"results", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const response::TimeCurve& c : found.curves)
    result["results"].push_back({{"name", c.name}, {"unit", c.unit}, {"largest", extreme(c.largest)}, {"smallest", extreme(c.smallest)}, {"rms", number(c.rms)}, {"value", list(c.values)}});
  return result;
}

Json orders(const study::Answers& answers) {
  const response::RunUp& run = answers.orders->run_up;
  const response::Campbell& campbell = answers.orders->campbell;
  Json result{{"speed", run.speed}, {"orders", Json::array()}, {"overall", Json::array()}, {"critical_speeds", Json::array()},
              {"campbell", {{"orders", campbell.orders}, {"natural", Json::array()}, {"interference", Json::array()}}}, {"warnings", warnings(answers.warnings)}};
  for (const response::OrderCurves& order : run.orders) {
    Json curves = Json::array();
    for (const response::Curve& c : order.curves) curves.push_back(curve(c));
    result["orders"].push_back({{"order", order.order}, {"results", std::move(curves)}});
  }
  for (const response::Overall& o : run.overall)
    result["overall"].push_back({{"name", o.name}, {"unit", o.unit}, {"highest_rms", number(o.highest_rms)}, {"highest_rms_at", number(o.highest_rms_at)}, {"rms", list(o.rms)}, {"bound", list(o.bound)}});
  for (const response::CriticalSpeed& c : run.critical)
    result["critical_speeds"].push_back({{"name", run.overall[c.curve].name}, {"unit", run.overall[c.curve].unit}, {"order", c.order}, {"speed", c.speed}, {"angular_frequency", c.angular_frequency},
                                         {"amplitude", number(c.amplitude)}, {"prominence", number(c.prominence)}, {"relative_height", c.relative_height}, {"nearest_mode", optional(c.nearest_mode)}});
  for (const response::NaturalLine& line : campbell.natural)
    result["campbell"]["natural"].push_back({{"angular_frequency", line.angular_frequency}, {"damping_ratio", line.damping_ratio}, {"nearest_mode", optional(line.nearest_mode)}});
  for (const response::Interference& point : campbell.points)
    result["campbell"]["interference"].push_back({{"order", point.order}, {"speed", point.speed}, {"angular_frequency", point.angular_frequency}, {"mode", optional(point.mode)},
                                                  {"modal_force_share", optional(point.modal_force_share)}, {"excited", point.excited}});
  return result;
}

Json transmissibility(const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.transmissibility;
  Json result{{"of", t.words}, {"angular_frequency", t.curves.angular_frequency}, {"results", Json::array()}, {"peaks", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (std::size_t i = 0; i < t.curves.curves.size(); ++i) {
    const response::Curve& c = t.curves.curves[i];
    Json one = curve(c), level = Json::array(), efficiency = Json::array();
    for (const auto& value : c.value) {
      level.push_back(number(response::transmissibility_level(std::abs(value))));
      efficiency.push_back(number(response::isolation_efficiency(std::abs(value))));
    }
    one["level_db"] = std::move(level);
    one["isolation_efficiency"] = t.is_share(i) ? Json() : std::move(efficiency);
    one["isolates_from"] = t.is_share(i) ? Json() : optional(t.crossovers[i].angular_frequency);
    result["results"].push_back(std::move(one));
  }
  for (const response::Peak& peak : t.peaks.list)
    result["peaks"].push_back({{"name", t.peaks.curves[peak.curve].name}, {"angular_frequency", peak.angular_frequency}, {"amplitude", number(peak.amplitude)}, {"nearest_mode", optional(peak.nearest_mode)}});
  return result;
}

Json power(const study::Answers& answers) {
  const response::PowerFlow& p = *answers.power;
  Json result{{"angular_frequency", p.angular_frequency}, {"mounts", Json::array()}, {"into_ground_in_total", list(p.into_ground_in_total)}, {"by_forces", list(p.by_forces)},
              {"by_ground", list(p.by_ground)}, {"elements", Json::array()}, {"dissipated_by_foundations", list(p.dissipated_by_foundations)}, {"dissipated_by_system", list(p.dissipated_by_system)}, {"warnings", warnings(answers.warnings)}};
  for (std::size_t i = 0; i < p.mounts.size(); ++i) result["mounts"].push_back({{"name", p.mounts[i]}, {"into_ground", list(p.into_ground.row(static_cast<Eigen::Index>(i)))}});
  for (std::size_t i = 0; i < p.elements.size(); ++i) result["elements"].push_back({{"name", p.elements[i]}, {"dissipated", list(p.dissipated.row(static_cast<Eigen::Index>(i)))}});
  return result;
}

Json shapes(const study::Answers& answers) {
  Json result{{"shapes", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const response::DeflectionShape& shape : answers.shapes) {
    Json places = Json::array();
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) places.push_back(place(p));
    result["shapes"].push_back({{"angular_frequency", shape.angular_frequency}, {"largest_excursion", shape.largest_excursion}, {"places", std::move(places)}});
  }
  return result;
}

Json shock_spectrum(const study::Answers& answers) {
  Json result{{"spectra", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const study::ShockSpectrumResult& spectrum : answers.shock_spectra) {
    Json rows = Json::array();
    for (const excitation::ShockResponse& r : spectrum.spectrum)
      rows.push_back({{"angular_frequency", r.angular_frequency}, {"largest", r.largest()}, {"smallest", r.smallest()}, {"maximax", r.maximax()}, {"primary", r.primary()}, {"residual", r.residual()},
                      {"relative_displacement", r.relative_displacement}, {"pseudo_velocity", r.pseudo_velocity()}});
    result["spectra"].push_back({{"excitation", spectrum.excitation}, {"unit", spectrum.unit}, {"damping_ratio", spectrum.damping_ratio}, {"rows", std::move(rows)}});
  }
  return result;
}

Json earthquake(const study::Answers& answers) {
  const response::EarthquakeResponse& e = *answers.earthquake;
  Json result{{"results", Json::array()}, {"modes", Json::array()}, {"effective_mass_share", e.effective_mass_share}, {"warnings", warnings(answers.warnings)}};
  for (const response::CombinedAnswer& a : e.answers)
    result["results"].push_back({{"name", a.name}, {"unit", a.unit}, {"srss", a.square_root_of_sum_of_squares}, {"cqc", a.complete_quadratic}, {"modal_maxima", list(a.modal_maxima)}});
  for (const response::ModalShare& m : e.modes)
    result["modes"].push_back({{"angular_frequency", m.angular_frequency}, {"damping_ratio", m.damping_ratio}, {"participation", m.participation}, {"effective_mass", m.effective_mass},
                               {"spectral_acceleration", number(m.spectral_acceleration)}});
  return result;
}

Json limit_lines(const study::Answers& answers) {
  Json result = Json::array();
  for (const study::LimitLineResult& l : answers.limit_lines) {
    Json exceeded = Json::array();
    for (const response::Band& band : l.comparison.exceeded) exceeded.push_back({band.from, band.to});
    result.push_back({{"name", l.line.name}, {"of", l.of}, {"unit", l.line.unit}, {"level", l.line.rms ? "rms" : "zero_to_peak"}, {"compared", {l.comparison.compared.from, l.comparison.compared.to}},
                      {"least_margin", number(l.comparison.least_margin)}, {"least_margin_db", number(response::margin_level(l.comparison.least_margin))}, {"at", l.comparison.least_margin_at},
                      {"exceeded", std::move(exceeded)}, {"kept", l.comparison.kept()}});
  }
  return result;
}

Json load_sharing(const study::Answers& answers) {
  Json mounts = Json::array();
  for (const response::MountLoad& m : answers.load_sharing->mounts)
    mounts.push_back({{"element", m.element}, {"force", list(m.force)}, {"bearing", m.bearing}, {"share", m.share}, {"deflection", list(m.deflection)}});
  return {{"mounts", std::move(mounts)}, {"bearing_in_total", answers.load_sharing->bearing_in_total}};
}

void add_further(const study::Answers& answers, Json& result) {
  if (answers.random) result["random"] = random(answers);
  if (answers.transient) result["transient"] = transient(answers);
  if (answers.orders) result["orders"] = orders(answers);
  if (answers.transmissibility) result["transmissibility"] = transmissibility(answers);
  if (answers.power) result["power"] = power(answers);
  if (!answers.shapes.empty()) result["shapes"] = shapes(answers);
  if (!answers.shock_spectra.empty()) result["shock_spectrum"] = shock_spectrum(answers);
  if (answers.earthquake) result["earthquake"] = earthquake(answers);
  if (!answers.limit_lines.empty()) result["limit_lines"] = limit_lines(answers);
  if (answers.map) result["map"] = design_map(*answers.map);
  if (answers.load_sharing) result["load_sharing"] = load_sharing(answers);
}

}  // namespace json

std::string random_json(const study::Answers& answers) { return json::text(json::random(answers), 1) + "\n"; }
std::string transient_json(const study::Answers& answers) { return json::text(json::transient(answers), 1) + "\n"; }
std::string orders_json(const study::Answers& answers) { return json::text(json::orders(answers), 1) + "\n"; }
std::string transmissibility_json(const study::Answers& answers) { return json::text(json::transmissibility(answers), 1) + "\n"; }

}  // namespace trivet::results
