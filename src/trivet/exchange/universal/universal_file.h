// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace trivet::exchange {

/// Set 151: the origin of a universal file. Dates and times are texts as in the file: "28-Jan-21 14:01:42".
struct UniversalHeader {
  std::string model;             ///< name of the model file
  std::string description;       ///< of the model
  std::string database_program;  ///< program that created the database
  std::string created;           ///< date and time of the database
  std::string saved;             ///< date and time when the database was last saved
  std::string program;           ///< program that wrote the universal file
  std::string written;           ///< date and time of the universal file
};

/// Set 164: units of the numbers in a universal file. A number of the file divided by its factor is in SI.
struct UniversalUnits {
  int code = 1;  ///< 1: m, N; 2: ft, lbf; 3: m, kgf; 4: ft, pdl; 5: mm, mN; 6: cm, cN; 7: in, lbf; 8: mm, kgf; 9: other
  std::string description = "Meter (newton)";
  int temperature_mode = 2;            ///< 1: absolute, 2: relative
  double length = 1;                   ///< length units per metre
  double force = 1;                    ///< force units per newton
  double temperature = 1;              ///< degrees per kelvin
  double temperature_offset = 273.15;  ///< as in the file; not applied to any number
};

/// One point of set 15 or 2411.
struct UniversalNode {
  int label = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m] global; in the definition system if it is not known
  int definition_system = 0;                           ///< coordinate system of the position; 0: global
  int displacement_system = 0;                         ///< coordinate system of displacements; 0: global
  bool in_part = false;        ///< set 2411: positions are global, whatever the definition system
  bool position_known = true;  ///< false: its definition system is not in the file, or not Cartesian
  bool axes_known = true;      ///< false: its displacement system is not in the file, or spherical
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< axes of displacements as columns, global
};

/// Set 82: a polygon of a wire frame.
struct UniversalLine {
  int number = 1;
  std::string name;
  std::vector<int> nodes;  ///< labels in the order of drawing; 0: move to the next node without drawing
};

/// Kind of quantity of an axis or of nodal data. Other codes of a file are kept as numbers.
enum class UniversalQuantity : int {
  unknown = 0,
  general = 1,
  stress = 2,
  strain = 3,
  displacement = 8,
  reaction_force = 9,
  velocity = 11,
  acceleration = 12,
  excitation_force = 13,
  pressure = 15,
  mass = 16,
  time = 17,
  frequency = 18,
  shaft_speed = 19,
  order = 20,
};

/// Kind of function of set 58, codes 0 to 27. Other codes of a file are kept as numbers.
enum class UniversalFunctionType : int {
  general = 0,
  time_response = 1,
  auto_spectrum = 2,
  cross_spectrum = 3,
  frequency_response = 4,
  transmissibility = 5,
  coherence = 6,
  auto_correlation = 7,
  cross_correlation = 8,
  power_spectral_density = 9,
  energy_spectral_density = 10,
  probability_density = 11,
  spectrum = 12,
  cumulative_distribution = 13,
  peaks_and_valleys = 14,
  stress_cycles = 15,
  strain_cycles = 16,
  orbit = 17,
  mode_indicator = 18,
  force_pattern = 19,
  partial_power = 20,
  partial_coherence = 21,
  eigenvalue = 22,
  eigenvector = 23,
  shock_response_spectrum = 24,
  impulse_response_filter = 25,
  multiple_coherence = 26,
  order_function = 27,
};

/// Parameters of a normal mode, analysis type 2.
struct UniversalNormalMode {
  double frequency_hz = 0;
  double modal_mass = 0;          ///< φᵀAφ for the shape φ as it is given here: [kg m²] for shapes in m and rad
  double damping_ratio = 0;       ///< viscous, 1 is critical
  double hysteretic_damping = 0;  ///< as in the file
};

/// Parameters of a complex mode, analysis types 3 and 7.
struct UniversalComplexMode {
  std::complex<double> eigenvalue;        ///< λ [rad/s], decay rate and angular frequency
  std::complex<double> modal_a, modal_b;  ///< scaled like the modal mass
  bool second_order = false;              ///< analysis type 7
};

/// Motion of one node in a mode.
struct UniversalNodeMotion {
  int node = 0;
  std::array<std::complex<double>, 6> components{};  ///< x, y, z translation; x, y, z rotation [rad] if it is known
};

