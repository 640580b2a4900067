// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "trivet/exchange/universal/universal_reading.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/measured/measured_axes.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/measured/measured_places.h"
#include "trivet/project/measured/mobility_reader.h"
#include "trivet/project/measured/universal_names.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

using exchange::UniversalFunction;
using exchange::UniversalFunctionType;
using exchange::UniversalPoint;
using exchange::UniversalQuantity;

/// Difference of a coupling measured both ways over the geometric mean of the driving points (rms) that is not noise.
constexpr double not_reciprocal = 0.1;

/// Power of iω by which a function becomes a mobility; none if it is not motion per force.
std::optional<int> power_to_mobility(const std::optional<MeasuredUnit>& unit) {
  if (!unit || !unit->per_load || unit->quantity == Quantity::force || unit->quantity == Quantity::moment)
    return std::nullopt;
  return 1 - derivatives_of(unit->quantity);
}

bool is_axis(const UniversalPoint& point) { return std::abs(point.direction) >= 1 && std::abs(point.direction) <= 6; }

std::string name_of(const UniversalFunction& function) {
  return fmt::format("function {} per {}", point_name(function.response), point_name(function.reference));
}

std::vector<exchange::UniversalNode> nodes_among(const std::vector<int>& wanted, const exchange::UniversalFile& file) {
  std::vector<exchange::UniversalNode> found;
  for (const exchange::UniversalNode& node : file.nodes)
    if (std::ranges::find(wanted, node.label) != wanted.end()) found.push_back(node);
  return found;
}

class MobilityFunctions {
 public:
  MobilityFunctions(const exchange::UniversalFile& file, const std::string& source, const std::vector<int>& nodes,
                    const GivenUnits& given, foundation::Problems& found)
      : source_(source), nodes_(nodes), found_(found) {
    MeasuredAxes axes(given, source);
    std::vector<std::string> assumed;
    std::set<std::string> reported;
    for (const UniversalFunction& function : file.functions)
      if (function.type == UniversalFunctionType::frequency_response && point(function.response) &&
          point(function.reference) && is_axis(function.response) && is_axis(function.reference)) {
        functions_.push_back(&function);
        auto [unit, error] = axes.unit_of(function);
        // One of the problems that several functions have.
        if (error && reported.insert(error->finding.substr(error->finding.find(": "))).second) found.add(*error);
        if (unit && unit->assumed) assumed.push_back(name_of(function));
        units_[&function] = std::move(unit);
      }
    if (!functions_.empty()) found.add(axes.judge_idle_units());
    if (!assumed.empty()) found.add(assumed_units(given, assumed, source));
  }

  GroundMobility mobility() {
    if (found_.has_errors()) return {};
    for (const UniversalFunction* function : functions_) check(*function);
    found_.add(judge_abscissas(functions_, source_));
    if (functions_.empty())
      found_.error("", "no frequency response between the nodes",
                   "each ground point has the function of its motion per its own force",
                   "check the numbers of the nodes");
    if (found_.has_errors()) return {};
    read_frequencies();
    read_directions();
    if (found_.has_errors()) return {};
    measured_.assign(result_.directions.size(), std::vector<const UniversalFunction*>(result_.directions.size()));
    for (const UniversalFunction* function : functions_) place(*function);
    if (!found_.has_errors()) fill();
    return std::move(result_);
  }

 private:
  std::optional<std::size_t> point(const UniversalPoint& at) const {
    const auto found = std::ranges::find(nodes_, at.node);
    return found == nodes_.end() ? std::nullopt : std::optional(to_size(found - nodes_.begin()));
  }

  std::optional<std::size_t> direction(const UniversalPoint& at) const {
    for (std::size_t d = 0; d < result_.directions.size(); ++d)
      if (result_.directions[d].point == point(at) && result_.directions[d].coordinate == std::abs(at.direction) - 1)
        return d;
    return std::nullopt;
  }

  void check(const UniversalFunction& function) {
    if (!power_to_mobility(units_.at(&function)))
      found_.error("", name_of(function) + " is not a motion per force, or has no known unit",
                   "the axes of receptance, mobility or accelerance have the types 8, 11 or 12 per 13",
                   "write the types of the axes and set 164, or state the unit of its numbers: unit = \"(m/s)/N\"");
    if (!may_be_over_frequency(function))
      found_.error("",
                   fmt::format("{} has an abscissa of type {}", name_of(function),
                               static_cast<int>(function.abscissa_axis.quantity)),
                   "a mobility is a function of frequency, type 18", "export it over frequency");
    if (!same_frequencies(exchange::abscissa_values(function), exchange::abscissa_values(*functions_.front())))
      found_.error("", name_of(function) + " has other frequencies than " + name_of(*functions_.front()),
                   "all functions of a mobility have the same frequencies", "measure or interpolate them alike");
  }

  void read_frequencies() {
    hertz_ = exchange::abscissa_values(*functions_.front());
    for (const double hertz : hertz_)
      if (hertz > 0) result_.knots.push_back(foundation::two_pi * hertz);
    if (result_.knots.size() < 2 || result_.knots.size() > most_frequencies)
      found_.error("", fmt::format("{} frequencies above 0 Hz", result_.knots.size()),
                   fmt::format("a mobility has 2 to {} frequencies", most_frequencies), "measure another number");
  }

