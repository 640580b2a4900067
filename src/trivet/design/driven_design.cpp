// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/design/driven_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "trivet/assembly/coordinates.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::design {
namespace {

using Terms = std::vector<DrivenDesign::Term>;

/// Terms of a result by powers of s; terms that are zero are left out.
Terms rows_of(const numerics::ObservedCurve& curve, Eigen::Index n) {
  Terms rows;
  const auto add = [&](int power, const Eigen::VectorXcd& row) {
    if (row.size() > 0 && !row.head(n).isZero(0)) rows.push_back({power, row.head(n)});
  };
  add(curve.derivative, curve.of_response.on_displacement);
  add(curve.derivative + 1, curve.of_response.on_velocity.cast<std::complex<double>>());
  add(curve.derivative + 2, curve.of_response.on_acceleration.cast<std::complex<double>>());
  return rows;
}

bool powers_are_possible(const Terms& rows, const Terms& load, bool within_band) {
  return std::ranges::all_of(rows, [&](const DrivenDesign::Term& row) {
    return std::ranges::all_of(load, [&](const DrivenDesign::Term& value) {
      const int power = row.power + value.power;
      return power >= numerics::least_power &&
          power <= (within_band ? numerics::most_power_in_band : numerics::most_power);
    });
  });
}

/// Adds the contribution of the ground motion. @return false unless it is constant over ω
bool add_given(const numerics::ObservedCurve& curve, const numerics::Load& given, std::complex<double>& constant) {
  if (curve.of_given.empty()) return true;
  for (const numerics::LoadTerm& term : given.terms()) {
    const Eigen::Index n = term.value.size();
    const auto part = [&](const auto& row, int power) {
      if (row.size() == 0) return true;
      const std::complex<double> sum = row.head(n).template cast<std::complex<double>>().cwiseProduct(term.value).sum();
      if (sum == 0.0) return true;
      constant += sum;
      return power + term.power + curve.derivative == 0;
    };
    if (!part(curve.of_given.on_displacement, 0) || !part(curve.of_given.on_velocity, 1) ||
        !part(curve.of_given.on_acceleration, 2))
      return false;
  }
  return true;
}

/// Turns a load whose components are in phase to be real. The phase counts modulo π: small changes do not flip signs.
void turn_to_real(Eigen::VectorXcd& load) {
  if (load.imag().isZero(0)) return;
  Eigen::Index largest = 0;
  const double size = load.cwiseAbs().maxCoeff(&largest);
  const std::complex<double> phase = (load(largest).real() < 0 ? -1.0 : 1.0) * load(largest) / size;
  const Eigen::VectorXcd turned = load * std::conj(phase);
  constexpr double round_off = 1e-15;
  if (turned.imag().cwiseAbs().maxCoeff() <= round_off * size) load = turned.real().cast<std::complex<double>>();
}

/// The numbers of a term, real before imaginary parts.
Eigen::VectorXd both_parts(const Eigen::VectorXcd& value) {
  Eigen::VectorXd parts(2 * value.size());
  parts << value.real(), value.imag();
  return parts;
}

/// Calls `matrix` for A, B, K and D, `vector` for every term with whether it is a row, `number` for every constant.
template <typename Design, typename OfMatrix, typename OfVector, typename OfNumber>
void visit(Design& design, const OfMatrix& matrix, const OfVector& vector, const OfNumber& number) {
  for (auto* m : {&design.A, &design.B, &design.K, &design.D}) matrix(*m);
  for (auto& load : design.loads)
    for (auto& term : load) vector(term);
  for (auto& curve : design.curves) {
    for (auto& row : curve.rows) vector(row);
    number(curve);
  }
}

/// What design_peaks needs of a design beside its matrices and its load; none if it has loss factors, a load that is
/// not real or changes with ω, or results that are no real rows on displacements and velocities.
std::optional<numerics::DesignPeakOptions> plain_results(const DrivenDesign& design) {
  const auto is_real = [](const DrivenDesign::Term& term) { return term.value.imag().isZero(0); };
  const auto is_static = [&](const DrivenDesign::Term& term) { return term.power == 0 && is_real(term); };
  if (!design.D.isZero(0) || design.loads.size() != 1 || design.loads[0].size() > 1) return std::nullopt;
  if (!std::ranges::all_of(design.loads[0], is_static)) return std::nullopt;
  numerics::DesignPeakOptions results;
  results.rows = Eigen::ArrayXXd::Zero(to_index(design.curves.size()), design.A.rows());
  Eigen::ArrayXXd on_velocity = results.rows;
  for (std::size_t c = 0; c < design.curves.size(); ++c) {
    const Terms& rows = design.curves[c].rows;
    const int power = rows.empty() ? 0 : rows.front().power;
    constexpr int most_derivative = 2;
    const bool has_form = rows.size() <= 2 && power <= most_derivative && std::ranges::all_of(rows, is_real) &&
        (rows.size() < 2 || rows[1].power == power + 1) && design.curves[c].constant == 0.0;
    if (!has_form) return std::nullopt;
    results.derivative.push_back(power);
    if (!rows.empty()) results.rows.row(to_index(c)) = rows[0].value.real().transpose().array();
    if (rows.size() == 2) on_velocity.row(to_index(c)) = rows[1].value.real().transpose().array();
  }
  if (!on_velocity.isZero(0)) results.rows_on_velocity = std::move(on_velocity);
  return results;
}

numerics::DesignPeaks undecided(Eigen::Index designs, Eigen::Index curves) {
  const Eigen::ArrayXXd none = Eigen::ArrayXXd::Zero(designs, curves);
  return {none, none, none.cast<int>(), none, std::vector(to_size(designs), numerics::DesignStatus::undecided)};
}

bool same_powers(const Terms& a, const Terms& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const DrivenDesign::Term& one, const DrivenDesign::Term& two) { return one.power == two.power; });
}

}  // namespace

