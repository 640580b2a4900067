// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/further_json.h"

namespace trivet::results {
namespace {

/// Shortest digits that read back the same; empty where there is no number.
/// "inf" where a number has no bound, empty where there is none.
std::string bounded(const std::optional<double>& value, bool infinite) { return infinite ? "inf" : csv_number(value); }

using foundation::two_pi;

}  // namespace

std::string random_csv(const study::Answers& answers) {
  std::string text = "name,unit,rms,three_sigma,rms_of_derivative,zero_crossings [1/s],weighted_rms";
  for (const std::string& input : answers.random->inputs) text += "," + csv_field("variance share " + input);
  text += "\n";
  for (const response::RandomAnswer& a : answers.random->response.answers) {
    text += fmt::format("{},{},{},{},{},{},{}", csv_field(a.name), csv_field(a.unit), bounded(a.rms, a.infinite_rms), bounded(a.three_sigma, a.infinite_rms),
                        bounded(a.rms_of_derivative, a.infinite_rms_of_derivative), csv_number(a.zero_crossings), bounded(a.weighted_rms, a.infinite_weighted_rms));
    for (std::size_t i = 0; i < answers.random->inputs.size(); ++i) text += "," + (i < a.variance_share.size() ? csv_number(a.variance_share[i]) : std::string());
    text += "\n";
  }
  return text;
}

std::string random_densities_csv(const study::Answers& answers) {
  const study::RandomResult& random = *answers.random;
  std::string text = "frequency [Hz]";
  for (const response::RandomAnswer& a : random.response.answers) text += "," + csv_field(fmt::format("{} [({})²/Hz]", a.name, a.unit));
  text += "\n";
  for (std::size_t k = 0; k < random.curves.angular_frequency.size(); ++k) {
    text += csv_number(random.curves.angular_frequency[k] / two_pi);
    for (const auto& density : random.curves.density) text += "," + csv_number(two_pi * density[k]);
    text += "\n";
  }
  return text;
}

std::string transient_csv(const study::Answers& answers) {
  const response::TransientResponse& found = answers.transient->response;
  std::string text = "time [s]";
  for (const response::TimeCurve& c : found.curves) text += "," + csv_field(fmt::format("{} [{}]", c.name, c.unit));
  text += "\n";
  for (Eigen::Index k = 0; k < found.time.size(); ++k) {
    text += csv_number(found.time(k));
    for (const response::TimeCurve& c : found.curves) text += "," + csv_number(c.values(k));
    text += "\n";
  }
  return text;
}

std::string orders_csv(const study::Answers& answers) {
  const response::RunUp& run = answers.orders->run_up;
  std::string text = "speed [rad/s],speed [rpm]";
  for (const response::Overall& o : run.overall) text += "," + csv_field(fmt::format("{} rms [{}]", o.name, o.unit));
  for (const response::OrderCurves& order : run.orders)
    for (const response::Curve& c : order.curves) text += "," + csv_field(fmt::format("{} order {} [{}]", c.name, order.order, c.unit));
  text += "\n";
  for (std::size_t k = 0; k < run.speed.size(); ++k) {
    text += fmt::format("{},{}", run.speed[k], run.speed[k] * 60 / two_pi);
    for (const response::Overall& o : run.overall) text += "," + csv_number(o.rms(static_cast<Eigen::Index>(k)));
    for (const response::OrderCurves& order : run.orders)
      for (const response::Curve& c : order.curves) text += "," + csv_number(std::abs(c.value(static_cast<Eigen::Index>(k))));
    text += "\n";
  }
  return text;
}

std::string critical_speeds_csv(const study::Answers& answers) {
  const response::RunUp& run = answers.orders->run_up;
  std::string text = "name,order,speed [rad/s],speed [rpm],angular_frequency [rad/s],amplitude,unit,relative_height,nearest_mode\n";
  for (const response::CriticalSpeed& c : run.critical)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(run.overall[c.curve].name), c.order, c.speed, c.speed * 60 / two_pi, c.angular_frequency, csv_number(c.amplitude), csv_field(run.overall[c.curve].unit),
                        c.relative_height, csv_number(c.nearest_mode));
  return text;
}

std::string transmissibility_csv(const study::Answers& answers) {
  const study::TransmissibilityResult& t = *answers.transmissibility;
  std::string text = "angular_frequency [rad/s]";
  for (const response::Curve& c : t.curves.curves) text += "," + csv_field(c.name + " [1]") + "," + csv_field(c.name + " [dB]");
  text += "\n";
  for (std::size_t k = 0; k < t.curves.angular_frequency.size(); ++k) {
    text += csv_number(t.curves.angular_frequency[k]);
    for (const response::Curve& c : t.curves.curves) {
      const double size = std::abs(c.value(static_cast<Eigen::Index>(k)));
      text += fmt::format(",{},{}", csv_number(size), csv_number(response::transmissibility_level(size)));
    }
    text += "\n";
  }
  return text;
}

std::string power_csv(const study::Answers& answers) {
  const response::PowerFlow& p = *answers.power;
  std::string text = "angular_frequency [rad/s],by forces [W],by ground [W],into ground [W]";
  for (const std::string& mount : p.mounts) text += "," + csv_field("into ground at " + mount + " [W]");
  text += "\n";
  for (std::size_t k = 0; k < p.angular_frequency.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    text += fmt::format("{},{},{},{}", p.angular_frequency[k], csv_number(p.by_forces(column)), csv_number(p.by_ground(column)), csv_number(p.into_ground_in_total(column)));
    for (Eigen::Index m = 0; m < p.into_ground.rows(); ++m) text += "," + csv_number(p.into_ground(m, column));
    text += "\n";
  }
  return text;
}

std::string shapes_csv(const study::Answers& answers) {
  std::string text = "angular_frequency [rad/s],place,x [m],y [m],z [m]";
  for (const char* part : {"re", "im"})
    for (const char* name : model::coordinate_names) text += fmt::format(",{} {}", name, part);
  text += "\n";
  for (const response::DeflectionShape& shape : answers.shapes)
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) {
        text += fmt::format("{},{},{},{},{}", shape.angular_frequency, csv_field(p.name), p.position.x(), p.position.y(), p.position.z());
        for (int j = 0; j < 6; ++j) text += "," + csv_number(p.motion(j).real());
        for (int j = 0; j < 6; ++j) text += "," + csv_number(p.motion(j).imag());
        text += "\n";
      }
  return text;
}

std::string shock_spectrum_csv(const study::Answers& answers) {
  std::string text = "excitation,natural frequency [Hz],largest [m/s²],smallest [m/s²],maximax [m/s²],pseudo velocity [m/s],relative displacement [m]\n";
  for (const study::ShockSpectrumResult& spectrum : answers.shock_spectra)
    for (const excitation::ShockResponse& r : spectrum.spectrum)
      text += fmt::format("{},{},{},{},{},{},{}\n", csv_field(spectrum.excitation), r.angular_frequency / two_pi, r.largest(), r.smallest(), r.maximax(), r.pseudo_velocity(), r.relative_displacement);
  return text;
}

}  // namespace trivet::results
