// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/tolerance_reach.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::judging {
namespace {

/// The share of draws that take the number at a place to the other side of 0, or to 0 if that counts.
double share_beyond_zero(const project::Tolerance& tolerance, std::size_t place, double given, bool with_zero) {
  const double factor = tolerance.places[place].factor;
  const double at_zero = tolerance.relative ? 1 - 1 / factor : -given / factor;
  const double infinity = std::numeric_limits<double>::infinity();
  const auto up_to = [&](double value) { return numerics::share_up_to(tolerance.distribution, value); };
  const bool falls = tolerance.relative ? factor > 0 : (given > 0) == (factor > 0);
  if (falls) return up_to(with_zero ? at_zero : std::nextafter(at_zero, -infinity));
  return 1 - up_to(with_zero ? std::nextafter(at_zero, -infinity) : at_zero);
}

/// Why the model has no number here; none if it has.
std::optional<foundation::Problem> refusal(const project::Case& base, const project::ModelNumber& number,
                                           double value) {
  const auto system = changed_system(base, {{number, value}});
  if (system) return std::nullopt;
  return foundation::error_of(system.error());
}

std::string percent(double share) {
  return share < 1e-4 ? fmt::format("{:.1g} %", 100 * share) : fmt::format("{:.3g} %", 100 * share);
}

/// A truncation that keeps a number on its side of zero, as the standard deviation is written.
std::string end_before_zero(const project::Case& base, const project::Tolerance& tolerance, const std::string& path,
                            double given) {
  constexpr double share = 0.9;
  if (tolerance.relative) return "\"90 %\"";
  const auto quantity = project::quantity_at(base.document, project::path_keys(path));
  const std::string unit = quantity ? project::printed_si_unit(*quantity) : "";
  return unit.empty() ? fmt::format("{:.6g}", share * std::abs(given))
                      : fmt::format("\"{:.6g} {}\"", share * std::abs(given), unit);
}

/// The place of a tolerance that reaches zero most often.
struct Beyond {
  double share = 0;
  std::string path;
  double given = 0;
  bool with_zero = false;  ///< 0 is impossible too
  foundation::Problem refusal;

  /// "< 0", or "≤ 0"; those of a negative number "> 0", or "≥ 0"
  [[nodiscard]] const char* words() const {
    if (given > 0) return with_zero ? "≤ 0" : "< 0";
    return with_zero ? "≥ 0" : "> 0";
  }
};

void add_beyond_zero(const project::Case& base, const project::Tolerance& tolerance, const Beyond& worst,
                     foundation::Problems& found) {
  using numerics::DistributionShape;
  const DistributionShape shape = tolerance.distribution.shape;
  const bool unbounded = shape == DistributionShape::normal || shape == DistributionShape::lognormal;
  const std::string subject = "tolerances." + foundation::path_key(tolerance.name);
  const std::string finding = fmt::format("{} of its numbers at {} are {}", percent(worst.share),
                                          foundation::quoted(worst.path), worst.words());
  const std::string rule = fmt::format("the model has none of these: {}", worst.refusal.rule);
  const std::string remedy = unbounded
      ? "add truncated_at = " + end_before_zero(base, tolerance, worst.path, worst.given) + ", or a lower deviation"
      : shape == DistributionShape::measured ? "check the measured numbers"
                                             : "lower its half width, or take standard_deviation with truncated_at";
  foundation::Problem& problem = worst.share > most_impossible
      ? found.error(subject, finding, rule, remedy)
      : found.warning(subject, finding, rule + "; these designs count as failed", remedy);
  problem.origin = project::deepest(base.written, "tolerances." + tolerance.name).origin;
}

}  // namespace

foundation::Problems tolerance_reach(const project::Case& base) {
  constexpr double occurs = 1e-9;  // in the largest study
  foundation::Problems found;
  for (const project::Tolerance& tolerance : base.analyses.tolerances) {
    std::optional<Beyond> worst;
    for (std::size_t place = 0; place < tolerance.places.size(); ++place) {
      const std::string& path = tolerance.places[place].path;
      const project::ModelNumber number(path, "");
      const auto given = number.read(base);
      if (!given || *given == 0) continue;
      if (share_beyond_zero(tolerance, place, *given, true) < occurs) continue;
      constexpr double just_beyond = -1e-3;
      const auto refused = refusal(base, number, just_beyond * *given);
      if (!refused || refusal(base, number, *given)) continue;  // that the file has no model says nothing of zero
      const bool with_zero = refusal(base, number, 0).has_value();
      const double share = share_beyond_zero(tolerance, place, *given, with_zero);
      if (share >= occurs && (!worst || share > worst->share)) worst = {share, path, *given, with_zero, *refused};
    }
    if (worst) add_beyond_zero(base, tolerance, *worst, found);
  }
  return found;
}

}  // namespace trivet::judging
