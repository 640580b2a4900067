// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/map_curves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/modal/modes.h"
#include "trivet/response/random/pole_expansion.h"
#include "trivet/response/steady/channel_terms.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {
namespace {

using Complex = std::complex<double>;
constexpr std::size_t most_designs_with_curves = 3000;

/// Every so many of the points of an axis, with both ends and the best design.
std::vector<int> every(int step, int points, std::optional<int> best) {
  std::vector<int> chosen;
  for (int i = 0; i < points; i += step) chosen.push_back(i);
  chosen.push_back(points - 1);
  if (best) chosen.push_back(*best);
  std::ranges::sort(chosen);
  chosen.erase(std::ranges::unique(chosen).begin(), chosen.end());
  return chosen;
}

/// The results of the response that the case requests, else all coordinates as the map sees them.
project::ChannelSelection shown_results(const project::Case& variant, const project::MapRequest& request) {
  if (variant.analyses.response) return variant.analyses.response->selection;
  project::ChannelSelection all;
  all.of = {"coordinates"};
  all.quantity = request.quantity;
  all.excitations = request.excitations;
  return all;
}

class MapCurvesBuilder {
 public:
  MapCurvesBuilder(const project::Case& variant, const DesignMap& map)
      : variant_(variant), map_(map), selection_(shown_results(variant, map.request)) {}

  [[nodiscard]] foundation::Expected<model::System> system_at(std::size_t design) const {
    const design::DesignPoint p = map_.point(design);
    return judging::changed_system(
        variant_, {{project::ModelNumber(map_.request.x), p.x}, {project::ModelNumber(map_.request.y), p.y}});
  }

  /// The band of the response or of the map; without one that of the case, whose upper end moves with the highest
  /// natural frequency of nine designs.
  [[nodiscard]] assembly::Band band(const assembly::Assembled& assembled) const {
    const auto& response = variant_.analyses.response;
    if (response && response->band) return *response->band;
    if (map_.request.band && std::isfinite(map_.request.band->to)) return *map_.request.band;
    const foundation::Progress silent;
    assembly::Band band = default_band(CaseContext(variant_.system, silent));
    const double own = modal::highest_natural_frequency(variant_.system, assembled);
    double highest = own;
    for (const int j : {0, map_.grid.ny / 2, map_.grid.ny - 1})
      for (const int i : {0, map_.grid.nx / 2, map_.grid.nx - 1})
        if (const auto system = system_at(map_.grid.index(i, j)))
          highest = std::max(highest, modal::highest_natural_frequency(*system, assembly::assemble(*system)));
    band.to *= highest / own;
    return band;
  }

  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system,
                                                        const assembly::Assembled& assembled) const {
    return assembly::channels(system, assembled, selection_.of, selection_.quantity);
  }

  /// The curves of a model, or none if it has no poles and residues.
  [[nodiscard]] CurveFractions fractions(const model::System& system, const assembly::Band& band,
                                         const std::vector<double>& delays) const {
    try {
      const assembly::Assembled assembled = assembly::assemble(system);
      if (assembled.frequency_dependent()) return {};
      const assembly::Loading loading = assembly::harmonic_loading(system, assembled, selection_.excitations);
      return curve_fractions(assembled, channels(system, assembled), loading, band, delays);
    } catch (const foundation::NotComputable&) {  // counts as a design without curves, as one without a model does
      return {};
    } catch (const foundation::InvalidInput&) {
      return {};
    }
  }
  [[nodiscard]] CurveFractions fractions_at(std::size_t design, const assembly::Band& band,
                                            const std::vector<double>& delays) const {
    const auto system = system_at(design);
    return system ? fractions(*system, band, delays) : CurveFractions();
  }

  /// Every so many columns and rows of the map.
  void set_grid(int step, MapCurves& curves) const {
    const auto nx = to_size(map_.grid.nx);
    const auto best = [&](std::size_t place) {
      return map_.best ? std::optional(static_cast<int>(place)) : std::nullopt;
    };
    curves.columns = every(step, map_.grid.nx, best(map_.best.value_or(0) % nx));
    curves.rows = every(step, map_.grid.ny, best(map_.best.value_or(0) / nx));
  }
  /// Do so many designs fit? The coarsest grid always does.
  [[nodiscard]] bool fits(int step, double most_bytes, double bytes_of_design) const {
    MapCurves curves;
    set_grid(step, curves);
    return (static_cast<double>(curves.count()) * bytes_of_design <= most_bytes &&
            curves.count() <= most_designs_with_curves) ||
        step >= std::max(map_.grid.nx, map_.grid.ny);
  }

  [[nodiscard]] const project::ChannelSelection& selection() const { return selection_; }

 private:
  const project::Case& variant_;
  const DesignMap& map_;
  project::ChannelSelection selection_;
};

/// Bytes of the stored numbers of one design.
double bytes(const CurveForm& form, bool real, bool of_24_bits) {
  return (real ? 1 : 2) *
      (16.0 * static_cast<double>(form.pairs) + (of_24_bits ? 4.0 : 8.0) * static_cast<double>(form.size()));
}

/// Do poles and residues reproduce the curves of a design?
bool has_curves(const CurveFractions& one) { return one.error <= curves_within; }

