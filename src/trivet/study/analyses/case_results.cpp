// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/case_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <numbers>

#include "trivet/assembly/loads.h"
#include "trivet/design/design_rules.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/model/nodes.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/response/steady/resonant_mode.h"
#include "trivet/study/analyses/analysis_run.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/analyses/curve_results.h"

namespace trivet::study {
namespace {

/// Channels and load of an analysis under harmonic forces.
struct DrivenChannels {
  std::vector<assembly::Channel> channels;
  assembly::Loading load;
};

DrivenChannels driven_channels(const model::System& system, const assembly::Assembled& assembled,
                               const project::ChannelSelection& selection) {
  if (!project::is_driven(system, project::Drive::harmonic)) throw without_excitation("response, peaks");
  return {assembly::channels(system, assembled, selection.of, selection.quantity),
          assembly::harmonic_loading(system, assembled, selection.excitations)};
}

double lowest_defined(const assembly::Assembled& assembled) {
  double lowest = 0;
  for (const assembly::ElementMap& map : assembled.elements) lowest = std::max(lowest, map.defined_from);
  return lowest;
}

std::vector<Eigen::VectorXd> phases(const CaseContext& c, const DrivenChannels& driven,
                                    const response::FrequencyResponse& response, const response::Peaks& peaks,
                                    bool continuous) {
  std::vector<Eigen::VectorXd> result;
  if (!continuous) {
    for (const response::Curve& curve : response.curves)
      result.push_back(curve.value.unaryExpr([](const std::complex<double>& z) { return response::phase(z); }).real());
    return result;
  }
  // Whole turns are counted from ω = 0 along a grid fine enough to miss none, for any requested points.
  const auto& requested_at = response.angular_frequency;
  const double top = std::ranges::max(requested_at);
  const response::CurveModel model = response::curve_model(c.assembled, driven.channels, driven.load, c.roots().poles,
                                                           peaks, {lowest_defined(c.assembled), top}, {}, c.progress);
  std::vector<double> grid = response::drawing_grid(model, peaks);
  grid.insert(grid.end(), requested_at.begin(), requested_at.end());
  std::ranges::sort(grid);
  grid.erase(std::ranges::unique(grid).begin(), grid.end());
  const Eigen::MatrixXcd dense = model.at(grid);
  for (std::size_t curve = 0; curve < response.curves.size(); ++curve) {
    const Eigen::VectorXd along = response::continuous_phase(dense.row(to_index(curve)).transpose());
    Eigen::VectorXd at(to_index(requested_at.size()));
    for (std::size_t i = 0; i < requested_at.size(); ++i) {
      const auto row = to_index(i);
      const double own = response::phase(response.curves[curve].value(row));
      const double followed = along(std::ranges::lower_bound(grid, requested_at[i]) - grid.begin());
      at(row) = std::isfinite(followed)
          ? own + 2 * std::numbers::pi * std::round((followed - own) / (2 * std::numbers::pi))
          : own;
    }
    result.push_back(at);
  }
  return result;
}

/// At most `most` of the numbers, first and last included.
std::vector<double> subsample(const std::vector<double>& all, int most) {
  const std::size_t count = std::min(all.size(), to_size(most));
  if (count < 2) return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
  std::vector<double> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * (all.size() - 1) / (count - 1)]);
  return some;
}

class CaseStudy {
 public:
  /// Of a response everything, or its model alone, which is enough to draw it.
  enum class Extent { whole, model };

  CaseStudy(std::shared_ptr<const SolvedCase> solved, const foundation::Progress& progress,
            Extent extent = Extent::whole)
      : c_(std::move(solved), progress), extent_(extent) {}

  CaseResults notices(const project::Case& variant, const project::Analyses& analyses) {
    for (const project::Analyses* requested : {&variant.analyses, &analyses})
      if (requested->response && requested->response->band) search_to_ = requested->response->band->to;
    CaseResults result;
    result.case_name = variant.name;
    result.changes = variant.changes;
    result.display = variant.display;
    result.free_motions = modal::free_motions(c_.system, c_.assembled, c_.modes);
    result.notes = model::left_out_notes(c_.system.description());
    for (std::string& note : nonlinear::notes_about_rest(c_.system)) result.notes.push_back(std::move(note));
    for (std::string& note : plausibility::first_order_notes(c_.system, c_.assembled))
      result.notes.push_back(std::move(note));
    result.modes = c_.modes;
    const int lowest = analyses.lowest_modes;
    if (lowest > 0 && (result.modes.lowest_only || std::ssize(result.modes.list) > lowest)) {
      result.modes.list.resize(to_size(lowest));
      result.lowest_modes = lowest;
    }
    result.warnings = variant.warnings;
    result.warnings.add(c_.modes.warnings);
    if (analyses.roots || !modal::cannot_grow(c_.assembled, c_.modes))
      result.warnings.add(is_too_large_for_roots(c_.assembled) ? warning_of_unknown_roots() : c_.roots().warnings);
    if (analyses.roots) {
      result.roots = c_.roots();
      result.warnings.add(c_.roots().remarks);
    }
    result.warnings.add(case_warnings(c_, analyses, search_to_));
    return result;
  }

