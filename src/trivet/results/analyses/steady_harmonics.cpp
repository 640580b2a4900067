// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/analyses/steady_harmonics.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/analyses/steady_changes_text.h"
#include "trivet/results/analyses/steady_kinds.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::results {

using nonlinear::ObservedMotion;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;

namespace {

/// A motion at a parameter, and its curve: 0 is the connected one, others are numbered as further ones.
struct FoundMotion {
  std::size_t curve;
  const SteadyBranch& of;
  const SteadyPoint& point;
};

std::vector<FoundMotion> motions_at(const SteadyBranch& branch, double parameter) {
  constexpr double same = 1e-9;
  std::vector<FoundMotion> found;
  const auto add = [&](std::size_t number, const SteadyBranch& curve) {
    for (const SteadyPoint& point : curve.at)
      if (std::abs(curve.parameter(point) - parameter) <= same * parameter) found.push_back({number, curve, point});
  };
  add(0, branch);
  for (std::size_t i = 0; i < branch.further.size(); ++i) add(i + 1, branch.further[i]);
  return found;
}

/// Of harmonic k of a motion over that of the excitation or the shaft.
double order_of(const FoundMotion& motion, Eigen::Index k, const SteadyBranch& branch) {
  return branch.first_harmonic * static_cast<double>(k) / motion.of.periods;
}

double degrees(double radians) { return 360 / foundation::two_pi * radians; }

std::string phase_text(const std::complex<double>& amplitude) {
  return amplitude == 0.0 ? "–" : fmt::format("{:.1f}°", degrees(std::arg(amplitude)));
}

/// Harmonics above round-off and above a millionth of the largest, and those that are excited.
bool is_shown(const FoundMotion& motion, Eigen::Index k) {
  constexpr double small = 1e-6;
  return std::ranges::any_of(motion.point.results, [&](const ObservedMotion& result) {
    return std::abs(result.harmonics(k - 1)) > small * result.harmonics.cwiseAbs().maxCoeff();
  });
}

const char* stability_phrase(const SteadyPoint& point) {
  return point.uncertain ? "of uncertain stability" : point.stable ? "stable" : "unstable";
}

std::string motion_text(const FoundMotion& motion, const SteadyBranch& branch, const project::DisplayUnits& display) {
  const std::vector<double> kinds = largest_of_kinds(branch);
  std::vector<std::string> heads = {"harmonic", branch.of_shaft ? "order" : "at [" + frequency_unit(display) + "]"};
  for (const std::string& result : branch.results) {
    heads.push_back(result);
    heads.push_back("phase");
  }
  TextTable table(heads, 2);
  std::vector<std::string> mean = {"mean", ""};
  for (std::size_t c = 0; c < branch.results.size(); ++c) {
    mean.push_back(
        value_text(without_round_off(motion.point.results[c].mean, kinds[c]), display_unit(display, branch.units[c])));
    mean.emplace_back("");
  }
  table.add(mean);
  const Eigen::Index harmonics = motion.of.harmonics;
  int hidden = 0;
  for (Eigen::Index k = 1; k <= harmonics; ++k) {
    if (!is_shown(motion, k)) {
      ++hidden;
      continue;
    }
    const double order = order_of(motion, k, branch);
    std::vector<std::string> row = {
        number_text(static_cast<double>(k) / motion.of.periods),
        number_text(branch.of_shaft ? order : shown_frequency(display, order * motion.point.angular_frequency), 6)};
    for (std::size_t c = 0; c < branch.results.size(); ++c) {
      std::complex<double> amplitude = motion.point.results[c].harmonics(k - 1);
      if (without_round_off(std::abs(amplitude), kinds[c]) == 0) amplitude = 0;
      row.push_back(value_text(std::abs(amplitude), amplitude_unit(display, branch.units[c])));
      row.push_back(phase_text(amplitude));
    }
    table.add(row);
  }
  return table.text() +
      (hidden > 0 ? fmt::format("  {} of {} harmonics, below 1e-6 of the largest of every result, are not listed\n",
                                hidden, harmonics)
                  : "");
}

}  // namespace

