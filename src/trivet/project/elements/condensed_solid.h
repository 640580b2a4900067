// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/solid_states.h"
#include "trivet/project/elements/solid_stroke.h"

/// Solids that are meshed and condensed onto their two plates, or taken from the cache of an earlier run.
namespace trivet::project {

/// Axial compression before vibration [m], or the force that causes it [N].
struct Compression {
  double value = 0;
  bool is_force = false;
};

/// Reads preload = {compression = …} or {force = …}.
[[nodiscard]] std::optional<Compression> read_compression(TableReader& reader);

/// Reads mooney_rivlin = [c10, c01] or yeoh = [c10, c20, c30] in place of the shear modulus of a rubber.
void read_large_strain(TableReader& reader, fem::Material& material);

/// All constants of a material, for the key of the cache.
[[nodiscard]] std::string constants_text(const fem::Material& material);

/// Gives the element the stiffness, preloaded or not, of the solid that `make` builds, over a stroke also its force
/// along e3. Returns the distance of the plates in the preloaded state; none without preload or after reporting errors.
[[nodiscard]] ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                                      const std::optional<Compression>& compression,
                                      const std::optional<Stroke>& stroke, model::Element& element);

}  // namespace trivet::project
