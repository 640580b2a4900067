// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/analyses/steady_parts.h"
#include "trivet/results/format/json_parts.h"

/// Harmonics of all motions found at the parameters that were requested.
namespace trivet::results {

using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;

namespace {

/// A harmonic of a motion, which is numbered from 1 at each parameter; 0 is the mean.
struct HarmonicOf {
  PointOfCurve motion;
  std::size_t number;
  Eigen::Index k;

  [[nodiscard]] std::complex<double> amplitude(std::size_t result) const {
    const ObservedMotion& of = motion.point->results[result];
    return k == 0 ? of.mean : of.harmonics(k - 1);
  }
  /// Over that of the excitation.
  [[nodiscard]] double harmonic() const { return static_cast<double>(k) / motion.curve->periods; }
};

std::vector<PointOfCurve> motions_at(const SteadyBranch& branch, double parameter) {
  constexpr double same = 1e-9;
  std::vector<PointOfCurve> found = points_of_curves(branch, &SteadyBranch::at);
  std::erase_if(found, [&](const PointOfCurve& one) {
    return std::abs(one.curve->parameter(*one.point) - parameter) > same * parameter;
  });
  return found;
}

std::vector<HarmonicOf> harmonics_of(const PointOfCurve& motion, std::size_t number) {
  std::vector<HarmonicOf> list;
  for (Eigen::Index k = 0; k <= motion.curve->harmonics; ++k) list.push_back({motion, number, k});
  return list;
}

/// Is it above a millionth of the largest harmonic of any result?
bool is_shown(const HarmonicOf& one) {
  constexpr double small = 1e-6;
  return one.k > 0 && std::ranges::any_of(one.motion.point->results, [&](const ObservedMotion& result) {
           return std::abs(result.harmonics(one.k - 1)) > small * result.harmonics.cwiseAbs().maxCoeff();
         });
}

/// The largest values on the connected curve: smaller ones are round-off.
LargestOfKind largest_on(const SteadyBranch& branch) {
  LargestOfKind largest;
  for (const nonlinear::SteadyPoint& point : branch.points)
    for (std::size_t c = 0; c < branch.results.size(); ++c)
      largest.add(branch.units[c], std::max(point.results[c].largest, -point.results[c].smallest));
  return largest;
}

/// Amplitude and phase of one result.
void add_columns_of(std::size_t c, const SteadyBranch& branch, const LargestOfKind& largest,
                    const Rows<HarmonicOf>& row, Table& table) {
  const std::string &name = branch.results[c], &unit = branch.units[c];
  const std::string amplitude = name + " amplitude", phase = name + " phase", unit_of = "unit of " + name;
  table.columns.push_back(row(unit_of, Kind::words, "", [unit](std::size_t) { return unit; }));
  table.columns.push_back(row(amplitude, Kind::amplitude, name,
                              [c](const HarmonicOf& one) { return std::abs(one.amplitude(c)); },
                              {.unit = "@" + unit_of, .digits = 4}));
  table.columns.push_back(row(phase, Kind::number, "",
                              [c](const HarmonicOf& one) { return std::arg(one.amplitude(c)); }, {.forms = in_csv}));
  table.columns.push_back(row(phase, Kind::number, "phase",
                              [c, unit, largest](const HarmonicOf& one) -> Json {
                                const std::complex<double> value = one.amplitude(c);
                                if (largest.shown(unit, std::abs(value)) == 0) return nullptr;
                                return fmt::format("{:.1f}°", 360 / foundation::two_pi * std::arg(value));
                              },
                              {.forms = for_people}));
  table.csv.emplace_back(fmt::format("{} [{}]", amplitude, unit), amplitude);
  table.csv.emplace_back(phase + " [rad]", phase);
  for (const std::string& column : {amplitude, phase}) table.people.emplace_back(column, column);
}

/// A line for each harmonic, the mean included, SI and rad; for people those that are not small.
Table harmonic_table(const SteadyBranch& branch, std::vector<HarmonicOf> harmonics) {
  const Rows row(std::move(harmonics));
  const auto of_motion = [](auto value) { return [value](const HarmonicOf& one) { return value(one.motion); }; };
  const auto order = [&branch](const HarmonicOf& one) { return branch.first_harmonic * one.harmonic(); };
  Table table{
      .rows = row.size(),
      .columns = {row("angular_frequency", Kind::frequency, "",
                      of_motion([](const PointOfCurve& m) { return m.point->angular_frequency; })),
                  row("load_factor", Kind::number, "",
                      of_motion([](const PointOfCurve& m) { return m.point->load_factor; })),
                  row("motion", Kind::number, "", &HarmonicOf::number),
                  row("curve", Kind::number, "", of_motion([](const PointOfCurve& m) { return m.number; })),
                  row("periods", Kind::number, "", of_motion([](const PointOfCurve& m) { return m.curve->periods; })),
                  row("stable", Kind::words, "",
                      of_motion([](const PointOfCurve& m) { return stability_word(*m.point); })),
                  row("harmonic", Kind::number, "harmonic", &HarmonicOf::harmonic),
                  row("order", Kind::number, branch.of_shaft ? "order" : "", order),
                  row("at", Kind::frequency, branch.of_shaft ? "" : "at",
                      [order](const HarmonicOf& one) { return order(one) * one.motion.point->angular_frequency; })},
      .csv = {"angular_frequency [rad/s]",
              {"load factor", "load_factor"},
              "motion",
              "curve",
              "periods",
              "stable",
              "harmonic",
              "order"},
      .people = {"harmonic"},
      .together = 2,
      .forms = in_csv};
  const LargestOfKind largest = largest_on(branch);
  for (std::size_t c = 0; c < branch.results.size(); ++c) add_columns_of(c, branch, largest, row, table);
  for (const char* column : {"order", "at"}) table.people.emplace_back(column);
  return table;
}

/// The motions at one parameter and their means.
Table motion_table(const SteadyBranch& branch, std::vector<PointOfCurve> motions) {
  const Rows row(std::move(motions));
  Table table{.rows = row.size(),
              .columns = {row("motion", Kind::number, "motion", [](std::size_t i) { return i + 1; }),
                          row("curve", Kind::words, "curve",
                              [](const PointOfCurve& one) {
                                return (one.number == 0 ? "connected" : fmt::format("curve {}", one.number)) +
                                    (one.curve->periods == 2 ? ", twice the period" : "");
                              }),
                          row("stable", Kind::words, "stable",
                              [](const PointOfCurve& one) { return stability_word(*one.point); })},
              .forms = for_people};
  const LargestOfKind largest = largest_on(branch);
  for (std::size_t c = 0; c < branch.results.size(); ++c)
    table.columns.push_back(row(branch.results[c], Kind::quantity, "mean of " + branch.results[c],
                                [c, largest, unit = branch.units[c]](const PointOfCurve& one) {
                                  return largest.shown(unit, one.point->results[c].mean);
                                },
                                {.unit = branch.units[c], .digits = 4}));
  return table;
}

}  // namespace

void add_harmonics(const SteadyBranch& branch, Document& document) {
  std::vector<HarmonicOf> all;
  for (const double parameter : branch.requested_at) {
    const std::vector<PointOfCurve> motions = motions_at(branch, parameter);
    document.add(Sentence{.parts = {"At ", varied_quantity(branch, parameter, 6), ": ",
                                    motions.empty()           ? "no motion is known"
                                        : motions.size() == 1 ? "one motion is known"
                                                              : fmt::format("{} motions are known", motions.size())}});
    document.add(motion_table(branch, motions));
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const std::vector<HarmonicOf> harmonics = harmonics_of(motions[i], i + 1);
      all.insert(all.end(), harmonics.begin(), harmonics.end());
      Table& table = document.add(harmonic_table(branch, harmonics));
      table.title = fmt::format("Motion {}", i + 1);
      table.forms = for_people;
      table.people_rows.emplace();
      for (std::size_t k = 0; k < harmonics.size(); ++k)
        if (is_shown(harmonics[k])) table.people_rows->push_back(k);
      const std::size_t hidden = harmonics.size() - 1 - table.people_rows->size();
      if (hidden > 0)
        document.add(
            steady_item({fmt::format("{} of {} harmonics, below 1e-6 of the largest of every result, are not listed",
                                     hidden, harmonics.size() - 1)}));
    }
  }
  document.add(Sentence{.parts = {"Amplitudes A and phases φ of A cos(kωt + φ) as deviations from rest; excitations "
                                  "begin at t = 0 as in `response`"}});
  document.add(harmonic_table(branch, std::move(all))).file = "steady.csv";
}

