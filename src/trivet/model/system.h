// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/elements/distance_force.h"
#include "trivet/elements/friction.h"
#include "trivet/elements/law.h"
#include "trivet/elements/stiffness_over_deflection.h"
#include "trivet/foundation/problems.h"
#include "trivet/model/excitation.h"
#include "trivet/model/observations.h"
#include "trivet/spatial/mass_properties.h"
#include "trivet/spatial/types.h"

namespace trivet::model {

// Description of the system, checked, not solved. Frames and signs: docs/conventions.md.

struct Point {
  std::string name;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< body frame [m]
};

/// A rigid body; or a node, a place without mass where elements meet. Nodes are last in the list of bodies.
struct Body {
  std::string name;
  spatial::Pose pose;  ///< of the body frame (its origin is the pole) in the ground frame, at rest
  spatial::MassProperties mass;
  bool has_inertia = true;  ///< false only if no rotation is free and no inertia is given
  std::array<bool, 6> free = {true, true, true, true, true, true};  ///< x, y, z, θx, θy, θz
  std::vector<Point> points;
  bool allow_unphysical = false;
  bool is_node = false;               ///< mass and inertia are zero
  std::array<bool, 6> left_out = {};  ///< of a node: directions that no element holds; they are then not free

  /// True if this coordinate is held in space.
  [[nodiscard]] bool is_constrained(std::size_t coordinate) const { return !free[coordinate] && !left_out[coordinate]; }
  /// True if any coordinate is.
  [[nodiscard]] bool is_constrained() const {
    for (std::size_t j = 0; j < free.size(); ++j)
      if (is_constrained(j)) return true;
    return false;
  }
};

/// Path in the project file: "bodies.NAME", "nodes.NAME".
[[nodiscard]] inline std::string path_of(const Body& body) { return (body.is_node ? "nodes." : "bodies.") + body.name; }

/// A flexible foundation with its own coordinates p: A p̈ + B ṗ + K p = forces on its ends. Either one ground point
/// with its impedance, or the modes of a deck.
struct Foundation {
  std::string name;
  Eigen::MatrixXd mass, damping, stiffness;  ///< all r × r
};

/// Motion of an element end on a foundation.
struct OnFoundation {
  std::size_t foundation = 0;
  Eigen::Matrix<double, 6, Eigen::Dynamic> shape;  ///< motion of the end, ground axes, per unit of each coordinate
  /// Projector on the directions in which the end moves with the rigid ground at this place, ground axes: all that
  /// `shape` does not move, or all if the coordinates are relative to the ground. Zero for the modes of a deck: the
  /// data do not define how a deck moves with the ground.
  spatial::Matrix6 fixed_directions = spatial::Matrix6::Zero();
};

/// One end of an element: on a body or node, on a foundation, or on the ground if neither is given.
struct End {
  std::optional<std::size_t> body;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< reference point, in the frame of the body or the ground [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< local axes as columns, in the same frame
  std::optional<OnFoundation> foundation;              ///< then `at` and `axes` are in the ground frame

  [[nodiscard]] bool on_ground() const { return !body && !foundation; }
};

/// A fact about how an element was determined: "spring rate", "12.3 N/mm".
struct Fact {
  std::string what, value;
};

/// A sum of money.
struct Price {
  double amount = 0;
  std::string currency;  ///< "EUR"
  bool operator==(const Price&) const = default;
};

/// What the maker of a mount allows, in its axes at end N (e3 from end N to end K), and what the mount costs.
struct Rating {
  std::string mount;  ///< its name in the catalogue
  /// Lowest and highest static load along e1, e2, e3 [N]. Positive: end K is pushed against the axis, along e3 in
  /// compression; negative: it is pulled along the axis, along e3 in tension.
  std::array<std::optional<Eigen::Vector2d>, 3> load;
  std::optional<double> deflection;          ///< largest static one along e3, after creep [m]
  std::optional<double> dynamic_deflection;  ///< largest harmonic amplitude along e3 [m]
  std::optional<double> shock_deflection;    ///< largest one over a transient along e3 [m]
  std::optional<double> mass;                ///< not part of the model [kg]
  std::optional<Price> price;

