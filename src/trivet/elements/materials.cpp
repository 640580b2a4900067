// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::elements {
namespace {

struct LindleyRow {
  double irhd, shear_modulus;  // [Pa]
};
// P. B. Lindley, Engineering Design with Natural Rubber, 4th ed. 1974: small-strain shear modulus of natural rubber
// vulcanizates, carbon black above 48 IRHD.
constexpr std::array<LindleyRow, 10> lindley = {{{30, 0.30e6},
                                                 {35, 0.37e6},
                                                 {40, 0.45e6},
                                                 {45, 0.54e6},
                                                 {50, 0.64e6},
                                                 {55, 0.81e6},
                                                 {60, 1.06e6},
                                                 {65, 1.37e6},
                                                 {70, 1.73e6},
                                                 {75, 2.22e6}}};

}  // namespace

const std::vector<Metal>& metals() {
  static const std::vector<Metal> list = {
      {"spring_steel", 206e9, 81.5e9, 7850, "EN 13906-1, patented cold-drawn wire (EN 10270-1)"},
      {"oil_tempered_spring_steel", 206e9, 79.5e9, 7850, "EN 13906-1, oil-hardened and tempered wire (EN 10270-2)"},
      {"stainless_spring_steel", 185e9, 70e9, 7900, "EN 13906-1, X10CrNi18-8 (EN 10270-3)"},
      {"structural_steel", 210e9, 81e9, 7850, "EN 1993-1-1, 3.2.6"},
      {"aluminium", 70e9, 27e9, 2700, "EN 1999-1-1, 3.2.5"},
  };
  return list;
}

std::optional<Metal> metal(std::string_view name) {
  const auto found = std::ranges::find(metals(), name, &Metal::name);
  return found == metals().end() ? std::nullopt : std::optional(*found);
}

double young_modulus(const Rubber& rubber) {
  return 9 * rubber.shear_modulus / (3 + rubber.shear_modulus / rubber.bulk_modulus);
}

double poisson_ratio(const Rubber& rubber) {
  const double ratio = rubber.shear_modulus / rubber.bulk_modulus;
  return (3 - 2 * ratio) / (6 + 2 * ratio);
}

double young_modulus_from_hardness(double hardness) {
  if (!(hardness > 0 && hardness < 100))
    throw foundation::InvalidInput(fmt::format("rubber hardness {:.6g}, must be between 0 and 100", hardness));
  return 1e6 * 0.0981 * (56 + 7.62336 * hardness) / (0.137505 * (254 - 2.54 * hardness));
}

double shear_modulus_from_irhd(double irhd) {
  if (!(irhd >= lindley.front().irhd && irhd <= lindley.back().irhd))
    throw foundation::InvalidInput(fmt::format("rubber hardness {:.6g} IRHD, the table covers {} … {} IRHD", irhd,
                                               lindley.front().irhd, lindley.back().irhd));
  std::size_t i = 1;
  while (lindley[i].irhd < irhd) ++i;
  const auto &below = lindley[i - 1], &above = lindley[i];
  return below.shear_modulus +
      (above.shear_modulus - below.shear_modulus) * (irhd - below.irhd) / (above.irhd - below.irhd);
}

foundation::Problems check_hardness(double hardness) {
  constexpr double softest = 30, hardest = 80;
  foundation::Problems problems;
  const std::string value = fmt::format("hardness = {:.6g}", hardness);
  if (!(hardness > 0 && hardness < 100))
    problems.error("hardness", value, "a hardness must be between 0 and 100 degrees", "give Shore A or IRHD degrees");
  else if (hardness < softest || hardness > hardest)
    problems.warning("hardness", value, "the relation to a modulus is tested for 30 … 80 degrees",
                     "give a measured shear modulus instead: G = \"0.8 MPa\"");
  return problems;
}

foundation::Problems check(const Rubber& rubber) {
  constexpr double lowest_bulk_ratio = 50;
  foundation::Problems problems;
  if (!(rubber.shear_modulus > 0) || !std::isfinite(rubber.shear_modulus))
    problems.error("shear_modulus", fmt::format("shear_modulus = {:.6g} Pa", rubber.shear_modulus), "it must be > 0",
                   "rubber has about 0.3 … 3 MPa");
  if (!(rubber.bulk_modulus > 0))
    problems.error("bulk_modulus", fmt::format("bulk_modulus = {:.6g} Pa", rubber.bulk_modulus), "it must be > 0",
                   "rubber has about 1 … 3 GPa");
  else if (rubber.bulk_modulus < lowest_bulk_ratio * rubber.shear_modulus)
    problems.warning("bulk_modulus",
                     fmt::format("bulk_modulus = {:.4g} Pa is {:.3g} of the shear modulus", rubber.bulk_modulus,
                                 rubber.bulk_modulus / rubber.shear_modulus),
                     "the formulas are for nearly incompressible rubber, a ratio of at least 50",
                     "use a finite-element mount for foams and cork");
  return problems;
}

}  // namespace trivet::elements
