// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/sensitivity/model_parameters.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/first_error.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/model/adjustments.h"
#include "trivet/model/element_directions.h"
#include "trivet/model/point_mass.h"

namespace trivet::response {
namespace {

using model::Description;
using spatial::Matrix6;

constexpr double one_percent = 0.01, one_millimetre = 1e-3;
constexpr double relative_step =
    1e-3;  // error of fourth-order differences: 1e-12 of what is not polynomial, and 1e-13 of round-off

class List {
 public:
  explicit List(const model::System& system) : system_(system) {}

  std::vector<Parameter> all() {
    for (std::size_t e = 0; e < system_.elements().size(); ++e) add_element(e);
    for (std::size_t b = 0; b < system_.bodies().size(); ++b)
      if (!system_.bodies()[b].is_node) add_body(b);
    add_system_damping();
    return std::move(list_);
  }

 private:
  Parameter& relative(std::string name, std::function<void(Description&, double)> apply) {
    return list_.emplace_back(Parameter{std::move(name), "+1 %", one_percent, relative_step, std::move(apply), {}});
  }

  /// `length` [m]: scale over which the model changes.
  void place(std::string name, double length, std::function<void(Description&, double)> apply) {
    list_.push_back({std::move(name), "+1 mm", one_millimetre, relative_step * length, std::move(apply), {}});
  }

  void add_element(std::size_t e) {
    const model::Element& element = system_.elements()[e];
    const std::string path = "elements." + foundation::path_key(element.name);
    const Matrix6 k = model::element_directions(system_.bodies(), element).stiffness;
    if (const std::string_view key = model::stiffness_key(element); !key.empty() && !k.isZero(0)) {
      relative(fmt::format("{}.{}", path, key), [e](Description& d, double amount) {
        if (d.elements[e].law.preload) model::add_deformation_stiffness(d, e, amount);
        else d.elements[e].law.scale *= 1 + amount;
      }).law = e;
      if (model::has_plain_stiffness(element)) add_directions(e, path, k);
    }
    if (model::has_damping(element))
      relative(path + ".damping_factor", [e](Description& d, double amount) {
        model::scale_damping(d, e, 1 + amount);
      }).law = e;
    const double length = std::max(0.1, std::max(element.k.at.norm(), element.n.at.norm()));
    for (int j = 0; j < 3; ++j)
      place(fmt::format("{}.moved.{}", path, "xyz"[j]), length,
            [e, j](Description& d, double amount) { model::move_element(d, e, amount * Eigen::Vector3d::Unit(j)); });
  }

  void add_directions(std::size_t e, const std::string& path, const Matrix6& k) {
    constexpr double none = 1e-12;
    for (int j = 0; j < 6; ++j) {
      const double largest = k.diagonal().segment<3>(j < 3 ? 0 : 3).cwiseAbs().maxCoeff();
      if (!(std::abs(k(j, j)) > none * largest)) continue;
      relative(fmt::format("{}.stiffness_factor.{}", path, model::coordinate_names[j]),
               [e, j](Description& d, double amount) {
                 spatial::Vector6 factors = spatial::Vector6::Ones();
                 factors(j) = 1 + amount;
                 model::scale_stiffness_by_direction(d, e, factors);
               })
          .law = e;
    }
  }

  void add_body(std::size_t b) {
    const model::Body& body = system_.bodies()[b];
    const std::string path = "bodies." + foundation::path_key(body.name);
    const bool turns = body.free[3] || body.free[4] || body.free[5];
    relative(path + (turns ? ".mass_about_center" : ".mass"),
             [b](Description& d, double amount) { model::scale_mass(d, b, 1 + amount); });
    if (!turns || model::is_point_mass(body)) return;
    const Eigen::Matrix3d j = body.mass.inertia_about_centre;
    const double length = std::max(0.1, std::sqrt(std::abs(j.trace() / body.mass.mass)));
    for (int i = 0; i < 3; ++i)
      place(fmt::format("{}.center_moved.{}", path, "xyz"[i]), length, [b, i](Description& d, double amount) {
        model::move_center_of_mass(d, b, amount * Eigen::Vector3d::Unit(i));
      });
    for (int row = 0; row < 3; ++row)
      for (int column = row; column < 3; ++column) {
        if (j(row, row) * j(column, column) == 0) continue;
        Parameter& parameter = relative(
            fmt::format("{}.inertia_about_center.{}{}", path, "xyz"[row], "xyz"[column]),
            [b, row, column](Description& d, double amount) { model::change_inertia(d, b, row, column, amount); });
        if (row != column) parameter.change = fmt::format("+1 % of √(J{0}{0} J{1}{1})", "xyz"[row], "xyz"[column]);
      }
  }

  void add_system_damping() {
    if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&system_.description().damping)) {
      if (rayleigh->mass > 0)
        relative("damping.rayleigh.mass",
                 [](Description& d, double amount) { std::get<model::RayleighDamping>(d.damping).mass *= 1 + amount; });
      if (rayleigh->stiffness > 0)
        relative("damping.rayleigh.stiffness", [](Description& d, double amount) {
          std::get<model::RayleighDamping>(d.damping).stiffness *= 1 + amount;
        });
    }
    if (std::holds_alternative<model::ModalDamping>(system_.description().damping))
      relative("damping.modal_factor",
               [](Description& d, double amount) { model::scale_modal_damping(d, 1 + amount); });
  }

  const model::System& system_;
  std::vector<Parameter> list_;
};

}  // namespace

std::vector<Parameter> model_parameters(const model::System& system) { return List(system).all(); }

model::System changed(const model::System& system, const Parameter& parameter, double amount) {
  Description description = system.description();
  parameter.apply(description, amount);
  // A step may move the inertia of a slim body out of the physical range; only the slope is needed there.
  for (model::Body& body : description.bodies) body.allow_unphysical = true;
  auto result = model::System::checked(std::move(description));
  if (result) return std::move(*result);
  throw foundation::NotComputable(parameter.name + ": " + foundation::first_message(result.error()));
}

}  // namespace trivet::response