  [[nodiscard]] bool has_load_range() const { return load[0] || load[1] || load[2]; }
};

/// One measured value behind an identified law, for a residual plot.
struct Residual {
  std::string what;
  double measured = 0, fitted = 0;  ///< [N, N m]
  double standardised = 0;          ///< residual / its standard deviation
  bool outlier = false;
};

/// Uncertainty of a law that was measured or meshed.
struct Evidence {
  elements::Matrix12 uncertainty = elements::Matrix12::Zero();  ///< per entry of the nominal stiffness: half width of
                                                                ///< its interval, or estimated error
  std::string meaning;                                          ///< "95 % confidence", "estimated error of the mesh"
  std::vector<Residual> residuals;
};

/// Forces over the deflection of an element along or about one of its axes, in addition to its linear law.
struct NonlinearPart {
  int axis = 0;         ///< 0 … 2: translation, 3 … 5: rotation of K relative to N, axes of K
  double centre = 0.5;  ///< point of the deflection: fraction of the arm from N
  elements::ScalarLaws laws;
  double at_rest = 0;  ///< its deflection in the position of rest [m, rad]
  int inner = -1;      ///< instead of axis and centre: the inner coordinate of the element that is the deflection

  [[nodiscard]] bool is_inner() const { return inner >= 0; }
  [[nodiscard]] bool is_rotation() const { return !is_inner() && axis >= 3; }
};

/// A force over the distance of the ends, in addition to the linear law. Its deflections are the translations of end K
/// less those of end N, axes of K.
struct DistancePart {
  elements::DistanceForce law;
  Eigen::Vector3d at_rest = Eigen::Vector3d::Zero();       ///< deflections in the position of rest [m]
  std::optional<elements::RubbingFriction> friction = {};  ///< around and along the wall of a ring
};

/// Friction across the deflection of a nonlinear part, whose elastic forces press it.
struct RubbingPart {
  elements::RubbingFriction law;
  std::size_t pressed_by = 0;  ///< place of the nonlinear part, whose deflection is a translation
  Eigen::Vector2d at_rest = Eigen::Vector2d::Zero();  ///< deflections across in the position of rest [m]
};

struct Element {
  std::string name;
  std::string type;  ///< the law's name in the project file, for messages and reports
  End n;
  End k;
  elements::Law law;
  std::vector<NonlinearPart> nonlinear_parts;
  std::vector<DistancePart> distance_parts;
  std::vector<RubbingPart> rubbing_parts;
  /// The 12×12 about each state on the way along an axis. The first law of the first nonlinear part is then the whole
  /// force along it, the second that of the linear law, negative.
  std::optional<elements::StiffnessOverDeflection> over_deflection;
  bool symmetric = true;
  bool allow_residual = false;
  bool is_foundation = false;    ///< impedance of a ground point: elements on it count as "on the ground"
  std::vector<Fact> facts;       ///< for display: how its law was determined
  std::optional<Rating> rating;  ///< of a catalogue mount
  std::optional<Evidence> evidence;
  double stiffening = 1;  ///< of rubber: its stiffness in vibration over its static stiffness
  double creep = 1;       ///< of rubber: its static deflection after years over that at once
  double massless_up_to = std::numeric_limits<double>::infinity();  ///< first natural frequency of the element itself
                                                                    ///< if its mass is neglected [rad/s]
};

/// Makes the 12×12 about a deflection the linear law of an element with `over_deflection`. Its force along the axis
/// stays the same; that it also turns with the element is left to a preload.
void set_linear_law_at(double deflection, Element& element);

/// Has it any nonlinear parts?
[[nodiscard]] inline bool has_laws(const Element& element) {
  return !element.nonlinear_parts.empty() || !element.distance_parts.empty();
}

/// True for the impedance from the ground (N) to a foundation (K).
[[nodiscard]] inline bool joins_foundation_to_ground(const Element& element) {
  return element.is_foundation && element.n.on_ground() && element.k.foundation;
}
/// True for the coupling between two ground points of a measured mobility. Its ends have the motions of the points
/// relative to the ground.
[[nodiscard]] inline bool couples_ground_points(const Element& element) {
  return element.is_foundation && element.n.foundation;
}

/// Constant force and moment; enters static analyses only.
struct ConstantForce {
  std::string name;
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  spatial::Wrench wrench;
};

/// B += mass · A + stiffness · K.  [1/s], [s]
struct RayleighDamping {
  double mass = 0;
  double stiffness = 0;
};
/// B += A Φ diag(2 ζ ω) Φᵀ A over the undamped modes; one ratio for all, or one per mode (the last is not repeated).
struct ModalDamping {
  std::vector<double> ratios;
};
using SystemDamping = std::variant<std::monostate, RayleighDamping, ModalDamping>;

struct Description {
  std::string title;
  std::vector<Body> bodies;
  std::vector<Element> elements;
  SystemDamping damping;
  std::vector<Foundation> foundations;
  std::vector<Excitation> excitations;
  std::vector<ConstantForce> constant_forces;
  std::optional<Eigen::Vector3d> gravity;  ///< [m/s²], ground frame
  bool second_order = true;                ///< gravity changes the stiffness: forces at rest move with the bodies
  std::vector<RelativeMotion> relative_motions;
  std::vector<Section> sections;
  std::vector<Clearance> clearances;
};

/// A description that passed every check. Immutable.
class System {
 public:
  /// Reports all problems at once; the system keeps the warnings. Leaves out directions of nodes that no element holds.
  static foundation::Expected<System> checked(Description description);
  /// This machine with other states of its nonlinear parts (`at_rest`, `law.nonlinear`, gaps counted from rest), which
  /// no check depends on: none runs, and the warnings stay. With nodes all run, which settle what holds them.
  /// @throws std::logic_error if it is not valid after all
  [[nodiscard]] System in_other_state(Description description) const;

