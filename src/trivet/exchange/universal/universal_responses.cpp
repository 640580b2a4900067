// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_contents.h"

#include <algorithm>
#include <utility>

#include "trivet/exchange/universal/universal_functions.h"

namespace trivet::exchange {

void UniversalResponses::add(const UniversalSet& set, const UniversalMode& motions,
                             const std::optional<UniversalUnits>& units) {
  if (!first_) {
    first_ = set;
    units_ = units;
  }
  const double hertz = natural_frequency_hz(motions);
  const int quantity = static_cast<int>(motions.quantity);
  const auto [found, is_first] = last_.try_emplace({motions.load_case, quantity}, Last{hertz, 0});
  Last& last = found->second;
  if (!is_first && hertz <= last.hertz) ++last.cases;
  last.hertz = hertz;
  const int directions = motions.has_rotations ? 6 : 3;
  for (const UniversalNodeMotion& node : motions.nodes)
    for (int direction = 1; direction <= directions; ++direction) {
      UniversalFunction& function = functions_[{motions.load_case, last.cases, quantity, node.node, direction}];
      if (function.values.empty()) {
        function.ids = motions.ids;
        function.type = UniversalFunctionType::spectrum;
        function.load_case = motions.load_case;
        function.response = {"", node.node, direction};
        function.abscissa_axis = {.quantity = UniversalQuantity::frequency, .unit = "Hz"};
        function.numerator.quantity = motions.quantity;
        function.abscissa = std::vector<double>();
        function.line = set.line;
      }
      std::get<std::vector<double>>(function.abscissa).push_back(hertz);
      function.values.push_back(node.components[direction - 1]);
    }
}

std::vector<UniversalFunction> UniversalResponses::functions(FileProblems& problems) const {
  std::vector<UniversalFunction> result;
  if (!first_) return result;
  SetProblems of_set(problems, *first_);
  for (const auto& [key, collected] : functions_) {
    const auto is_zero = [](const std::complex<double>& value) { return value == 0.0; };
    if (std::ranges::all_of(collected.values, is_zero)) continue;
    UniversalFunction function = collected;
    convert_to_si(function, units_, function.line, of_set);
    result.push_back(std::move(function));
  }
  return result;
}

}  // namespace trivet::exchange
