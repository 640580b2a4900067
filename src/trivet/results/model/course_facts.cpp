// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/model/band_levels.h"
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

/// Measured levels of bands as they were given, or the root mean square of each piece of the spectrum.
std::vector<model::Fact> piece_facts(const excitation::Spectrum& spectrum, const model::Excitation& excitation) {
  constexpr std::size_t most = 60;  // more are the lines of a record
  std::vector<model::Fact> facts;
  if (spectrum.pieces.size() > most) return facts;
  const auto add = [&facts](const std::string& where, double rms, const std::string& unit) {
    facts.push_back({where, value_text(rms, display_unit({}, unit)) + " rms"});
  };
  if (const std::optional<BandLevels> levels = band_levels(excitation)) {
    for (std::size_t i = 0; i < levels->bands.size(); ++i)
      add(fmt::format("{} band of {:.5g} Hz", excitation::name(levels->width), levels->bands[i].nominal_hz()),
          levels->rms[i], levels->unit);
    return facts;
  }
  for (const excitation::SpectrumPiece& piece : spectrum.pieces)
    add(fmt::format("{} … {} Hz", course_number(piece.from / foundation::two_pi),
                    course_number(piece.to / foundation::two_pi)),
        excitation::rms({{piece}}), course_unit(excitation.action));
  return facts;
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
        {"rms", value_text(excitation::rms(spectrum), display_unit({}, course_unit(excitation.action)))}};
    for (model::Fact& fact : piece_facts(spectrum, excitation)) facts.push_back(std::move(fact));
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
    return {{"history",
             fmt::format("{} pieces, which begin at {} … {} s", pieces.size(), course_number(pieces.front().start),
                         course_number(pieces.back().start))},
            {"largest value at the beginning of a piece",
             value_text(largest, display_unit({}, course_unit(excitation.action)))}};
  }
};

}  // namespace

std::vector<model::Fact> course_facts(const model::Excitation& excitation) {
  return std::visit(CourseFacts{excitation}, excitation.course);
}

}  // namespace trivet::results
