// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/elements/scalar_law.h"

namespace trivet::nonlinear {

/// Laws over the deviation x from a state and its rate v, beyond the stiffness and damping that the linear machine
/// contains in their place: f(state + x, v) − f(state) − stiffness · x − damping · v.
class DeviationLaw {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): laws about the undeformed state
  DeviationLaw(elements::ScalarLaws laws, double state = 0, elements::SmallMotion reference = {},
               double acceleration_per_force = 0);

  struct Force {
    double force = 0, by_deviation = 0, by_rate = 0;
  };
  /// Of the parts without memory: elastic ones and dampers, with both references.
  [[nodiscard]] Force without_memory(double deviation, double rate) const;

  /// Tangents of the elastic parts less the reference stiffness, at slow deviations.
  [[nodiscard]] Eigen::VectorXd elastic_tangents(const Eigen::VectorXd& deviations) const;

  /// Parts of that force, by how they are integrated over a motion.
  class Parts {
   public:
    void add(const elements::ElasticForce& law) { elastic_.push_back(law); }
    void add(const elements::DampingForce& law) { dampers_.push_back(law); }
    [[nodiscard]] bool is_empty() const { return elastic_.empty() && dampers_.empty(); }
    /// At a deflection and its rate.
    [[nodiscard]] Force at(double deflection, double rate) const;
    /// At many deflections, each with its rate.
    [[nodiscard]] elements::ForcesInMotion at(const Eigen::VectorXd& deflections, const Eigen::VectorXd& rates) const;
    /// Of parts of second degree; their second derivative by the deflection is zero.
    struct Curvature {
      double mixed = 0, by_rate = 0;  ///< ∂²f/∂x∂v, ∂²f/∂v²
    };
    [[nodiscard]] Curvature curvature(double deflection, double rate) const;

   private:
    std::vector<elements::ElasticForce> elastic_;
    std::vector<elements::DampingForce> dampers_;
  };
  [[nodiscard]] const Parts& smooth() const { return smooth_; }        ///< without kinks
  [[nodiscard]] const Parts& quadratic() const { return quadratic_; }  ///< of second degree between kinks
  [[nodiscard]] const Parts& others() const { return others_; }
  /// What remains: constant + stiffness · x + damping · v.
  struct Line {
    double constant = 0, stiffness = 0, damping = 0;
  };
  [[nodiscard]] Line line() const;
  [[nodiscard]] double state() const { return state_; }

  /// Of all parts in slow motion from the undeformed state.
  [[nodiscard]] elements::ForceAndTangent at_rest(double deviation) const;

  /// ∫ of the elastic parts, with the reference stiffness, over the deviation from 0 [J].
  [[nodiscard]] double energy(double deviation) const;

  struct Hysteretic {
    elements::HystereticForce law;
    double at_state = 0;  ///< its force at the state
  };
  [[nodiscard]] const std::vector<Hysteretic>& hysteretic() const { return hysteretic_; }
  /// Change of the acceleration of the deflection per change of the force on it [1/kg, 1/(kg m²)].
  [[nodiscard]] double acceleration_per_force() const { return acceleration_per_force_; }

  struct Bristles {
    elements::LuGreFriction law;
    double at_state = 0;  ///< its force at the state
  };
  [[nodiscard]] const std::vector<Bristles>& bristles() const { return bristles_; }

  /// Parts that depend on the amplitude of the motion about the state.
  [[nodiscard]] const std::vector<elements::PayneForce>& of_amplitude() const { return of_amplitude_; }

  /// Does the force at rest never fall as the deflection grows?
  [[nodiscard]] bool is_monotone() const { return elements::is_monotone(laws_); }
  /// Of a force that is a polynomial of the deflection alone.
  [[nodiscard]] std::optional<int> degree() const;
  /// Are all tangents constant between kinks?
  [[nodiscard]] bool is_piecewise_linear() const;
  [[nodiscard]] bool is_empty() const { return laws_.empty(); }
  /// Does any force depend on the rate?
  [[nodiscard]] bool has_dampers() const { return has_dampers_; }

  /// Deviations and rates at which the parts without memory are not smooth, ascending.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }
  [[nodiscard]] const std::vector<double>& rate_kinks() const { return rate_kinks_; }

  /// Deviations between which no stop is touched; infinite without stops.
  [[nodiscard]] std::pair<double, double> untouched() const;
  /// Deviations for which all forces are known.
  [[nodiscard]] std::pair<double, double> range() const;

 private:
  elements::ScalarLaws laws_;
  std::vector<elements::ElasticForce> elastic_;
  std::vector<elements::DampingForce> dampers_;
  Parts smooth_, quadratic_, others_;
  std::vector<Hysteretic> hysteretic_;
  std::vector<Bristles> bristles_;
  std::vector<elements::PayneForce> of_amplitude_;
  double state_ = 0, offset_ = 0, acceleration_per_force_ = 0;
  elements::SmallMotion reference_;
  bool has_dampers_;
  std::vector<double> kinks_, rate_kinks_;
};

}  // namespace trivet::nonlinear
