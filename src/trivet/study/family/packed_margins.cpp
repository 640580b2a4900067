// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/packed_margins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/driven_values.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/requirements/free_motion.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/requirements/mount_loads.h"

namespace trivet::study {

CurveEquations packed_curve(const numerics::DrivenDesigns& designs, Eigen::Index design, std::size_t curve,
                            double omega) {
  const numerics::DesignCurve& one = designs.curves[curve];
  return {numerics::driven_stiffness(designs, design, omega),
          numerics::sum_of_terms(designs.loads[one.load], design, omega),
          numerics::sum_of_terms(one.rows, design, omega),
          {one.constant_re(design, 0), one.constant_im(design, 0)}};
}

namespace {

using foundation::infinity;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Eigen::ArrayXXd unlimited(const CaseVector& of, Eigen::Index designs) {
  return Eigen::ArrayXXd::Constant(designs, to_index(of.results().size()), infinity);
}

bool is_at_one(const CaseVector::Search& search) { return search.band.from == search.band.to; }

/// Curves at one frequency, and the sums over orders at one speed.
void set_curves_at(const CaseVector& of, const CaseVector::Unpacked& designs, Eigen::ArrayXXd& margins) {
  Eigen::ArrayXXd squares = Eigen::ArrayXXd::Zero(margins.rows(), margins.cols());
  std::vector<bool> is_set(of.results().size(), false);
  for (const CaseVector::Search& search : of.searches()) {
    if (!is_at_one(search)) continue;
    const numerics::DrivenDesigns driven = of.searched(designs, search);
    for (Eigen::Index d = 0; d < squares.rows(); ++d) {
      const Eigen::ArrayXd sizes = numerics::driven_magnitudes(driven, d, search.band.from);
      for (std::size_t k = 0; k < search.results.size(); ++k)
        squares(d, to_index(search.results[k])) += sizes(search.curves[k]) * sizes(search.curves[k]);
    }
    for (const std::size_t r : search.results) is_set[r] = true;
  }
  for (std::size_t r = 0; r < is_set.size(); ++r) {
    if (!is_set[r]) continue;
    const double allowed = of.results()[r].allowed_amplitude();
    for (Eigen::Index d = 0; d < squares.rows(); ++d) {
      const double square = squares(d, to_index(r));
      margins(d, to_index(r)) = std::isnan(square) ? unknown : margin_of(allowed, std::sqrt(square));
    }
  }
}

bool is_good(numerics::DesignStatus status) {
  return status == numerics::DesignStatus::proven || status == numerics::DesignStatus::fallback;
}

/// Designs in which an amplitude is highest outside its band.
std::vector<Eigen::Index> outside_band(const CaseVector& of, const CaseVector::Search& search,
                                       const numerics::DesignPeaks& found) {
  std::vector<Eigen::Index> designs;
  for (Eigen::Index d = 0; d < found.highest.rows(); ++d) {
    bool outside = false;
    for (std::size_t k = 0; k < search.results.size(); ++k) {
      const double at = found.highest_at(d, search.curves[k]);
      outside = outside ||
          (of.results()[search.results[k]].kind != RequirementKind::no_peak &&
           !(at >= search.band.from && at <= search.band.to));
    }
    if (outside && is_good(found.status[d])) designs.push_back(d);
  }
  return designs;
}

void set_found(const CaseVector& of, const CaseVector::Search& search, const numerics::DesignPeaks& found,
               CurveMargins& result) {
  for (std::size_t k = 0; k < search.results.size(); ++k) {
    const RequirementResult& one = of.results()[search.results[k]];
    const bool peaks = one.kind == RequirementKind::no_peak;
    const design::DesignRule rule{peaks ? design::DesignRule::Kind::no_peak : design::DesignRule::Kind::amplitude, 0,
                                  peaks ? one.allowed : one.allowed_amplitude()};
    const auto values = (peaks ? found.largest_rise : found.highest).col(search.curves[k]);
    for (Eigen::Index d = 0; d < values.size(); ++d)
      result.margins(d, to_index(search.results[k])) =
          is_good(found.status[d]) ? design::margin(rule, values(d)) : unknown;
  }
  for (std::size_t d = 0; d < result.status.size(); ++d)
    result.status[d] = std::max(result.status[d], found.status[d]);  // the worse of both
}

double margin_of_frequencies(const CaseVector& of, std::size_t result, std::size_t window,
                             const Eigen::ArrayXd& squares) {
  if (any_may_be_free(squares)) return unknown;
  double least = infinity, lower = 0;
  for (const double square : squares) {
    const double omega = std::sqrt(square);
    if (of.results()[result].kind == RequirementKind::avoided_frequencies)
      least = std::min(least, margin_outside(of.avoided()[window], omega));
    else if (lower > 0) least = std::min(least, margin_of_least(of.results()[result].allowed, omega / lower));
    lower = omega;
  }
  return least;
}

void set_frequencies(const CaseVector& of, const CaseVector::Unpacked& designs, Eigen::ArrayXXd& margins) {
  numerics::DesignModes modes;
  std::size_t window = 0;
  for (std::size_t r = 0; r < of.results().size(); ++r) {
    const RequirementKind kind = of.results()[r].kind;
    const bool avoided = kind == RequirementKind::avoided_frequencies;
    if (requirement_row(kind).packed != PackedPart::frequencies) continue;
    if (modes.lambda.size() == 0) modes = numerics::design_modes(of.free(designs), {.shapes = false, .threads = 1});
    for (Eigen::Index d = 0; d < margins.rows(); ++d)
      margins(d, to_index(r)) = margin_of_frequencies(of, r, window, modes.lambda.row(d).transpose());
    if (avoided) ++window;
  }
}

/// The least share of kinetic energy in one coordinate over the modes of a body.
double decoupling(const CaseVector::Decoupled& body, const MassNumbers& numbers, const Eigen::ArrayXd& shapes) {
  const spatial::MassProperties mass = mass_of(numbers);
  const spatial::Matrix6 to_centre = spatial::rigid_motion(mass.centre);
  const auto n = to_index(body.rows.size());
  double least = infinity;
  for (Eigen::Index k = 0; k < n; ++k) {
    spatial::Vector6 at_pole = spatial::Vector6::Zero();
    for (Eigen::Index i = 0; i < n; ++i) at_pole(body.coordinates[i]) = shapes(k * n + i);
    const spatial::Vector6 at_centre = to_centre * at_pole;
    spatial::Vector6 momentum;
    momentum << mass.mass * at_centre.head<3>(), mass.inertia_about_centre * at_centre.tail<3>();
    least = std::min(least, at_centre.cwiseProduct(momentum).maxCoeff());
  }
  return std::isfinite(shapes(0)) ? least : unknown;
}

void set_decoupling(const CaseVector& of, const CaseVector::Unpacked& designs, Eigen::ArrayXXd& margins) {
  if (of.decoupled().empty()) return;
  const numerics::Designs all = of.free(designs);
  for (std::size_t i = 0; i < of.decoupled().size(); ++i) {
    const CaseVector::Decoupled& body = of.decoupled()[i];
    const numerics::DesignModes modes =
        numerics::design_modes(part_of_designs(all, body.rows), {.shapes = true, .threads = 1});
    const RequirementResult& result = of.results()[body.result];
    for (Eigen::Index d = 0; d < margins.rows(); ++d) {
      const double share = decoupling(body, designs.bodies[i].row(d).transpose(), modes.shapes.row(d).transpose());
      margins(d, to_index(body.result)) = std::isnan(share) ? unknown : margin_of_least(result.allowed, share);
    }
  }
}

void set_rest(const CaseVector& of, const CaseVector::Unpacked& designs, Eigen::ArrayXXd& margins) {
  if (of.at_rest().empty()) return;
  const Eigen::Index n = of.coordinates();
  for (Eigen::Index d = 0; d < margins.rows(); ++d) {
    const auto [by_weight, by_loads] = CaseVector::rest_of(designs, d);
    const Eigen::VectorXd rest = by_weight + by_loads;
    for (std::size_t i = 0; i < of.at_rest().size(); ++i) {
      const CaseVector::RestValue& value = of.at_rest()[i];
      const double at = designs.rows[i].row(d).head(n).dot(rest) + designs.rows[i](d, n);
      margins(d, to_index(value.result)) = std::isnan(at) ? unknown
          : value.range                                   ? margin_in_range(at, *value.range)
                                                          : margin_of(of.results()[value.result].allowed, at);
    }
  }
}

/// Machines that fall over are left to the model itself, which says so.
void leave_falling(const CaseVector::Unpacked& designs, Eigen::ArrayXXd& margins) {
  for (Eigen::Index d = 0; d < margins.rows(); ++d)
    if (designs.falls[d]) margins.row(d) = unknown;
}

}  // namespace

numerics::Designs part_of_designs(const numerics::Designs& all, const std::vector<Eigen::Index>& rows) {
  const auto n = to_index(rows.size());
  numerics::Designs part;
  part.A.resize(all.A.rows(), n * (n + 1) / 2);
  part.K.resize(all.A.rows(), n * (n + 1) / 2);
  part.load = Eigen::ArrayXXd::Zero(1, n);
  Eigen::Index to = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++to) {
      const Eigen::Index high = std::max(rows[i], rows[j]), low = std::min(rows[i], rows[j]);
      part.A.col(to) = all.A.col(high * (high + 1) / 2 + low);
      part.K.col(to) = all.K.col(high * (high + 1) / 2 + low);
    }
  return part;
}