  void read_directions() {
    for (std::size_t p = 0; p < nodes_.size(); ++p) {
      const std::size_t before = result_.directions.size();
      for (int j = 0; j < 6; ++j)
        for (const UniversalFunction* function : functions_)
          if (function->response.node == nodes_[p] && function->reference.node == nodes_[p] &&
              std::abs(function->response.direction) == j + 1 && std::abs(function->reference.direction) == j + 1) {
            result_.directions.push_back({p, j, point_name({"", nodes_[p], j + 1})});
            break;
          }
      if (result_.directions.size() == before)
        found_.error("", fmt::format("node {} has no driving-point function", nodes_[p]),
                     "each ground point has the function of its motion per its own force", "measure it");
    }
  }

  void place(const UniversalFunction& function) {
    const auto row = direction(function.response), column = direction(function.reference);
    if (!row || !column) {
      found_.error("", name_of(function) + " without the driving-point functions of both",
                   "a coupling needs the driving-point mobilities of both directions", "measure them, or remove it");
      return;
    }
    if (measured_[*row][*column])
      found_.error("", name_of(function) + " twice", "each pair of points and directions has one function",
                   "remove one of them");
    measured_[*row][*column] = &function;
  }

  Eigen::VectorXcd values(const UniversalFunction& function) const {
    Eigen::VectorXcd result(to_index(result_.knots.size()));
    const double sign = (function.response.direction > 0) == (function.reference.direction > 0) ? 1 : -1;
    const auto& unit = units_.at(&function);
    const int power = *power_to_mobility(unit);
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < hertz_.size(); ++i) {
      if (!(hertz_[i] > 0)) continue;
      const std::complex<double> s(0, foundation::two_pi * hertz_[i]);
      const std::complex<double> factor = power == 0 ? 1.0 : power > 0 ? s : 1.0 / s;
      result(next++) = sign * unit->factor * factor * function.values[i];
    }
    return result;
  }

  void fill() {
    const std::size_t count = result_.directions.size();
    result_.rows.assign(result_.knots.size(), Eigen::MatrixXcd::Zero(to_index(count), to_index(count)));
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const UniversalFunction *one = measured_[i][j], *other = measured_[j][i];
        if (!one && !other) {
          missing.push_back(result_.directions[i].name + " per " + result_.directions[j].name);
          continue;
        }
        Eigen::VectorXcd value = values(one ? *one : *other);
        if (i != j && one && other) value = mean(value, values(*other), i, j);
        for (std::size_t r = 0; r < result_.rows.size(); ++r)
          result_.rows[r](to_index(i), to_index(j)) = result_.rows[r](to_index(j), to_index(i)) = value(to_index(r));
      }
    if (!missing.empty())
      found_.warning("",
                     missing.size() == 1 ? "the coupling " + missing.front() + " was not measured"
                                         : fmt::format("{} couplings were not measured, for instance {}",
                                                       missing.size(), missing.front()),
                     "a force at one point moves the others too", "they are zero; measure them if they matter");
  }

  Eigen::VectorXcd mean(const Eigen::VectorXcd& there, const Eigen::VectorXcd& back, std::size_t i, std::size_t j) {
    const Eigen::VectorXd size = values(*measured_[i][i]).cwiseProduct(values(*measured_[j][j])).cwiseAbs().cwiseSqrt();
    const double difference = (there - back).norm() / size.norm();
    if (difference > not_reciprocal)
      found_.warning("",
                     fmt::format("{} per {} and back differ by {:.3g} % rms of the driving points",
                                 result_.directions[i].name, result_.directions[j].name, 100 * difference),
                     "the mobility of a passive linear structure is symmetric",
                     "the mean is used; check directions, signs and calibration");
    return 0.5 * (there + back);
  }

  static constexpr std::size_t most_frequencies = 20'000;

  const std::string source_;
  const std::vector<int>& nodes_;
  foundation::Problems& found_;
  std::vector<const UniversalFunction*> functions_;  ///< between the nodes
  std::map<const UniversalFunction*, std::optional<MeasuredUnit>> units_;
  std::vector<double> hertz_;
  GroundMobility result_;
  std::vector<std::vector<const UniversalFunction*>> measured_;  ///< motion of the first per force at the second
};

/// Turns the directions of functions to axes of the ground.
foundation::Problems turn_functions(const std::vector<exchange::UniversalNode>& nodes,
                                    std::vector<UniversalFunction>& functions) {
  foundation::Problems found;
  for (UniversalFunction& function : functions)
    for (UniversalPoint* point : {&function.response, &function.reference}) {
      if (const auto turned = in_ground(*point, nodes)) {
        *point = *turned;
        continue;
      }
      found.error("", name_of(function) + " is measured along an axis of its node that is not one of the ground",
                  "a mobility has the directions x, y, z, rx, ry, rz of the ground",
                  "turn the measurement, or describe the ground in its axes");
      return found;
    }
  return found;
}

}  // namespace

std::optional<GroundMobility> read_universal_mobility(TableReader& reader, const std::vector<int>& nodes) {
  const auto file = read_file_name(reader, "file");
  const auto units = read_given_units(reader);
  if (!file || !units) return std::nullopt;
  auto read = exchange::read_universal(*file);
  if (!read) return reader.add_of_file("file", read.error()), std::nullopt;
  foundation::Problems found = read->warnings;
  found.add(turn_functions(nodes_among(nodes, read->file), read->file.functions));
  found.add(judge_directions(nodes_among(nodes, read->file)));
  GroundMobility result = MobilityFunctions(read->file, file->string(), nodes, *units, found).mobility();
  result.source = file->string();
  if (!found.has_errors()) found.add(judge_mobility(result));
  reader.add_of_file("file", found);
  if (found.has_errors()) return std::nullopt;
  return result;
}

}  // namespace trivet::project
