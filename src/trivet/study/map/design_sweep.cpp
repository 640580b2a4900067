// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/map/design_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/study/analyses/analysis_commands.h"
#include "trivet/study/family/design_batch.h"
#include "trivet/study/family/packed_margins.h"

namespace trivet::study {
namespace {

using foundation::InvalidInput;
using numerics::DesignStatus;
constexpr double without_value = std::numeric_limits<double>::quiet_NaN();
constexpr const char* no_number =
    "the model has no such number; name one that the file has, such as elements.mount.scale, bodies.engine.mass, or x, "
    "y "
    "or z of an array of three; a key that is not written gets a value first: project.changed({...})";
constexpr std::size_t swept_piece = 256;  // designs; their matrices fit in the cache

/// The designs of a sweep, and the results of each.
class Sweep {
 public:
  Sweep(const project::Case& variant, const SweepRequest& request) : case_(variant), request_(request) {
    for (const SweptNumber& number : request.numbers) {
      numbers_.emplace_back(number.path, "");
      count_ *= number.values.size();
    }
    const project::ChannelSelection own = analysis_command("peaks").request(variant).peaks->selection;
    of_ = request.of.empty() ? own.of : request.of;
    excitations_ = request.excitations.empty() ? own.excitations : request.excitations;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& excitations() const { return excitations_; }

  [[nodiscard]] Eigen::VectorXd values(std::size_t design) const {
    Eigen::VectorXd values(to_index(numbers_.size()));
    for (std::size_t i = numbers_.size(); i-- > 0;) {
      const std::vector<double>& along = request_.numbers[i].values;
      values(to_index(i)) = along[design % along.size()];
      design /= along.size();
    }
    return values;
  }

  /// @throws foundation::NotComputable if it is not valid
  [[nodiscard]] model::System system(const Eigen::VectorXd& values) const {
    project::Design design;
    for (std::size_t i = 0; i < numbers_.size(); ++i) design.emplace_back(numbers_[i], values(to_index(i)));
    auto changed = judging::changed_system(case_, design);
    if (!changed) throw foundation::NotComputable(foundation::first_message(changed.error()));
    return std::move(*changed);
  }

  [[nodiscard]] std::vector<assembly::Channel> channels(const model::System& system,
                                                        const assembly::Assembled& assembled) const {
    return assembly::channels(system, assembled, of_, request_.quantity);
  }
  [[nodiscard]] assembly::Loading loading(const model::System& system, const assembly::Assembled& assembled) const {
    return assembly::harmonic_loading(system, assembled, excitations_);
  }

  /// Largest amplitudes of one design. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] Eigen::VectorXd one(const model::System& system) const {
    const assembly::Assembled assembled = assembly::assemble(system);
    const modal::Modes modes = modal::modes(system, assembled);
    const std::vector<assembly::Channel> wanted = channels(system, assembled);
    const double search_to = std::isfinite(request_.band.to) ? request_.band.to : 0;
    const assembly::Loading load = loading(system, assembled);
    const response::Peaks found = response::peaks(assembled, wanted, load, modes,
                                                  modal::roots(system, assembled, modes), {.search_to = search_to});
    Eigen::VectorXd largest(to_index(wanted.size()));
    for (std::size_t c = 0; c < wanted.size(); ++c)
      largest(to_index(c)) = design::largest_in_band(assembled, wanted, load, found, c, request_.band).amplitude;
    return largest;
  }

