// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/exchange/universal/universal_sets.h"

namespace trivet::exchange {

// The sets with the geometry of a universal file: points and wire frame.

/// Reads set 15 and converts positions to m. An error for each line that is not a node. Coordinate systems are applied
/// later: universal_contents.h.
[[nodiscard]] std::vector<UniversalNode> read_universal_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                              SetProblems& problems);

/// The same of set 2411: nodes in double precision, two lines each.
[[nodiscard]] std::vector<UniversalNode> read_universal_part_nodes(const UniversalSet& set, const UniversalUnits& units,
                                                                   SetProblems& problems);

/// Reads set 82. nullopt with an error if it has fewer nodes than announced; a warning if it has more.
[[nodiscard]] std::optional<UniversalLine> read_universal_line(const UniversalSet& set, SetProblems& problems);

struct UniversalModeSet {
  std::optional<UniversalMode> mode;      ///< none if the set is wrong, or not a mode
  std::optional<UniversalMode> response;  ///< motions at one frequency of a frequency response, in units of the file
  std::string other_content;              ///< "analysis type 5" if the set is neither
};

/// Reads set 55 if it is a normal or complex mode with translations or with translations and rotations, and converts it
/// to SI. Errors for records that are incomplete or not numbers.
[[nodiscard]] UniversalModeSet read_universal_mode(const UniversalSet& set, const UniversalUnits& units,
                                                   SetProblems& problems);

/// The same of set 2414 with results at nodes, as Simcenter, NX and other finite element programs write them.
[[nodiscard]] UniversalModeSet read_universal_analysis_mode(const UniversalSet& set, const UniversalUnits& units,
                                                            SetProblems& problems);

/// Number of elements of set 2412.
[[nodiscard]] int count_universal_elements(const UniversalSet& set);

// Coordinate systems of a universal file.

enum class UniversalSystemType : int { cartesian = 0, cylindrical = 1, spherical = 2 };

struct UniversalSystem {
  int label = 0;
  UniversalSystemType type = UniversalSystemType::cartesian;
  int reference = 0;                                   ///< system in which it is given; 0: global
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its axes as columns, in the reference
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< [m] in the reference
};

/// Reads set 18: systems by origin, a point on +x and a point in the +xz plane. Systems defined in another way, or
/// without three different points, are left out with a warning; so is what follows a wrong line.
[[nodiscard]] std::vector<UniversalSystem> read_universal_systems(const UniversalSet& set, const UniversalUnits& units,
                                                                  SetProblems& problems);

/// Reads set 2420: systems by a matrix, the first three rows of which are the axes and the fourth is the origin.
[[nodiscard]] std::vector<UniversalSystem> read_universal_part_systems(const UniversalSet& set,
                                                                       const UniversalUnits& units,
                                                                       SetProblems& problems);

/// Applies the systems to the nodes: positions become global, and each node gets its axes of displacement. Nodes in
/// systems that are not known, or whose position is in a system that is not Cartesian, are marked.
void apply_systems(const std::vector<UniversalSystem>& systems, std::vector<UniversalNode>& nodes);

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