numerics::DesignPeaks searched_peaks(const CaseVector& of, const CaseVector::Unpacked& designs,
                                     const CaseVector::Search& search) {
  numerics::DrivenPeakOptions options{.count_peaks = search.count_peaks, .min_prominence = search.min_prominence};
  if (!search.count_peaks) options.from = search.band.from, options.to = search.band.to;
  numerics::DesignPeaks found = design::peaks_of(search.first, designs.entries, search.at, options);
  if (!search.count_peaks) return found;
  // Peaks count at all frequencies, amplitudes only in the band; the highest one is rarely outside.
  const std::vector<Eigen::Index> again = outside_band(of, search, found);
  if (again.empty()) return found;
  const numerics::DesignPeaks inside =
      design::peaks_of(search.first, designs.entries(again, Eigen::all), search.at,
                       {.from = search.band.from, .to = search.band.to, .count_peaks = false});
  for (std::size_t k = 0; k < again.size(); ++k) {
    found.highest.row(again[k]) = inside.highest.row(to_index(k));
    found.status[again[k]] = std::max(found.status[again[k]], inside.status[k]);
  }
  return found;
}

CurveMargins curve_margins(const CaseVector& of, const CaseVector::Unpacked& designs) {
  CurveMargins result{unlimited(of, designs.count()),
                      std::vector(to_size(designs.count()), numerics::DesignStatus::proven)};
  set_curves_at(of, designs, result.margins);
  for (const CaseVector::Search& search : of.searches())
    if (!is_at_one(search)) set_found(of, search, searched_peaks(of, designs, search), result);
  leave_falling(designs, result.margins);
  for (std::size_t d = 0; d < result.status.size(); ++d)
    if (designs.falls[d]) result.status[d] = numerics::DesignStatus::undecided;
  return result;
}

Eigen::ArrayXXd quick_margins(const CaseVector& of, const CaseVector::Unpacked& designs) {
  Eigen::ArrayXXd margins = unlimited(of, designs.count());
  set_frequencies(of, designs, margins);
  set_decoupling(of, designs, margins);
  set_rest(of, designs, margins);
  leave_falling(designs, margins);
  return margins;
}

Eigen::ArrayXXd packed_margins(const CaseVector& of, const Eigen::MatrixXd& entries) {
  const CaseVector::Unpacked designs = of.unpacked(entries);
  Eigen::ArrayXXd margins = quick_margins(of, designs);
  const Eigen::ArrayXXd of_curves = curve_margins(of, designs).margins;
  for (const CaseVector::Search& search : of.searches())
    for (const std::size_t r : search.results) margins.col(to_index(r)) = of_curves.col(to_index(r));
  return margins;
}

}  // namespace trivet::study