 private:
  const project::Case& case_;
  const SweepRequest& request_;
  std::vector<project::ModelNumber> numbers_;
  std::vector<std::string> of_, excitations_;
  std::size_t count_ = 1;
};

/// The range of each number in which kernels compute: they interpolate matrices, also of designs without a model, so
/// the ends of the range have one.
struct KernelRange {
  Eigen::VectorXd from, to;
  std::string reason;  ///< why there is none; else empty
};

/// The widest range of the values around that of the file whose ends have a model, with all other numbers as in the
/// file.
KernelRange kernel_range(const Sweep& sweep, const SweepRequest& request, const project::Case& variant) {
  KernelRange range;
  Eigen::VectorXd given(to_index(request.numbers.size()));
  for (std::size_t i = 0; i < request.numbers.size(); ++i)
    given(to_index(i)) = project::ModelNumber(request.numbers[i].path, "").read(variant).value();
  range.from = range.to = given;
  for (std::size_t i = 0; i < request.numbers.size(); ++i) {
    std::vector<double> values = request.numbers[i].values;
    std::ranges::sort(values);
    const double here = given(to_index(i));
    const auto refused = [&](std::size_t at) -> std::string {
      Eigen::VectorXd point = given;
      point(to_index(i)) = values[at];
      try {
        static_cast<void>(sweep.system(point));
        return "";
      } catch (const foundation::NotComputable& reason) {
        return reason.what();
      }
    };
    const auto nearest = to_size(
        std::ranges::min_element(values, {}, [&](double one) { return std::abs(one - here); }) - values.begin());
    range.reason = refused(nearest);
    if (!range.reason.empty()) {
      range.reason = "some designs have no valid model: " + range.reason;
      return range;
    }
    const auto end = [&](std::size_t outer) {
      if (refused(outer).empty()) return values[outer];
      std::size_t with = nearest, without = outer;
      while (std::max(with, without) - std::min(with, without) > 1) {
        const std::size_t between = std::midpoint(with, without);
        (refused(between).empty() ? with : without) = between;
      }
      return values[with];
    };
    range.from(to_index(i)) = end(0);
    range.to(to_index(i)) = end(values.size() - 1);
  }
  return range;
}

/// All designs as sums, their results as amplitudes without a bound.
DesignBatch batch_of(const Sweep& sweep, const SweepRequest& request, const project::Case& variant,
                     const std::vector<std::string>& results, const KernelRange& range) {
  std::vector<RequirementResult> amplitudes;
  for (const std::string& name : results) {
    RequirementResult& one = amplitudes.emplace_back();
    one.subject = name;
    one.quantity = request.quantity;
    one.excitations = sweep.excitations();
    one.band = request.band;
  }
  DesignNumbers numbers;
  for (std::size_t i = 0; i < request.numbers.size(); ++i)
    numbers.variables.push_back({range.from(to_index(i)), range.to(to_index(i)), request.numbers[i].path});
  numbers.any_size = true;
  numbers.compared = design::SumFamily::Compared::ends;
  numbers.model = [&](const Eigen::VectorXd& values) { return sweep.system(values); };
  return {numbers, variant, {}, amplitudes};
}

/// Computes designs and counts how.
class Results {
 public:
  Results(const Sweep& sweep, DesignSweep& found) : sweep_(sweep), found_(found) {}

  void one_by_one(std::size_t design) {
    std::string failure;
    try {
      found_.highest.row(to_index(design)) = sweep_.one(sweep_.system(sweep_.values(design))).transpose();
      const std::lock_guard lock(counting_);
      ++found_.one_by_one;
      return;
    } catch (const foundation::NotComputable& reason) {
      failure = reason.what();
    } catch (const InvalidInput& reason) {
      failure = reason.what();
    }
    found_.highest.row(to_index(design)).setConstant(without_value);
    const std::lock_guard lock(counting_);
    ++found_.without_model;
    if (design < first_without_) {
      first_without_ = design;
      found_.first_failure = failure;
    }
  }

  void in_kernels(const DesignBatch& batch, const KernelRange& range, std::size_t first, std::size_t last) {
    Eigen::MatrixXd points(to_index(last - first), sweep_.values(first).size());
    std::vector<bool> beyond(last - first);  // these are computed in kernels as ends of the range, then one by one
    for (std::size_t i = first; i < last; ++i) {
      const Eigen::VectorXd values = sweep_.values(i), inside = values.cwiseMax(range.from).cwiseMin(range.to);
      points.row(to_index(i - first)) = inside.transpose();
      beyond[i - first] = inside != values;
    }
    const CaseVector::Search& search = batch.packed().searches().front();
    const CaseVector::Unpacked designs = batch.designs(points);
    const numerics::DesignPeaks peaks = searched_peaks(batch.packed(), designs, search);
    std::size_t good = 0;
    for (std::size_t i = first; i < last; ++i) {
      const DesignStatus status = peaks.status[i - first];
      if (beyond[i - first] || designs.falls[i - first] ||
          (status != DesignStatus::proven && status != DesignStatus::fallback)) {
        one_by_one(i);
        continue;
      }
      for (std::size_t c = 0; c < search.curves.size(); ++c)
        found_.highest(to_index(i), to_index(c)) = peaks.highest(to_index(i - first), search.curves[c]);
      ++good;
    }
    const std::lock_guard lock(counting_);
    found_.in_kernels += good;
  }

