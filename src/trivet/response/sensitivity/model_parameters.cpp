// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/sensitivity/model_parameters.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/element_directions.h"

namespace trivet::response {
namespace {

using model::Description;
using spatial::Matrix6;

constexpr double one_percent = 0.01, one_millimetre = 1e-3;
constexpr double relative_step = 1e-3;  // fourth-order differences leave 1e-12 of what is not polynomial, and 1e-13 of round-off

class List {
 public:
  explicit List(const model::System& system) : system_(system) {}

  std::vector<Parameter> all() {
    for (std::size_t e = 0; e < system_.elements().size(); ++e) add_element(e);
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) add_body(b);
    add_system_damping();
    return std::move(list_);
  }

 private:
  Parameter& relative(std::string name, std::function<void(Description&, double)> apply) {
    return list_.emplace_back(Parameter{std::move(name), "+1 %", one_percent, relative_step, std::move(apply), {}});
  }

  /// `length` [m]: over which the model changes.
  void place(std::string name, double length, std::function<void(Description&, double)> apply) {
    list_.push_back({std::move(name), "+1 mm", one_millimetre, relative_step * length, std::move(apply), {}});
  }

  void add_element(std::size_t e) {
    const model::Element& element = system_.elements()[e];
    const std::string path = "elements." + element.name;
    const ElementDirections directions = element_directions(system_, element);
    const Matrix6& k = directions.stiffness;
    if (!k.isZero(0)) {
      if (element.law.preload)
        relative(path + ".stiffness", [e, held = between_ends(directions, k)](Description& d, double amount) {
          d.elements[e].law.nominal_stiffness += amount * held;
        }).law = e;
      else
        relative(path + ".scale", [e](Description& d, double amount) { d.elements[e].law.scale *= 1 + amount; }).law = e;
      if (!element.law.inertia && !element.law.frequency_dependence) add_directions(e, path, directions);
    }
    add_damping(e, path);
    const double length = std::max(0.1, std::max(element.k.at.norm(), element.n.at.norm()));
    for (int j = 0; j < 3; ++j)
      place(fmt::format("{}.at.{}", path, "xyz"[j]), length,
            [e, j](Description& d, double amount) { shift(d, e, amount * Eigen::Vector3d::Unit(j)); });
  }

  /// S K S with S_jj = √(1 + amount): the diagonal entry grows by it, couplings follow, and no energy turns negative.
  void add_directions(std::size_t e, const std::string& path, const ElementDirections& directions) {
    constexpr double none = 1e-12;
    const Matrix6& k = directions.stiffness;
    const double scale = system_.elements()[e].law.scale;
    for (int j = 0; j < 6; ++j) {
      const double largest = k.diagonal().segment<3>(j < 3 ? 0 : 3).cwiseAbs().maxCoeff();
      if (!(std::abs(k(j, j)) > none * largest)) continue;
      relative(fmt::format("{}.stiffness.{}", path, model::coordinate_names[static_cast<std::size_t>(j)]), [e, j, scale, directions](
                                                                                                               Description& d,
                                                                                                               double amount) {
        spatial::Vector6 s = spatial::Vector6::Ones();
        s(j) = std::sqrt(1 + amount);
        const Matrix6 gained = s.asDiagonal() * directions.stiffness * s.asDiagonal() - directions.stiffness;
        d.elements[e].law.nominal_stiffness += between_ends(directions, gained) / scale;
      }).law = e;
    }
  }

  void add_damping(std::size_t e, const std::string& path) {
    if (!(damps(system_.elements()[e].law.damping))) return;
    relative(path + ".damping", [e](Description& d, double amount) { scale_damping(d.elements[e].law.damping, 1 + amount); }).law = e;
  }

  static bool damps(const elements::Damping& damping) {
    if (const auto* given = std::get_if<elements::DampingMatrix>(&damping)) return !given->matrix.isZero(0);
    if (const auto* loss = std::get_if<elements::LossFactor>(&damping)) return loss->value > 0;
    if (const auto* proportional = std::get_if<elements::ProportionalDamping>(&damping)) return proportional->factor > 0;
    return std::holds_alternative<elements::Viscoelastic>(damping);
  }