  [[nodiscard]] const Description& description() const { return description_; }
  [[nodiscard]] const std::vector<Body>& bodies() const { return description_.bodies; }
  [[nodiscard]] const std::vector<Element>& elements() const { return description_.elements; }
  [[nodiscard]] const foundation::Problems& warnings() const { return warnings_; }

 private:
  Description description_;
  foundation::Problems warnings_;
};

/// Has any element nonlinear parts?
[[nodiscard]] bool is_nonlinear(const System& system);

/// "x", "y", "z", "rx", "ry", "rz".
inline constexpr std::array<const char*, 6> coordinate_names = {"x", "y", "z", "rx", "ry", "rz"};

/// Pose of an end's local axes in the ground frame, at rest.
[[nodiscard]] spatial::Pose end_in_ground(const std::vector<Body>& bodies, const End& end);

/// Arm from N to K in the axes of K, and the rotation of components from K's axes into N's.
struct Span {
  Eigen::Vector3d arm;
  Eigen::Matrix3d n_from_k;
};
[[nodiscard]] Span span(const std::vector<Body>& bodies, const End& n, const End& k);

/// Name of the first element that is mounted on the modes of a foundation. A rigid motion of the whole ground cannot be
/// applied to it: the data do not state the participation of the modes in such a motion.
[[nodiscard]] inline std::optional<std::string> element_on_modes(const Description& description) {
  for (const Element& element : description.elements) {
    if (element.is_foundation || !element.n.foundation) continue;
    bool has_place_of_its_own = false;
    for (const Element& other : description.elements)
      has_place_of_its_own = has_place_of_its_own ||
          (joins_foundation_to_ground(other) && other.k.foundation->foundation == element.n.foundation->foundation);
    if (!has_place_of_its_own) return element.name;
  }
  return std::nullopt;
}

}  // namespace trivet::model