/// The powers of s that any design has.
std::vector<int> used_powers(const std::vector<CurveFractions>& all) {
  std::vector<int> used;
  for (int m = response::lowest_power; m <= response::highest_power; ++m)
    if (std::ranges::any_of(all, [&](const CurveFractions& one) {
          const Eigen::Index terms = one.form.terms();
          if (!has_curves(one)) return false;
          for (Eigen::Index i = 2 * one.form.pairs + m - response::lowest_power; i < one.numerators.size(); i += terms)
            if (one.numerators(i) != 0.0) return true;
          return false;
        }))
      used.push_back(m);
  return used;
}

/// Writes a design into its row, with the pairs and powers of all: those that it lacks are 0/(1 + s + s²).
void set_row(const CurveFractions& one, std::size_t node, MapCurves& curves) {
  const CurveForm& form = curves.form;
  for (Eigen::Index k = 0; k < form.pairs; ++k) {
    const bool has = k < one.form.pairs;
    curves.denominators(to_index(node), 2 * k) = has ? one.denominators(2 * k) : Complex(1);
    curves.denominators(to_index(node), 2 * k + 1) = has ? one.denominators(2 * k + 1) : Complex(1);
  }
  for (Eigen::Index row = 0; row < std::ssize(form.delays) * form.curves; ++row) {
    const Eigen::Index from = row * one.form.terms(), to = row * form.terms();
    for (Eigen::Index t = 0; t < 2 * one.form.pairs; ++t)
      curves.numerators(to_index(node), to + t) = one.numerators(from + t);
    for (std::size_t m = 0; m < form.powers.size(); ++m)
      curves.numerators(to_index(node), to + 2 * form.pairs + to_index(m)) =
          one.numerators(from + 2 * one.form.pairs + form.powers[m] - response::lowest_power);
  }
}

/// Stores what was computed. Designs beyond the tolerance have no curves.
void store(const std::vector<CurveFractions>& all, MapCurves& curves) {
  const auto count = to_index(all.size());
  curves.form.powers = used_powers(all);
  curves.form.pairs = 0;
  curves.real = curves.rounded = true;
  curves.drawn.clear();
  curves.worst_error = 0;
  for (const CurveFractions& one : all) {
    curves.drawn.push_back(has_curves(one));
    if (!has_curves(one)) continue;
    curves.real = curves.real && one.real;
    curves.form.pairs = std::max(curves.form.pairs, one.form.pairs);
    curves.rounded = curves.rounded && one.rounded_error <= curves_within;
  }
  curves.denominators = Eigen::MatrixXcd::Zero(count, 2 * curves.form.pairs);
  curves.numerators = Eigen::MatrixXcd::Zero(count, curves.form.size());
  for (std::size_t node = 0; node < all.size(); ++node) {
    if (!curves.drawn[node]) continue;
    set_row(all[node], node, curves);
    curves.worst_error = std::max(curves.worst_error, curves.rounded ? all[node].rounded_error : all[node].error);
  }
  if (curves.rounded) curves.numerators = rounded(curves.numerators);
}

/// Of the designs of a grid, those of a coarser one.
std::vector<CurveFractions> some_of(const std::vector<CurveFractions>& all, const MapCurves& finer,
                                    const MapCurves& coarser) {
  const auto place = [](const std::vector<int>& lines, int line) {
    return to_size(std::ranges::find(lines, line) - lines.begin());
  };
  std::vector<CurveFractions> some;
  for (const int row : coarser.rows)
    for (const int column : coarser.columns)
      some.push_back(all[place(finer.rows, row) * finer.columns.size() + place(finer.columns, column)]);
  return some;
}

}  // namespace

MapCurves map_curves(const project::Case& variant, const DesignMap& map, double most_bytes,
                     const foundation::Progress& progress) {
  MapCurves curves;
  const MapCurvesBuilder builder(variant, map);
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  if (assembled.frequency_dependent() || is_too_large_for_roots(assembled)) {
    curves.reason = assembled.frequency_dependent()
        ? "elements whose stiffness depends on frequency have no poles and residues"
        : "poles of so large a model are not computed";
    return curves;
  }
  curves.band = builder.band(assembled);
  for (const assembly::Channel& channel : builder.channels(variant.system, assembled)) {
    curves.names.push_back(channel.name);
    curves.units.push_back(channel.unit);
  }
  curves.form.curves = std::ssize(curves.names);
  curves.form.delays =
      response::delays_of(assembly::harmonic_loading(variant.system, assembled, builder.selection().excitations));
  const CurveFractions own = builder.fractions(variant.system, curves.band, curves.form.delays);
  CurveForm expected = curves.form;
  expected.pairs = std::max(assembled.matrices.size(), own.form.pairs);
  int step = 1;
  while (!builder.fits(step, most_bytes, bytes(expected, own.real, own.rounded_error <= curves_within))) ++step;
  builder.set_grid(step, curves);
  std::vector<CurveFractions> all(curves.count());
  foundation::parallel_for(
      all.size(), {.progress = progress, .task = "curves of the map"}, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
          all[k] = builder.fractions_at(curves.design(k, map.grid), curves.band, curves.form.delays);
      });
  store(all, curves);
  while (!builder.fits(step, most_bytes, bytes(curves.form, curves.real, curves.rounded))) {
    step *= 2;  // a part of the designs that are computed
    const MapCurves finer = curves;
    builder.set_grid(step, curves);
    all = some_of(all, finer, curves);
    store(all, curves);
  }
  if (std::ranges::count(curves.drawn, true) == 0)
    curves.reason = "the poles of its designs do not reproduce direct solutions";
  return curves;
}

}  // namespace trivet::study