  CaseResults compute(const project::Case& variant, const project::Analyses& analyses) {
    CaseResults result = notices(variant, analyses);
    const auto refuse = [&](const std::exception& reason) {
      result.failures.emplace_back(reason.what());
      result.warnings.warning(reason.what(), "not computed", "", "");
    };
    const auto attempt = [&](const auto& compute) {
      try {
        compute();
      } catch (const foundation::NotComputable& reason) {
        refuse(reason);
      }
    };
    const auto attempt_analysis = [&](const auto& compute) {
      try {
        attempt(compute);
      } catch (const foundation::InvalidInput& reason) {  // an analysis that does not apply to this model
        refuse(reason);
      }
    };
    with_extrema_ = extent_ == Extent::whole || analyses.peaks;
    if (analyses.peaks) attempt([&] { result.peaks = peaks_result(*analyses.peaks); });
    if (analyses.response) attempt([&] { result.response = response_of(*analyses.response); });
    if (result.response) attempt([&] { result.limits = limits_of(analyses, *result.response); });
    if (analyses.static_of)
      attempt([&] {
        const nonlinear::StaticMachine rest = nonlinear::static_machine(c_.system, c_.assembled);
        result.statics = response::static_response(rest.system, rest.assembled, *analyses.static_of);
        if (analyses.all_rest_states) result.rest_states = nonlinear::rest_states(c_.system);
      });
    run_analyses(analyses, attempt_analysis, result);
    return result;
  }

 private:
  template <typename Attempt>
  void run_analyses(const project::Analyses& analyses, const Attempt& attempt, CaseResults& result) const {
    if (analyses.load_sharing && result.statics) {
      try {
        const nonlinear::StaticMachine rest = nonlinear::static_machine(c_.system, c_.assembled);
        result.load_sharing = response::load_sharing(rest.system, rest.assembled);
      } catch (const foundation::NotComputable&) {  // load sharing was not requested, and a model without mounts
                                                    // under its weight has none
      }
    }
    for (const AnalysisRun& analysis : analysis_runs()) attempt([&] { analysis.compute(c_, analyses, result); });
    std::vector<project::LimitLineRequest> over_response = analyses.limit_lines;
    std::erase_if(over_response, [](const project::LimitLineRequest& line) { return line.bands.has_value(); });
    if (result.response && !over_response.empty())
      attempt([&] {
        result.limit_lines = limit_line_results(c_, over_response, analyses.response->selection, result.response->band);
      });
    for (const project::LimitLineRequest& line : analyses.limit_lines)
      if (line.bands) attempt([&] { result.limit_lines.push_back(band_line_result(c_, line)); });
    if (result.response && !analyses.measurements.empty())
      attempt([&] { result.measurements = measurement_comparisons(c_, analyses, result.response->band); });
  }

  /// Peaks of a set of curves. The automatic grid, the peaks and the limits use the same curves: each set is searched
  /// once.
  const response::Peaks& peaks_of(const project::ChannelSelection& selection,
                                  double min_prominence = response::PeakOptions{}.min_prominence) {
    for (const auto& earlier : searched_)
      if (earlier.selection == selection && earlier.min_prominence == min_prominence) return earlier.peaks;
    const DrivenChannels driven = driven_channels(c_.system, c_.assembled, selection);
    searched_.push_back({selection, min_prominence,
                         response::peaks(c_.assembled, driven.channels, driven.load, c_.modes, c_.roots(),
                                         {.min_prominence = min_prominence, .search_to = search_to_}, c_.progress)});
    return searched_.back().peaks;
  }

  PeaksResult peaks_result(const project::PeaksRequest& request) {
    PeaksResult result{peaks_of(request.selection, request.min_prominence), request.min_prominence,
                       request.peak_tolerance};
    const DrivenChannels driven = driven_channels(c_.system, c_.assembled, request.selection);
    response::set_nearest_modes(c_.assembled, driven.channels, driven.load, c_.modes, result.peaks);
    return result;
  }

  /// A model that is only drawn, without extrema, needs few digits of the poles: it states its own error.
  [[nodiscard]] const Eigen::VectorXcd& poles() const {
    return extent_ == Extent::model && !with_extrema_ ? c_.rough_poles() : c_.roots().poles;
  }

