// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"

namespace trivet::project {

/// One mount of a catalogue, in its local axes: e3 is its main axis, from end N to end K.
struct Mount {
  std::string name;
  std::string maker;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< static stiffness [N/m] between the ends, at the middle
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();     ///< [N m/rad], about the middle
  std::optional<double> loss_factor;
  model::Rating rating;                        ///< what it may carry, its mass and price
  double stiffening = 1;                       ///< stiffness in vibration over the static one
  double creep = 1;                            ///< static deflection after years over that at once
  std::optional<Eigen::Vector2d> temperature;  ///< in which it may be used [K]
  std::optional<double> height;                ///< along e3 without load [m]
  std::string source;                          ///< where the numbers come from
  foundation::Origin origin;                   ///< its place in the catalogue
};

/// A TOML file of mounts, read and checked.
struct Catalogue {
  std::string title;
  std::string file;
  std::vector<Mount> mounts;
  foundation::Problems warnings;

  [[nodiscard]] const Mount* find(const std::string& name) const;
};

[[nodiscard]] foundation::Expected<Catalogue> catalogue_from_text(const std::string& text, const std::string& file);
[[nodiscard]] foundation::Expected<Catalogue> read_catalogue(const std::filesystem::path& path);

/// The catalogue that comes with the program: rubber discs by closed forms, no maker's data.
[[nodiscard]] const Catalogue& generic_catalogue();

/// The mount of that name, from the first catalogue that has it; otherwise a problem that proposes the nearest name.
[[nodiscard]] foundation::Expected<Mount> mount_named(const std::string& name,
                                                      const std::vector<Catalogue>& catalogues);

}  // namespace trivet::project
