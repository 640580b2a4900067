// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/project/measured/measured_unit.h"

namespace trivet::project {

/// A function as its file has it.
struct MeasuredFunction {
  std::string name;                              ///< "3:+z", or the name of its columns
  std::vector<std::string> texts;                ///< id lines, or the name of its columns: perhaps the name of a result
  exchange::UniversalPoint response, reference;  ///< node 0: not given
  std::optional<MeasuredUnit> unit;              ///< none: not known; its factor is contained in the values
  std::optional<foundation::Problem> unit_error;  ///< an error if the function is used
  std::vector<double> angular_frequency;          ///< [rad/s]
  Eigen::VectorXcd value;
  Eigen::VectorXd coherence;  ///< empty: not measured
};

/// Content of a file with measured functions and modes.
struct MeasuredFile {
  std::vector<MeasuredFunction> functions;
  std::vector<exchange::UniversalMode> modes;
  std::map<int, Eigen::Vector3d> nodes;  ///< positions in the ground frame
  std::map<int, Eigen::Matrix3d> axes;   ///< of displacements of nodes, as columns, if they are not those of the ground
  std::vector<exchange::UniversalNode> nodes_in_systems;  ///< measured, but not in `nodes`: see measured_places.h
  foundation::Problems warnings;
  foundation::Problems idle_units;  ///< errors of units of the project that are for none of the functions
};

/// Reads a CSV table (name ends in .csv) or a universal file. Lines at 0 Hz and incomplete ones are left out.
/// @param units  of values whose unit the file does not state
/// @param with_coherence  reads coherences of the functions, 0 … 1; a file without one is then an error, and a line
/// without one is incomplete
[[nodiscard]] foundation::Expected<MeasuredFile> read_measured_file(const std::filesystem::path& path,
                                                                    const GivenUnits& units, bool with_coherence);

/// Each is used by `read_measured_file`.
[[nodiscard]] foundation::Expected<MeasuredFile> read_measured_table(const std::filesystem::path& path,
                                                                     const GivenUnits& units, bool with_coherence);
[[nodiscard]] foundation::Expected<MeasuredFile> read_measured_universal(const std::filesystem::path& path,
                                                                         const GivenUnits& units, bool with_coherence);

/// True for a coherence, or one that is rounded.
[[nodiscard]] bool is_coherence(double value);

/// Number of a node, of a text that is nothing else.
[[nodiscard]] std::optional<int> node_number(const std::string& text);

}  // namespace trivet::project