namespace {

/// Of all bodies, and of the ends of elements that move with the ground: six complex amplitudes, ground axes, for each
/// harmonic from the mean on.
Json places_json(const std::vector<response::DeflectionShape>& shapes) {
  using response::DeflectionShape;
  using response::MovingPlace;
  Json list = Json::array();
  const auto add = [&](std::vector<MovingPlace> DeflectionShape::* group, auto is_wanted) {
    for (std::size_t p = 0; p < (shapes.front().*group).size(); ++p) {
      const auto moves = [&](const DeflectionShape& shape) { return !(shape.*group)[p].motion.isZero(0); };
      if (!is_wanted((shapes.front().*group)[p]) || std::ranges::none_of(shapes, moves)) continue;
      Json harmonics = Json::array();
      for (const DeflectionShape& shape : shapes) harmonics.push_back(json::list((shape.*group)[p].motion));
      list.push_back({{"name", (shapes.front().*group)[p].name}, {"harmonics", std::move(harmonics)}});
    }
  };
  add(&DeflectionShape::bodies, [](const MovingPlace&) { return true; });
  add(&DeflectionShape::feet, [](const MovingPlace& foot) { return !foot.body; });
  return list;
}

}  // namespace

Json harmonics_json(const SteadyBranch& branch) {
  const auto numbers = [](const Eigen::VectorXd& list) { return std::vector<double>(list.begin(), list.end()); };
  Json list = Json::array();
  for (const double parameter : branch.requested_at) {
    Json one{{branch.over == nonlinear::Parameter::frequency ? "angular_frequency" : "load_factor", parameter},
             {"motions", Json::array()}};
    for (const PointOfCurve& motion : motions_at(branch, parameter)) {
      Json results = Json::array();
      for (const ObservedMotion& result : motion.point->results)
        results.push_back({{"mean", json::number(result.mean)},
                           {"largest", json::number(result.largest)},
                           {"smallest", json::number(result.smallest)},
                           {"rms", json::number(result.rms)},
                           {"amplitudes", numbers(result.harmonics.cwiseAbs())},
                           {"phases", numbers(result.harmonics.cwiseArg())}});
      std::vector<double> orders;
      for (Eigen::Index k = 1; k <= motion.curve->harmonics; ++k)
        orders.push_back(branch.first_harmonic * static_cast<double>(k) / motion.curve->periods);
      one["motions"].push_back({{"curve", motion.number},
                                {"periods", motion.curve->periods},
                                {"stable", motion.point->uncertain ? Json(nullptr) : Json(motion.point->stable)},
                                {"orders", orders},
                                {"places", places_json(motion.point->shapes)},
                                {"results", std::move(results)}});
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace trivet::results
