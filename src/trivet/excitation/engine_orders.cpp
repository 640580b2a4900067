// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/engine_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "trivet/excitation/refusal.h"
#include "trivet/excitation/slider_crank.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

double permissible_unbalance(double grade_mm_per_s, double mass, double angular_speed) {
  require_positive(grade_mm_per_s, "balance grade", "mm/s");
  require_positive(mass, "rotor mass", "kg");
  require_positive(angular_speed, "speed", "rad/s");
  return 1e-3 * grade_mm_per_s * mass / angular_speed;
}

namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit(0, 1);

/// Sums contributions and their magnitudes, to distinguish cancelled entries from small ones.
class Balance {
 public:
  void add(const ComplexVector6& contribution) {
    sum_ += contribution;
    size_ += contribution.cwiseAbs();
  }
  /// A force in the plane of a cylinder and its moment about the origin.
  void add_force(double x, const Complex& y, const Complex& z) {
    ComplexVector6 wrench;
    wrench << 0, y, z, 0, -x * z, x * y;
    add(wrench);
  }
  [[nodiscard]] ComplexVector6 sum() const {
    const double cancelled = 64 * std::numeric_limits<double>::epsilon();
    ComplexVector6 result = sum_;
    const double force = size_.head<3>().maxCoeff(), moment = size_.tail<3>().maxCoeff();
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double limit = cancelled * (i < 3 ? force : moment);
      result(i) = {std::abs(result(i).real()) <= limit ? 0 : result(i).real(),
                   std::abs(result(i).imag()) <= limit ? 0 : result(i).imag()};
    }
    return result;
  }

 private:
  ComplexVector6 sum_ = ComplexVector6::Zero();
  Eigen::Matrix<double, 6, 1> size_ = Eigen::Matrix<double, 6, 1>::Zero();
};

bool is_harmonic(const Engine& engine, double order) {
  const double harmonic = order * engine.strokes / 2;
  return std::abs(harmonic - std::round(harmonic)) < 1e-9;
}

}  // namespace

std::vector<Order> inertia_orders(const Engine& engine, int highest) {
  foundation::refuse_errors(check(engine, "engine"));
  const std::vector<double> a = inertia_coefficients(engine.rod_ratio, highest),
                            g = inertia_torque_coefficients(engine.rod_ratio, highest);
  const double oscillating = engine.oscillating_mass * engine.crank_radius;
  const double rotating = engine.rotating_mass * engine.crank_radius - engine.counterweight;
  std::vector<Order> orders;
  for (int n = 1; n <= highest; ++n) {
    const auto k = to_size(n);
    Balance balance;
    for (const Cylinder& c : engine.cylinders) {
      const Complex phase = std::polar(1.0, n * (c.crank_angle - c.bank_angle));  // of cos nφ
      const Complex along = oscillating * a[k] * phase;
      balance.add_force(c.position, -std::sin(c.bank_angle) * along, std::cos(c.bank_angle) * along);
      if (n == 1) {
        const Complex throw_phase = std::polar(1.0, c.crank_angle);  // the throw points along (0, −sin, cos)
        balance.add_force(c.position, rotating * i_unit * throw_phase, rotating * throw_phase);
      }
      ComplexVector6 moment = ComplexVector6::Zero();
      moment(3) = oscillating * engine.crank_radius * g[k] * -i_unit * phase;
      balance.add(moment);
    }
    if (const ComplexVector6 sum = balance.sum(); !sum.isZero(0)) orders.push_back({static_cast<double>(n), sum});
  }
  return orders;
}

std::vector<Order> gas_orders(const Engine& engine, const std::vector<TorqueHarmonic>& one_cylinder) {
  foundation::refuse_errors(check(engine, "engine"));
  for (std::size_t i = 0; i < engine.cylinders.size(); ++i)
    if (std::isnan(engine.cylinders[i].firing_angle))
      throw foundation::InvalidInput(
          fmt::format("engine: cylinder {} has no firing angle, so its gas torque has no phase", i + 1));
  std::map<double, Order> orders;
  for (const TorqueHarmonic& harmonic : one_cylinder) {
    require_not_negative(harmonic.order, "order of the gas torque", "");
    if (!is_harmonic(engine, harmonic.order))
      throw foundation::InvalidInput(fmt::format("gas torque of order {}: with {} strokes orders are multiples of {}",
                                                 harmonic.order, engine.strokes, engine.strokes == 4 ? "½" : "1"));
    require_finite(std::abs(harmonic.torque), "gas torque", "N m");
    if (orders.count(harmonic.order))
      throw foundation::InvalidInput(fmt::format("gas torque of order {} is given twice", harmonic.order));
    Balance balance;
    for (const Cylinder& c : engine.cylinders) {
      ComplexVector6 moment = ComplexVector6::Zero();
      moment(3) = -harmonic.torque * std::polar(1.0, -harmonic.order * c.firing_angle);
      balance.add(moment);
    }
    orders[harmonic.order] = {harmonic.order, ComplexVector6::Zero(), balance.sum()};
  }
  std::vector<Order> result;
  for (const auto& [order, entry] : orders)
    if (order > 0 && !entry.fixed.isZero(0)) result.push_back(entry);
  return result;
}

double mean_torque(const Engine& engine, const std::vector<TorqueHarmonic>& one_cylinder) {
  double sum = 0;
  for (const TorqueHarmonic& harmonic : one_cylinder)
    if (harmonic.order == 0) sum += harmonic.torque.real();
  return sum * static_cast<double>(engine.cylinders.size());
}

std::vector<Order> joined(const std::vector<Order>& one, const std::vector<Order>& other) {
  std::map<double, Order> orders;
  for (const auto* list : {&one, &other})
    for (const Order& entry : *list) {
      Order& sum = orders.try_emplace(entry.order, Order{entry.order}).first->second;
      sum.per_speed_squared += entry.per_speed_squared;
      sum.fixed += entry.fixed;
    }
  std::vector<Order> result;
  for (const auto& [order, entry] : orders) result.push_back(entry);
  return result;
}

}  // namespace trivet::excitation