DesignOrReason<DrivenDesign> driven_design(const assembly::Assembled& assembled,
                                           const std::vector<assembly::Channel>& channels,
                                           const assembly::Loading& loading, bool within_band) {
  const numerics::DynamicMatrices& m = assembled.matrices;
  const Eigen::Index n = m.size();
  if (assembled.frequency_dependent()) return {{}, "frequency-dependent elements"};
  if (!m.symmetric) return {{}, "matrices that are not symmetric"};
  if (to_index(numerics::massive_rows(m.A).size()) < n) return {{}, "coordinates without mass"};
  if (loading.longest_delay() > 0) return {{}, "motions with delays"};
  DrivenDesign design{m.A, m.B, m.K, m.lossy() ? m.K_loss : Eigen::MatrixXd::Zero(n, n), {}, {}};
  design.curves.resize(channels.size());
  for (const assembly::ChannelGroup& group : assembly::by_coordinates(assembled.ground, channels, loading)) {
    const assembly::GivenCurves given = assembly::given_curves(group.channels, group.loading.motion);
    Terms& load = design.loads.emplace_back();
    const numerics::Load side = assembly::right_side(assembled, group.loading);
    for (const numerics::LoadTerm& term : side.terms()) load.push_back({term.power, term.value});
    for (std::size_t k = 0; k < group.which.size(); ++k) {
      DrivenDesign::Curve& curve = design.curves[group.which[k]];
      curve.load = design.loads.size() - 1;
      curve.rows = rows_of(given.curves[k], n);
      const std::string& name = channels[group.which[k]].name;
      if (!powers_are_possible(curve.rows, load, within_band))
        return {{}, fmt::format("{} grows without bound towards low or high frequencies", name)};
      if (!add_given(given.curves[k], given.given, curve.constant))
        return {{}, fmt::format("{} contains the given motion of the ground, which changes with the frequency", name)};
    }
    const bool moves = std::ranges::any_of(group.which, [&](auto k) { return design.curves[k].constant != 0.0; });
    if (load.size() == 1 && !moves) turn_to_real(load.front().value);
  }
  if (n > numerics::most_driven_coordinates && !channels.empty() && !plain_results(design))
    return {{}, "more than twelve coordinates"};
  if (!numerics::is_positive_definite(m.K)) return {{}, "rigid-body modes or unstable motions"};
  return {std::move(design), ""};
}

Eigen::VectorXd packed(const DrivenDesign& design) {
  std::vector<double> all;
  visit(
      design,
      [&](const Eigen::MatrixXd& m) {
        for (Eigen::Index i = 0; i < m.rows(); ++i)
          for (Eigen::Index j = 0; j <= i; ++j) all.push_back(m(i, j));
      },
      [&](const DrivenDesign::Term& term) {
        const Eigen::VectorXd parts = both_parts(term.value);
        all.insert(all.end(), parts.begin(), parts.end());
      },
      [&](const DrivenDesign::Curve& curve) {
        all.push_back(curve.constant.real());
        all.push_back(curve.constant.imag());
      });
  return Eigen::Map<const Eigen::VectorXd>(all.data(), to_index(all.size()));
}

