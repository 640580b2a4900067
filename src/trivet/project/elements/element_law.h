// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/elements/element_table_readers.h"

namespace trivet::project {

/// Ends of an element.
struct Placement {
  model::Span span;
  bool known = false;       ///< its ends could be read; else the span is 0 and the law is read only for its problems
  double damping_at = 0.5;  ///< fraction of the way from N to K where constants of `damping` act; a law may change it
};

/// A stiffness over frequency from a CSV file, of the types table, air_spring and wire_rope.
void read_tabulated(TableReader& reader, Placement& ends, model::Element& element);

/// One type of element in the project file. Each is defined next to its reader in this folder, as TYPE_law.
struct ElementLaw {
  const char* type;  ///< "beam"; "catalogue:NAME" for every word that begins with "catalogue:"

  /// Reader of a law with its own length: it fills law and facts, in local axes with e3 from N to K.
  ElementLength (*sized)(TableReader& reader, model::Element& element) = nullptr;
  /// Or the reader of a law between ends that the project file places.
  void (*placed)(TableReader& reader, Placement& ends, model::Element& element) = nullptr;

  bool takes_damping = true;  ///< has the table `damping` of all elements
  bool takes_laws = true;     ///< and the table `laws`
  /// JSON Schema of its own keys: `properties`, `required`, `with` for groups of keys that several laws share
  /// (`shared_keys` in project.schema.json) …; or a list of variants.
  const char* keys;

  [[nodiscard]] bool is(const std::string& word) const;
};

/// All types of elements, in the order of lists in messages. A new one is a line here and its TYPE_law.
// clang-format off
#define TRIVET_ELEMENT_LAWS(row) \
  row(matrix) \
  row(bushing) \
  row(three_springs) \
  row(damper) \
  row(imported) \
  row(measured) \
  row(table) \
  row(air_spring) \
  row(wire_rope) \
  row(hydromount) \
  row(coil_spring) \
  row(rubber_disc) \
  row(rubber_block) \
  row(rubber_bush) \
  row(sandwich) \
  row(solid_mount) \
  row(beam) \
  row(link) \
  row(stay) \
  row(stop) \
  row(strut) \
  row(catalogue)
// clang-format on

#define TRIVET_LAW(name) extern const ElementLaw name##_law;
TRIVET_ELEMENT_LAWS(TRIVET_LAW)
#undef TRIVET_LAW

[[nodiscard]] const std::vector<const ElementLaw*>& element_laws();

/// The law of that type; null if there is no such type.
[[nodiscard]] const ElementLaw* element_law(const std::string& type);

}  // namespace trivet::project