 private:
  const Sweep& sweep_;
  DesignSweep& found_;
  std::mutex counting_;
  std::size_t first_without_ = std::numeric_limits<std::size_t>::max();
};

void require_numbers(const project::Case& variant, const SweepRequest& request) {
  if (request.numbers.empty())
    throw InvalidInput("sweep: no number to change; give paths and values: {\"elements.mount.scale\": [0.5, 1, 2]}");
  for (const SweptNumber& number : request.numbers) {
    const project::ModelNumber in_model(number.path, "");
    const auto value = in_model.read(variant);
    const auto same =
        value ? judging::changed_system(variant, {{in_model, *value}}) : tl::make_unexpected(foundation::Problems());
    if (!same) throw InvalidInput(fmt::format("sweep: {}: {}", number.path, no_number));
    if (number.values.empty()) throw InvalidInput(fmt::format("sweep: {}: no values; give at least one", number.path));
    for (const double each : number.values)
      if (!std::isfinite(each))
        throw InvalidInput(fmt::format("sweep: {}: {} is not a number; give finite ones", number.path, each));
  }
}

void require_size(const SweepRequest& request, std::size_t results) {
  double values = static_cast<double>(results);
  for (const SweptNumber& number : request.numbers) values *= static_cast<double>(number.values.size());
  if (values > static_cast<double>(most_swept_values))
    throw InvalidInput(fmt::format("sweep: {:.3g} amplitudes; at most {:.0e} at once; take fewer values or results",
                                   values, static_cast<double>(most_swept_values)));
}

}  // namespace

SweptNumber swept_number(const project::Case& variant, const std::string& path,
                         const std::vector<WrittenValue>& values) {
  SweptNumber number{path, {}, project::quantity_at(variant.document, project::path_keys(path))};
  std::string wrong;
  for (const WrittenValue& value : values) {
    if (const double* si = std::get_if<double>(&value)) {
      number.values.push_back(*si);
      continue;
    }
    const std::string& text = std::get<std::string>(value);
    const tl::expected<double, std::string> si =
        number.quantity ? project::to_si(text, *number.quantity) : tl::make_unexpected(std::string(no_number));
    if (!si) wrong += fmt::format("{}\"{}\": {}", wrong.empty() ? "" : "; ", text, si.error());
    number.values.push_back(si.value_or(without_value));
  }
  if (!wrong.empty()) throw InvalidInput(fmt::format("sweep: {}: {}", path, wrong));
  return number;
}

DesignSweep design_sweep(const project::Case& variant, const SweepRequest& request,
                         const foundation::Progress& progress) {
  require_numbers(variant, request);
  if (!(request.band.from >= 0) || !(request.band.from < request.band.to))
    throw InvalidInput("sweep: a band is FROM, TO with 0 ≤ FROM < TO");
  const Sweep sweep(variant, request);
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  DesignSweep found;
  for (const assembly::Channel& channel : sweep.channels(variant.system, assembled)) {
    found.results.push_back(channel.name);
    found.units.push_back(channel.unit);
  }
  static_cast<void>(sweep.loading(variant.system, assembled));  // throws of an excitation that the model does not have
  require_size(request, found.results.size());
  found.highest.resize(to_index(sweep.count()), to_index(found.results.size()));
  Results results(sweep, found);
  const KernelRange range = kernel_range(sweep, request, variant);
  std::optional<DesignBatch> batch;
  if (range.reason.empty()) batch.emplace(batch_of(sweep, request, variant, found.results, range));
  found.no_kernels = batch ? batch->reason() : range.reason;
  const bool at_once = found.no_kernels.empty();
  foundation::parallel_for(sweep.count(), {.size = at_once ? swept_piece : 1, .progress = progress, .task = "designs"},
                           [&](std::size_t first, std::size_t last) {
                             if (at_once) return results.in_kernels(*batch, range, first, last);
                             for (std::size_t i = first; i < last; ++i) results.one_by_one(i);
                           });
  return found;
}

}  // namespace trivet::study