Eigen::VectorXd scales(const DrivenDesign& design) {
  DrivenDesign scale = design;
  const Eigen::VectorXd root_of_mass = design.A.diagonal().cwiseAbs().cwiseSqrt();
  visit(
      scale,
      [](Eigen::MatrixXd& m) {
        const Eigen::VectorXd root = m.diagonal().cwiseAbs().cwiseSqrt();
        m = root * root.transpose();
      },
      [&](DrivenDesign::Term& term) {
        const double size = term.value.cwiseAbs().cwiseQuotient(root_of_mass).maxCoeff();
        term.value.real() = size * root_of_mass;
        term.value.imag() = term.value.real();
      },
      [](DrivenDesign::Curve& curve) {
        const double size = std::abs(curve.constant);
        curve.constant = {size, size};
      });
  return packed(scale);
}

std::string reason_for_separate_families(const DrivenDesign& a, const DrivenDesign& b) {
  if (a.A.rows() != b.A.rows()) return "designs with more coordinates than others";
  bool same = a.loads.size() == b.loads.size() && a.curves.size() == b.curves.size();
  for (std::size_t l = 0; same && l < a.loads.size(); ++l) same = same_powers(a.loads[l], b.loads[l]);
  for (std::size_t c = 0; same && c < a.curves.size(); ++c)
    same = a.curves[c].load == b.curves[c].load && same_powers(a.curves[c].rows, b.curves[c].rows);
  return same ? "" : "designs of which some have excitations or forces through dampers and others none";
}

Eigen::Index matrix_entries(Eigen::Index coordinates) { return 4 * (coordinates * (coordinates + 1) / 2); }

numerics::DrivenDesigns unpacked_like(const DrivenDesign& first, const Eigen::MatrixXd& entries, Eigen::Index at) {
  const Eigen::Index n = first.A.rows(), triangle = n * (n + 1) / 2;
  numerics::DrivenDesigns designs{entries.leftCols(triangle).array(),
                                  entries.middleCols(triangle, triangle).array(),
                                  entries.middleCols(2 * triangle, triangle).array(),
                                  entries.middleCols(3 * triangle, triangle).array(),
                                  {},
                                  {}};
  const auto next = [&](Eigen::Index columns) -> Eigen::ArrayXXd {
    at += columns;
    return entries.middleCols(at - columns, columns).array();
  };
  const auto terms_like = [&](const Terms& terms) {
    std::vector<numerics::DesignTerm> result;
    for (const DrivenDesign::Term& term : terms) {
      numerics::DesignTerm& to = result.emplace_back();
      to.power = term.power;
      to.re = next(n);
      to.im = next(n);
    }
    return result;
  };
  for (const Terms& load : first.loads) designs.loads.push_back(terms_like(load));
  for (const DrivenDesign::Curve& curve : first.curves) {
    numerics::DesignCurve& to = designs.curves.emplace_back();
    to.load = curve.load;
    to.rows = terms_like(curve.rows);
    to.constant_re = next(1);
    to.constant_im = next(1);
  }
  assert(at <= entries.cols() && "a design has as many entries as the first one");
  return designs;
}

numerics::DesignPeaks peaks_of(const DrivenDesign& first, const Eigen::MatrixXd& entries, Eigen::Index at,
                               const numerics::DrivenPeakOptions& options) {
  const Eigen::Index n = first.A.rows(), triangle = n * (n + 1) / 2;
  std::optional<numerics::DesignPeakOptions> plain = plain_results(first);
  const Eigen::Index loads = plain ? 2 * n * to_index(first.loads[0].size()) : 0;
  const auto stays = [&](Eigen::Index from, Eigen::Index count, const auto& row) {
    return (entries.middleCols(from, count).rowwise() - row.transpose()).cwiseAbs().sum() == 0;
  };
  if (plain) {
    const Eigen::VectorXd own = packed(first);
    const Eigen::Index fixed = own.size() - matrix_entries(n) - loads;
    const bool same = stays(at + loads, fixed, own.tail(fixed)) &&
        stays(3 * triangle, triangle, Eigen::VectorXd::Zero(triangle)) &&
        (loads == 0 || stays(at + n, n, Eigen::VectorXd::Zero(n)));
    if (!same) plain.reset();
  }
  if (!plain && n > numerics::most_driven_coordinates) return undecided(entries.rows(), to_index(first.curves.size()));
  if (!plain) return numerics::driven_peaks(unpacked_like(first, entries, at), options);
  plain->from = options.from;
  plain->to = options.to;
  plain->count_peaks = options.count_peaks;
  plain->min_prominence = options.min_prominence;
  plain->threads = 1;
  Eigen::ArrayXXd load = Eigen::ArrayXXd::Zero(1, n);
  if (loads > 0) load = entries.middleCols(at, n).array();
  return numerics::design_peaks({entries.leftCols(triangle).array(), entries.middleCols(triangle, triangle).array(),
                                 entries.middleCols(2 * triangle, triangle).array(), std::move(load)},
                                *plain);
}

}  // namespace trivet::design
