// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/problems.h"

namespace trivet::elements {

/// An isotropic metal at 20 °C.
struct Metal {
  std::string name;
  double young_modulus = 0;  ///< [Pa]
  double shear_modulus = 0;  ///< [Pa]
  double density = 0;        ///< [kg/m³]
  std::string source;
};

/// Spring and structural metals by name: "spring_steel", "stainless_spring_steel", …
[[nodiscard]] const std::vector<Metal>& metals();
[[nodiscard]] std::optional<Metal> metal(std::string_view name);

/// Nearly incompressible rubber at small strain, both moduli for the same frequency [Pa], > 0. E = 9KG/(3K + G), about
/// 3G.
struct Rubber {
  double shear_modulus = 0;
  double bulk_modulus = 2e9;  ///< unfilled to lightly filled natural rubber 1 … 2.5 GPa; infinity = incompressible
};

[[nodiscard]] double young_modulus(const Rubber& rubber);
[[nodiscard]] double poisson_ratio(const Rubber& rubber);

/// Static small-strain Young's modulus [Pa] from Shore A or IRHD (equal within a few degrees from 30 to 80): Gent 1958,
/// by the indentation theory of the durometer, E = 0.0981(56 + 7.62336 H)/(0.137505(254 − 2.54 H)) MPa. A reading has
/// an error of ±2 … 5 degrees and compounds scatter by about ±20 %. G = E/3. @throws InvalidInput outside 0 < hardness
/// < 100
[[nodiscard]] double young_modulus_from_hardness(double hardness);
/// Measured small-strain shear modulus [Pa] of carbon-black natural rubber, IRHD 30 … 75 (Lindley 1974), linear between
/// the rows.
/// @throws InvalidInput outside the table
[[nodiscard]] double shear_modulus_from_irhd(double irhd);

/// Errors outside (0, 100); warning outside 30 … 80.
[[nodiscard]] foundation::Problems check_hardness(double hardness);
[[nodiscard]] foundation::Problems check(const Rubber& rubber);

}  // namespace trivet::elements