  ResponseResult response_of(const project::ResponseRequest& request) {
    const DrivenChannels driven = driven_channels(c_.system, c_.assembled, request.selection);
    ResponseResult result;
    result.quantity = request.selection.quantity;
    result.continuous_phase = request.continuous_phase;
    const bool needs_peaks = with_extrema_ &&
        (request.continuous_phase || (request.at.empty() && request.spacing == project::Spacing::automatic));
    const response::Peaks peaks = needs_peaks ? peaks_of(request.selection) : response::Peaks{};
    std::vector<double> grid = request.at;
    if (grid.empty()) {
      result.band = request.band ? *request.band : default_band(c_, poles());
      if (!(result.band.from < result.band.to))
        throw foundation::NotComputable(
            "response: the tables of the elements and the natural frequencies have no band in common; give a band");
      if (request.spacing == project::Spacing::linear) grid = response::linear_grid(result.band, request.points);
      else if (request.spacing == project::Spacing::automatic) {
        result.model = response::curve_model(c_.assembled, driven.channels, driven.load, poles(), peaks, result.band,
                                             {}, c_.progress);
        result.extrema = response::extrema(peaks, result.band);
        result.extrema.resize(driven.channels.size());  // without peaks there are none
        if (extent_ == Extent::model) return drawn_alone(driven, peaks, std::move(result));
        grid = response::drawing_grid(*result.model, peaks);
      } else {
        if (!(result.band.from > 0))
          throw foundation::NotComputable("response: a logarithmic grid needs a band that starts above 0");
        grid = response::logarithmic_grid(result.band, request.points);
      }
    } else {
      result.band = {std::ranges::min(grid), std::ranges::max(grid)};
    }
    foundation::report_progress(c_.progress, "response", 0.5);
    // With constant matrices solving costs less than evaluating the curve model; with exact springs or tables it costs
    // more.
    result.curves = result.model && c_.assembled.frequency_dependent()
        ? response::interpolated(*result.model, driven.channels, peaks, grid)
        : response::frequency_response(c_.assembled, driven.channels, driven.load, grid);
    result.phase = phases(c_, driven, result.curves, peaks, request.continuous_phase);
    foundation::report_progress(c_.progress, "check by a second solver", 0.8);
    const int checked = project::deep_check_frequencies(c_.assembled.matrices.A.rows());
    const std::vector<double> samples = request.at.empty()
        ? response::check_frequencies(c_.resonances(), result.band.from, result.band.to, checked)
        : subsample(grid, checked);
    result.deep = response::deep_check(c_.system, c_.assembled, driven.load, samples, request.selection.excitations);
    return result;
  }

  /// Completes a response that is its model alone.
  ResponseResult drawn_alone(const DrivenChannels& driven, const response::Peaks& peaks, ResponseResult result) const {
    result.curves = response::interpolated(*result.model, driven.channels, peaks, {result.band.from});
    result.phase = phases(c_, driven, result.curves, peaks, result.continuous_phase);
    return result;
  }

  std::vector<LimitResult> limits_of(const project::Analyses& analyses, const ResponseResult& response) {
    std::vector<LimitResult> result;
    response_ = &response;
    for (const project::Limit& limit : analyses.limits) {
      project::ChannelSelection selection = analyses.response->selection;
      const auto& curves = response.curves.curves;
      const bool among_curves =
          std::ranges::any_of(curves, [&](const response::Curve& c) { return c.name == limit.name; });
      if (!among_curves) selection.of = {limit.name};
      result.push_back(limit_result(limit, selection, response.band));
    }
    return result;
  }

  /// Is the amplitude unbounded as ω → 0 (an absolute motion under a ground given by its acceleration)? The search for
  /// peaks begins above 0 and does not show it.
  bool grows_toward_rest(const response::Peaks& found, std::size_t curve, const DrivenChannels& driven) const {
    constexpr double rounding = 1e-9, nearer = 0.25, growth = 2;  // a curve ∝ ω⁻¹ grows by 4
    const response::CurveSummary& summary = found.curves[curve];
    const bool from_tables = std::ranges::any_of(c_.assembled.elements,
                                                 [](const assembly::ElementMap& map) { return map.defined_from > 0; });
    if (from_tables) return false;  // unknown below the tables
    if (!(found.searched_from > 0) || summary.highest_at > found.searched_from * (1 + rounding)) return false;
    const auto near_rest =
        response::frequency_response(c_.assembled, driven.channels, driven.load, {nearer * found.searched_from});
    return std::abs(near_rest.curves[curve].value(0)) > growth * summary.highest;
  }

