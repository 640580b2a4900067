// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/model/model_words.h"

/// What excitations do over speed, frequency or time.
namespace trivet::results {
namespace {

std::string course_number(double value) { return number_text(value, 5); }

/// "Fz 18 N at 30°": the components that are not zero, with the units of a force and a moment followed by `per`.
std::string component_list(const excitation::ComplexVector6& values, const std::string& per) {
  static constexpr std::array names = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
  std::string words;
  for (int j = 0; j < 6; ++j) {
    const std::complex<double> value = values(j);
    if (value == 0.0) continue;
    const double degrees = std::arg(value) * 360 / foundation::two_pi;
    words += fmt::format("{}{} {} {}{}{}", words.empty() ? "" : ", ", names[static_cast<std::size_t>(j)],
                         course_number(std::abs(value)), j < 3 ? "N" : "N m", per,
                         degrees == 0 ? "" : fmt::format(" at {}°", course_number(degrees)));
  }
  return words;
}

/// SI unit of the course of an excitation.
const char* course_unit(const model::Action& action) {
  const bool turns = action.amplitude.head<3>().isZero(0);
  if (action.body) return turns ? "N m" : "N";
  static constexpr std::array ways = {"m", "m/s", "m/s²"}, angles = {"rad", "rad/s", "rad/s²"};
  const auto order = static_cast<std::size_t>(action.derivative);
  return turns ? angles[order] : ways[order];
}

struct CourseFacts {
  const model::Excitation& excitation;

  std::vector<model::Fact> operator()(const model::Harmonic&) const {
    if (excitation.service_speed <= 0) return {};
    constexpr double seconds_per_minute = 60;
    return {
        {"service speed", course_number(excitation.service_speed * seconds_per_minute / foundation::two_pi) + " rpm"}};
  }
  std::vector<model::Fact> operator()(const model::Orders& orders) const {
    std::vector<model::Fact> facts;
    for (const excitation::Order& order : orders.list) {
      const std::string fixed = component_list(order.fixed, "");
      std::string words = component_list(order.per_speed_squared, "/(rad/s)² × Ω²");
      if (!fixed.empty()) words += (words.empty() ? "" : "; ") + fixed;
      facts.push_back({fmt::format("order {:.6g}", order.order), words.empty() ? "0" : words});
    }
    return facts;
  }
  std::vector<model::Fact> operator()(const model::Random& random) const {
    const excitation::Spectrum& spectrum = random.spectrum;
    std::vector<model::Fact> facts = {
        {"spectrum",
         fmt::format("{} … {} Hz in {} {}", course_number(spectrum.from() / foundation::two_pi),
                     course_number(spectrum.to() / foundation::two_pi), spectrum.pieces.size(),
                     spectrum.pieces.size() == 1 ? "piece" : "pieces")},
        {"rms", course_number(excitation::rms(spectrum)) + " " + course_unit(excitation.action)}};
    for (const model::Random::Partner& partner : random.partners)
      facts.push_back(
          {"coherent with " + partner.other, fmt::format("γ² = {:.6g} at ω = 0", partner.coherence.at_zero)});
    return facts;
  }
  std::vector<model::Fact> operator()(const model::History& history) const {
    const std::vector<excitation::Piece>& pieces = history.signal.pieces;
    if (pieces.empty()) return {};
    double largest = 0;
    for (const excitation::Piece& piece : pieces) largest = std::max(largest, std::abs(piece.value));
    return {
        {"history",
         fmt::format("{} pieces, which begin at {} … {} s", pieces.size(), course_number(pieces.front().start),
                     course_number(pieces.back().start))},
        {"largest value at the beginning of a piece", course_number(largest) + " " + course_unit(excitation.action)}};
  }
};

}  // namespace

std::vector<model::Fact> course_facts(const model::Excitation& excitation) {
  return std::visit(CourseFacts{excitation}, excitation.course);
}

}  // namespace trivet::results
