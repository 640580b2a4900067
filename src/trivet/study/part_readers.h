// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/model/system.h"
#include "trivet/study/analyses.h"
#include "trivet/study/table_reader.h"

/// One function per part of a project file; each adds to the description and reports its problems.
namespace trivet::study {

/// Names that stand in the file, whether what they name could be read or not: a reference to an unreadable thing is no
/// second problem.
struct Mentioned {
  bool bodies_unknown = false;  ///< there is no readable table of bodies at all
  std::vector<std::string> bodies, points, elements, harmonic_excitations, constant_excitations;
  std::vector<std::string> order_excitations, random_excitations, time_excitations;  ///< an unbalance drives harmonically and by orders
  struct Standing {
    std::string element, ground;
    foundation::Origin origin;
  };
  std::vector<Standing> stands_on;  ///< elements and the foundations that they name
  std::vector<std::string> guided;  ///< "body.y": coordinates that do not move
};

void read_bodies(TableReader& root, model::Description& description, Mentioned& mentioned);
void read_elements(TableReader& root, model::Description& description, Mentioned& mentioned);
void read_system_damping(TableReader& root, model::Description& description);
void read_excitations(TableReader& root, model::Description& description, Mentioned& mentioned);
[[nodiscard]] Analyses read_analyses(TableReader& root, const Mentioned& mentioned);

/// The body of that name, if it was read; a name that stands nowhere is a problem at `key`.
[[nodiscard]] std::optional<std::size_t> body_named(TableReader& reader, const std::string& key, const model::Description& description,
                                                    const Mentioned& mentioned);

}  // namespace trivet::study