  /// Compares a limit with the largest amplitude of its curve in a band: at an end of the band or at a peak inside it.
  LimitResult limit_result(const project::Limit& limit, const project::ChannelSelection& selection,
                           const assembly::Band& band) {
    const response::Peaks& found = peaks_of(selection);
    const auto curve =
        to_size(std::ranges::find(found.curves, limit.name, &response::CurveSummary::name) - found.curves.begin());
    LimitResult computed{
        limit.name, found.curves[curve].unit, limit.amplitude, 0, band.from, found.curves[curve].highest, true};
    const DrivenChannels driven = driven_channels(c_.system, c_.assembled, selection);
    if (grows_toward_rest(found, curve, driven)) computed.anywhere = std::numeric_limits<double>::infinity();
    const design::LargestAmplitude largest =
        design::largest_in_band(c_.assembled, driven.channels, driven.load, found, curve, band);
    computed.in_band = largest.amplitude;
    computed.in_band_at = largest.angular_frequency;
    if (response_ && response_->band.from == band.from && response_->band.to == band.to)
      for (const response::Curve& drawn : response_->curves.curves)
        for (Eigen::Index i = 0; drawn.name == limit.name && i < drawn.value.size(); ++i)
          if (const double size = std::abs(drawn.value(i)); std::isfinite(size) && size > computed.in_band)
            computed.in_band = size, computed.in_band_at = response_->curves.angular_frequency[i];
    computed.met = design::meets_limit(computed.in_band, computed.limit);
    return computed;
  }

  CaseContext c_;
  Extent extent_;

  struct Searched {
    project::ChannelSelection selection;
    double min_prominence;
    response::Peaks peaks;
  };
  bool with_extrema_ = true;
  const ResponseResult* response_ = nullptr;  // while limits are judged
  double search_to_ = 0;  // peaks of frequency-dependent systems are searched at least over the band of the response
  std::deque<Searched> searched_;  // references to its elements stay valid
};

/// The analyses of a file were checked against these sizes when it was read; those of a command line are checked here.
void require_admissible_size(const project::Case& variant, const project::Analyses& analyses) {
  const foundation::Problems sizes = project::too_large(variant.system.description(), analyses);
  if (const foundation::Problem* first = foundation::first_error(sizes))
    throw foundation::NotComputable(foundation::first_reason(sizes) + "; " + first->remedy);
}

}  // namespace

CaseResults case_results(const project::Case& variant, const project::Analyses& analyses,
                         const foundation::Progress& progress, const std::shared_ptr<const SolvedCase>& solved) {
  require_admissible_size(variant, analyses);
  const int lowest = project::lowest_modes_suffice(analyses) ? analyses.lowest_modes : 0;
  return CaseStudy(solved ? solved : std::make_shared<const SolvedCase>(variant.system, lowest), progress)
      .compute(variant, analyses);
}

CaseResults curve_results(const project::Case& variant, const project::Analyses& request,
                          const foundation::Progress& progress, const std::shared_ptr<const SolvedCase>& solved) {
  require_admissible_size(variant, request);
  return CaseStudy(solved, progress, CaseStudy::Extent::model).compute(variant, request);
}

CaseResults notices(const project::Case& variant, const project::Analyses& analyses,
                    const std::shared_ptr<const SolvedCase>& solved) {
  const foundation::Progress silent;
  return CaseStudy(solved, silent).notices(variant, analyses);
}

response::DeepCheck deep_check(const project::Case& variant) {
  const foundation::Progress silent;
  if (project::coordinates(variant.system.description()) > project::most_coordinates)
    throw foundation::NotComputable(
        fmt::format("deep check: a model of more than {} free coordinates; split it", project::most_coordinates));
  const CaseContext c(variant.system, silent);
  const assembly::Assembled& assembled = c.assembled;
  const auto& request = variant.analyses.response;
  const assembly::Band band = request && request->band ? *request->band : default_band(c);
  assembly::Loading load = assembly::harmonic_loading(variant.system, assembled);
  if (load.vanishes()) {
    Eigen::VectorXcd everywhere = Eigen::VectorXcd::Zero(assembled.layout.size());
    const Eigen::Index bodies = assembled.layout.of_bodies();
    everywhere.head(bodies) =
        numerics::unit_scale(assembled.matrices).cwiseInverse().head(bodies).cast<std::complex<double>>();
    load = assembly::Loading(everywhere);
  }
  return response::deep_check(
      variant.system, assembled, load,
      response::check_frequencies(c.resonances(), band.from, band.to,
                                  project::deep_check_frequencies(assembled.matrices.A.rows())));
}

}  // namespace trivet::study