  static void scale_damping(elements::Damping& damping, double factor) {
    if (auto* given = std::get_if<elements::DampingMatrix>(&damping)) given->matrix *= factor;
    if (auto* loss = std::get_if<elements::LossFactor>(&damping)) loss->value *= factor;
    if (auto* proportional = std::get_if<elements::ProportionalDamping>(&damping)) proportional->factor *= factor;
    if (auto* relaxing = std::get_if<elements::Viscoelastic>(&damping)) {
      if (auto* viscous = std::get_if<elements::KelvinVoigt>(relaxing)) viscous->time *= factor;
      if (auto* zener = std::get_if<elements::Zener>(relaxing)) zener->ratio *= factor;
      if (auto* fractional = std::get_if<elements::FractionalZener>(relaxing)) fractional->ratio *= factor;
      if (auto* series = std::get_if<elements::GeneralizedMaxwell>(relaxing))
        for (double& ratio : series->ratios) ratio *= factor;
    }
  }

  /// Both ends by the same vector, given in the frame of the body at K, in each end's own frame; the place of a foundation moves with its end.
  static void shift(Description& d, std::size_t e, const Eigen::Vector3d& by) {
    model::Element& element = d.elements[e];
    const auto rotation = [&](const model::End& end) {
      return end.body ? d.bodies[*end.body].pose.rotation : Eigen::Matrix3d::Identity().eval();
    };
    const Eigen::Vector3d in_ground = rotation(element.k) * by;
    element.k.at += by;
    element.n.at += rotation(element.n).transpose() * in_ground;
    if (!element.n.foundation) return;
    for (model::Element& joint : d.elements)
      if (joint.is_foundation && joint.k.foundation && joint.k.foundation->foundation == element.n.foundation->foundation)
        joint.n.at = joint.k.at = element.n.at;
  }

  void add_body(std::size_t b) {
    const model::Body& body = system_.bodies()[b];
    const std::string path = "bodies." + body.name;
    relative(path + ".mass", [b](Description& d, double amount) { d.bodies[b].mass.mass *= 1 + amount; });
    if (!body.free[3] && !body.free[4] && !body.free[5]) return;
    const Eigen::Matrix3d j = body.mass.inertia_about_centre;
    const double length = std::max(0.1, std::sqrt(std::abs(j.trace() / body.mass.mass)));
    for (int i = 0; i < 3; ++i)
      place(fmt::format("{}.center_of_mass.{}", path, "xyz"[i]), length,
            [b, i](Description& d, double amount) { d.bodies[b].mass.centre(i) += amount; });
    for (int row = 0; row < 3; ++row)
      for (int column = row; column < 3; ++column) {
        // Jxy = ∫xy dm stands with a minus sign in the tensor.
        const double unit = row == column ? j(row, row) : -std::sqrt(std::abs(j(row, row) * j(column, column)));
        if (unit == 0) continue;
        Parameter& parameter = relative(fmt::format("{}.inertia.{}{}", path, "xyz"[row], "xyz"[column]),
                                        [b, row, column, unit](Description& d, double amount) {
                                          Eigen::Matrix3d& tensor = d.bodies[b].mass.inertia_about_centre;
                                          tensor(row, column) += amount * unit;
                                          if (row != column) tensor(column, row) += amount * unit;
                                        });
        if (row != column) parameter.change = fmt::format("+1 % of √(J{0}{0} J{1}{1})", "xyz"[row], "xyz"[column]);
      }
  }

  void add_system_damping() {
    if (const auto* rayleigh = std::get_if<model::RayleighDamping>(&system_.description().damping)) {
      if (rayleigh->mass > 0)
        relative("damping.rayleigh.mass",
                 [](Description& d, double amount) { std::get<model::RayleighDamping>(d.damping).mass *= 1 + amount; });
      if (rayleigh->stiffness > 0)
        relative("damping.rayleigh.stiffness",
                 [](Description& d, double amount) { std::get<model::RayleighDamping>(d.damping).stiffness *= 1 + amount; });
    }
    if (std::holds_alternative<model::ModalDamping>(system_.description().damping))
      relative("damping.modal", [](Description& d, double amount) {
        for (double& ratio : std::get<model::ModalDamping>(d.damping).ratios) ratio *= 1 + amount;
      });
  }

  const model::System& system_;
  std::vector<Parameter> list_;
};

}  // namespace

std::vector<Parameter> model_parameters(const model::System& system) { return List(system).all(); }

model::System changed(const model::System& system, const Parameter& parameter, double amount) {
  Description description = system.description();
  parameter.apply(description, amount);
  // A slim body's inertia may leave the bounds of real bodies by a step; what is asked for is only the slope there.
  for (model::Body& body : description.bodies) body.allow_unphysical = true;
  auto result = model::System::checked(std::move(description));
  if (result) return std::move(*result);
  for (const foundation::Problem& problem : result.error().list())
    if (problem.severity == foundation::Severity::error)
      throw foundation::NotComputable(parameter.name + ": " + foundation::message(problem));
  throw foundation::NotComputable(parameter.name + ": the changed model is refused");
}

}  // namespace trivet::response
