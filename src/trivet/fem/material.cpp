// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/material.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::fem {
namespace {

Material checked(const Material& material) {
  const foundation::Problems problems = check(material);
  if (problems.has_errors()) throw foundation::InvalidInput(foundation::message(problems.list().front()));
  return material;
}

}  // namespace

Material linear_elastic(double young_modulus, double poisson_ratio) {
  if (!(young_modulus > 0) || !std::isfinite(young_modulus))
    throw foundation::InvalidInput(fmt::format("young_modulus = {} Pa; it must be > 0", young_modulus));
  if (!(poisson_ratio > -1 && poisson_ratio < 0.5))
    throw foundation::InvalidInput(
        fmt::format("poisson_ratio = {}; it must be in (-1, 0.5); for rubber, give the bulk modulus, or 0.4995 (bulk "
                    "modulus about 1000 times the shear modulus)",
                    poisson_ratio));
  return neo_hookean(young_modulus / (2 * (1 + poisson_ratio)), young_modulus / (3 * (1 - 2 * poisson_ratio)));
}

Material neo_hookean(double shear_modulus, double bulk_modulus) {
  return checked({.c10 = shear_modulus / 2, .bulk_modulus = bulk_modulus});
}

Material mooney_rivlin(double c10, double c01, double bulk_modulus) {
  return checked({.c10 = c10, .c01 = c01, .bulk_modulus = bulk_modulus});
}

Material yeoh(double c10, double c20, double c30, double bulk_modulus) {
  return checked({.c10 = c10, .c20 = c20, .c30 = c30, .bulk_modulus = bulk_modulus});
}

double poisson_ratio(const Material& material) {
  const double k = material.bulk_modulus, g = shear_modulus(material);
  return (3 * k - 2 * g) / (6 * k + 2 * g);
}

foundation::Problems check(const Material& material) {
  constexpr double most_stiff_in_volume = 1e8;
  foundation::Problems problems;
  const double g = shear_modulus(material), k = material.bulk_modulus;
  if (!std::isfinite(g + k + material.c20 + material.c30)) {
    problems.error("material", "a constant is not a finite number", "all material constants must be finite",
                   "give numbers in Pa");
    return problems;
  }
  if (!(g > 0))
    problems.error("shear_modulus", fmt::format("{} Pa", g), "the shear modulus 2 (C10 + C01) must be > 0",
                   "check signs and units of the constants");
  if (!(k > 0))
    problems.error("bulk_modulus", fmt::format("{} Pa", k), "the bulk modulus must be > 0", "rubber has about 2 GPa");
  if (g > 0 && k > most_stiff_in_volume * g)
    problems.error("bulk_modulus",
                   fmt::format("{} Pa, {:.1e} times the shear modulus (Poisson's ratio {:.9f})", k, k / g,
                               poisson_ratio(material)),
                   "it must be at most 1e8 times the shear modulus, otherwise double precision is lost",
                   "rubber has about 2 GPa");
  return problems;
}

}  // namespace trivet::fem
