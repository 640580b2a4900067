// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/axis_effects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/highest_frequency.h"
#include "trivet/project/model_number.h"
#include "trivet/response/steady/visible_amplitudes.h"

namespace trivet::study {
namespace {

constexpr std::array<double, 3> shares = {0, 0.47, 1};  // of both axes; 0.47 avoids a symmetric design in the middle
constexpr std::array<double, 3> frequencies = {0.0137, 0.117, 0.83};  // of the highest natural frequency
constexpr double unchanged = 1e-11;  // of an amplitude; round-off with another load or matrix is below it

/// Amplitudes at one design, answers × frequencies; amplitudes of round-off size are 0.
using Amplitudes = Eigen::Array<double, Eigen::Dynamic, static_cast<int>(frequencies.size())>;

std::vector<std::string> answers_of(const std::vector<design::MapRule>& rules) {
  std::vector<std::string> names;
  for (const design::MapRule& rule : rules)
    if (std::ranges::find(names, rule.answer) == names.end()) names.push_back(rule.answer);
  return names;
}

Amplitudes amplitudes(const model::System& system, const project::MapRequest& request,
                      const std::vector<std::string>& names, double top) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, names, assembly::MotionQuantity::displacement);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled, request.excitations);
  double from = 0, to = std::numeric_limits<double>::infinity();
  for (const assembly::ElementMap& map : assembled.elements)
    from = std::max(from, map.defined_from), to = std::min(to, map.defined_to);
  Amplitudes found(to_index(names.size()), to_index(frequencies.size()));
  for (std::size_t f = 0; f < frequencies.size(); ++f)
    found.col(to_index(f)) =
        response::visible_amplitudes(assembled, channels, loading, std::max(from, std::min(to, frequencies[f] * top)));
  return found;
}

bool differ(const Amplitudes& a, const Amplitudes& b) { return !((a - b).abs() <= unchanged * a.max(b)).all(); }

}  // namespace

AxisEffects axis_effects(const project::Case& variant, const project::MapRequest& request,
                         const std::vector<design::MapRule>& rules) {
  const std::vector<std::string> names = answers_of(rules);
  const double top = modal::highest_natural_frequency(variant.system, assembly::assemble(variant.system));
  const project::ModelNumber x(request.x), y(request.y);
  std::array<std::array<Amplitudes, shares.size()>, shares.size()> designs;
  Amplitudes largest = Amplitudes::Zero(to_index(names.size()), to_index(frequencies.size()));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (std::size_t j = 0; j < shares.size(); ++j) try {
        const auto system =
            judging::changed_system(variant, {{x, request.x.at(shares[i])}, {y, request.y.at(shares[j])}});
        if (!system) return {};
        designs[i][j] = amplitudes(*system, request, names, top);
        largest = largest.max(designs[i][j]);
      } catch (const foundation::NotComputable&) {
        return {};
      } catch (const foundation::InvalidInput&) {
        return {};
      }
  AxisEffects result{{}, false, false};
  for (std::size_t c = 0; c < names.size(); ++c)
    if (largest.row(to_index(c)).isZero(0)) result.zero_answers.push_back(names[c]);
  for (std::size_t k = 0; k < shares.size(); ++k)
    for (std::size_t i = 1; i < shares.size(); ++i) {
      result.by_x = result.by_x || differ(designs[0][k], designs[i][k]);
      result.by_y = result.by_y || differ(designs[k][0], designs[k][i]);
    }
  return result;
}

}  // namespace trivet::study
