// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

/// Collects sets 2414 with the motions of all nodes at one frequency each to spectra (function type 12) of each node
/// and direction over frequency. A set whose frequency is not above that of the one
/// before, of the same load case and quantity, begins another case.
class UniversalResponses {
 public:
  /// @param motions  in the units of the file; the frequency is that of a normal mode
  void add(const UniversalSet& set, const UniversalMode& motions, const std::optional<UniversalUnits>& units);

  /// The functions in SI, in the order of nodes and directions. A direction with zeros alone has none.
  [[nodiscard]] std::vector<UniversalFunction> functions(FileProblems& problems) const;

 private:
  /// Load case in the file, its case that began by a lower frequency, quantity, node, direction.
  using Key = std::tuple<int, int, int, int, int>;

  std::map<Key, UniversalFunction> functions_;
  /// Of a load case and quantity: its last frequency, and how often it began again.
  struct Last {
    double hertz = 0;
    int cases = 0;
  };
  std::map<std::pair<int, int>, Last> last_;
  std::optional<UniversalSet> first_;
  std::optional<UniversalUnits> units_;
};

}  // namespace trivet::exchange