std::string harmonics_text(const SteadyBranch& branch, const project::DisplayUnits& display) {
  std::string text;
  for (const double parameter : branch.requested_at) {
    const std::vector<FoundMotion> motions = motions_at(branch, parameter);
    text += fmt::format("At {} {}: {}\n", number_text(shown_varied(branch, parameter, display), 6),
                        varied_unit(branch, display),
                        motions.empty()           ? "no motion is known"
                            : motions.size() == 1 ? "one motion is known"
                                                  : fmt::format("{} motions are known", motions.size()));
    for (std::size_t i = 0; i < motions.size(); ++i)
      text +=
          fmt::format("Motion {}, {}{}: {}\n", i + 1,
                      motions[i].curve == 0 ? "connected" : fmt::format("of curve {}", motions[i].curve),
                      motions[i].of.periods == 2 ? ", of twice the period" : "", stability_phrase(motions[i].point)) +
          motion_text(motions[i], branch, display);
  }
  return text +
      "Amplitudes A and phases φ of A cos(kωt + φ) as deviations from rest; excitations begin at t = 0 as in " +
      "`response`\n";
}

std::string harmonics_csv(const SteadyBranch& branch) {
  std::string text = "angular_frequency [rad/s],load factor,motion,curve,periods,stable,harmonic,order";
  for (std::size_t c = 0; c < branch.results.size(); ++c)
    text += "," + csv_field(fmt::format("{} amplitude [{}]", branch.results[c], branch.units[c])) + "," +
        csv_field(branch.results[c] + " phase [rad]");
  text += "\n";
  for (const double parameter : branch.requested_at) {
    const std::vector<FoundMotion> motions = motions_at(branch, parameter);
    for (std::size_t i = 0; i < motions.size(); ++i)
      for (Eigen::Index k = 0; k <= motions[i].of.harmonics; ++k) {
        const auto& [curve, of, point] = motions[i];
        text +=
            fmt::format("{},{},{},{},{},{},{},{}", point.angular_frequency, point.load_factor, i + 1, curve, of.periods,
                        stability_word(point), static_cast<double>(k) / of.periods, order_of(motions[i], k, branch));
        for (const ObservedMotion& result : point.results) {
          const std::complex<double> amplitude = k == 0 ? std::complex<double>(result.mean) : result.harmonics(k - 1);
          append_csv_number(text, std::abs(amplitude));
          append_csv_number(text, std::arg(amplitude));
        }
        text += "\n";
      }
  }
  return text;
}

json::Json json::harmonics(const SteadyBranch& branch) {
  Json list = Json::array();
  for (const double parameter : branch.requested_at) {
    Json one{{branch.over == nonlinear::Parameter::frequency ? "angular_frequency" : "load_factor", parameter},
             {"motions", Json::array()}};
    for (const FoundMotion& motion : motions_at(branch, parameter)) {
      Json results = Json::array();
      for (const ObservedMotion& result : motion.point.results) {
        Json amplitudes = Json::array(), phases = Json::array();
        for (const std::complex<double>& amplitude : result.harmonics) {
          amplitudes.push_back(number(std::abs(amplitude)));
          phases.push_back(number(std::arg(amplitude)));
        }
        results.push_back({{"mean", number(result.mean)},
                           {"largest", number(result.largest)},
                           {"smallest", number(result.smallest)},
                           {"rms", number(result.rms)},
                           {"amplitudes", std::move(amplitudes)},
                           {"phases", std::move(phases)}});
      }
      std::vector<double> orders;
      for (Eigen::Index k = 1; k <= motion.of.harmonics; ++k) orders.push_back(order_of(motion, k, branch));
      one["motions"].push_back({{"curve", motion.curve},
                                {"periods", motion.of.periods},
                                {"stable", motion.point.uncertain ? Json(nullptr) : Json(motion.point.stable)},
                                {"orders", orders},
                                {"results", std::move(results)}});
    }
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace trivet::results