/// Set 55 with a mode shape. A node that is not listed does not move.
struct UniversalMode {
  std::array<std::string, 5> ids;  ///< id lines; empty for NONE
  int load_case = 0, number = 1;
  std::variant<UniversalNormalMode, UniversalComplexMode> parameters;
  UniversalQuantity quantity = UniversalQuantity::displacement;  ///< of the translations: [m], [m/s] or [m/s²]
  bool has_rotations = true;                                     ///< six numbers per node instead of three
  bool is_complex = false;
  std::vector<UniversalNodeMotion> nodes;
  bool in_file_units = false;  ///< not converted to SI, because the quantity is not known
};

/// Natural frequency of a mode [Hz]; |λ|/2π of a complex mode.
[[nodiscard]] double natural_frequency_hz(const UniversalMode& mode);
/// Damping ratio, 1 is critical; −Re λ/|λ| of a complex mode, 0 if λ is zero.
[[nodiscard]] double damping_ratio(const UniversalMode& mode);

/// Powers of length, force and temperature in a unit.
struct UniversalExponents {
  int length = 0, force = 0, temperature = 0;
  bool operator==(const UniversalExponents&) const = default;
};

/// What a file states about the unit of its numbers on one axis.
struct UniversalUnitStatements {
  std::optional<double> by_set;    ///< SI value of one unit by set 164
  std::optional<double> by_label;  ///< the same by the label of the axis, if it is a known one of the quantity
  bool label_turns = false;        ///< the label is one of a rotation or a moment
  std::string label;               ///< as in the file; empty for NONE
};

/// One axis of a function.
struct UniversalAxis {
  UniversalQuantity quantity = UniversalQuantity::unknown;
  UniversalExponents exponents;         ///< as in the file; they count for quantity general only
  std::string label;                    ///< empty for NONE
  std::string unit;                     ///< label of the unit as in the file, or of the SI unit after a conversion
  UniversalUnitStatements stated = {};  ///< of an axis that was read
  double applied_unit = 1;              ///< SI value of one unit of the file by which the numbers were multiplied
};

/// Response or reference of a function.
struct UniversalPoint {
  std::string entity;  ///< empty for NONE
  int node = 0;
  int direction = 0;  ///< 0: scalar; ±1, ±2, ±3: translation along ±x, ±y, ±z; ±4, ±5, ±6: rotation about them
};

/// Evenly spaced abscissa: first, first + step, …, in the unit of the axis.
struct EvenAbscissa {
  double first = 0;
  double step = 1;  ///< > 0
};

enum class UniversalPrecision { single_precision, double_precision };

/// Set 58: a measured or computed function. Its numbers are in SI, with these exceptions: an abscissa that is a
/// frequency is in Hz, a shaft speed in 1/min, and an order is a number.
struct UniversalFunction {
  std::array<std::string, 5> ids;  ///< id lines; empty for NONE
  UniversalFunctionType type = UniversalFunctionType::general;
  int identifier = 0, version = 0, load_case = 0;
  UniversalPoint response, reference;
  UniversalAxis abscissa_axis, numerator, denominator, z_axis;
  double z_value = 0;                                        ///< as in the file
  std::variant<EvenAbscissa, std::vector<double>> abscissa;  ///< of a frequency axis: [Hz]
  std::vector<std::complex<double>> values;                  ///< numerator per denominator
  bool is_complex = true;                                    ///< false: all imaginary parts are zero
  UniversalPrecision precision = UniversalPrecision::double_precision;
  bool in_file_units = false;  ///< ordinates are not converted to SI, because their unit is not known
  int line = 0;                ///< of its set in the file that was read
};

/// Abscissa of every value, in the unit of the axis: [Hz] for a frequency, otherwise SI.
[[nodiscard]] std::vector<double> abscissa_values(const UniversalFunction& function);

/// Content of a universal file (UFF, .unv, .uff), in the order of the file.
struct UniversalFile {
  UniversalHeader header;
  std::optional<UniversalUnits> units_of_file;  ///< last set 164 that was read; the numbers here are already in SI
  std::vector<UniversalNode> nodes;
  std::vector<UniversalLine> lines;
  std::vector<UniversalMode> modes;
  std::vector<UniversalFunction> functions;
};

}  // namespace trivet::exchange
