// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/select/mount_combinations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/judging/changed_case.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/project/model_number.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/spatial/rigid_motion.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/requirements/verdict.h"
#include "trivet/study/select/summed_model.h"

namespace trivet::study {
namespace {

/// Of more their numbers overflow.
constexpr std::size_t most_combinations = 1000000000000000000;
/// Smaller ω² as a share of the largest are those of free motions.
constexpr double at_rest = 1e-9;

/// Windows without natural frequencies ω, and their separation, from the ω²; `judge` gets each margin.
template <typename Judge>
void judge_frequencies(const project::Requirements& required, const Eigen::VectorXd& squares, const Judge& judge) {
  double lower = 0;
  for (const double square : squares) {
    if (square <= at_rest * squares.tail<1>()(0)) continue;
    const double omega = std::sqrt(square);
    for (const assembly::Band& window : required.avoided)
      judge(MountTest::natural_frequencies, margin_outside(window, omega));
    if (required.separation > 0 && lower > 0)
      judge(MountTest::natural_frequencies, margin_of_least(required.separation, omega / lower));
    lower = omega;
  }
}

/// Least margin of the loads of one mount in its ranges; 0 if a load without a range makes the design not judged.
double bound_of_loads(const model::Rating& rating, const Eigen::Vector3d& load) {
  constexpr double surely = 1 + 1e-6;  // round-off must not bring a bound below the margin
  double least = foundation::infinity;
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    const auto& range = rating.load[i];
    if (range) least = std::min(least, margin_in_range(load(i), *range));
    else if (std::abs(load(i)) > surely * response::noticeable_load * load.norm()) least = 0;
  }
  return least;
}

/// The rated mounts among these elements, their rows on p of q = Φ p.
template <typename Selected, typename Mount>
void add_mounts(const CaseContext& context, const Eigen::MatrixXd& shapes, const Selected& selected,
                std::vector<Mount>& mounts, double& price, double& mass) {
  const response::AtRest at_rest(context.system, context.assembled);
  for (std::size_t e = 0; e < context.system.elements().size(); ++e) {
    const model::Element& element = context.system.elements()[e];
    if (!element.rating || !selected(element.name)) continue;
    MountRows rows = mount_rows(at_rest.system(), at_rest.assembled(), at_rest.system().elements()[e]);
    rows.load = (rows.load * shapes).eval();
    rows.deflection = rows.deflection * shapes;
    mounts.push_back({*element.rating, std::move(rows)});
    price += element.rating->price ? element.rating->price->amount : 0;
    mass += element.rating->mass.value_or(0);
  }
}

/// @throws foundation::NotComputable with the first reason if it is not valid
template <typename Model>
Model valid(foundation::Expected<Model> changed) {
  if (changed) return std::move(*changed);
  throw foundation::NotComputable(foundation::first_reason(changed.error()) + "; " +
                                  foundation::error_of(changed.error()).remedy);
}

/// A case must not set a mount that a choice sets: the choice would undo it.
void refuse_overruled_cases(const std::vector<project::MountChoice>& choices, const project::Project& project,
                            const std::vector<const project::Case*>& cases) {
  for (const project::MountChoice& choice : choices)
    for (const project::Case* variant : cases)
      for (const std::string& name : choice.elements) {
        const auto type_in = [&](const project::Case& one) {
          for (const model::Element& element : one.system.elements())
            if (element.name == name) return element.type;
          return std::string();
        };
        if (type_in(*variant) != type_in(project.base()))
          throw foundation::InvalidInput(fmt::format(
              "choices of mounts: the case {} sets the mount of {}, which the choice {} sets too; remove one of them, "
              "or leave the "
              "case out of hold_in",
              foundation::quoted(variant->name), foundation::quoted(name), foundation::quoted(choice.name)));
      }
}

/// What the data of one mount lack for the requirements of a case.
std::vector<std::string> lacks(const model::Rating& rating, const project::Requirements& required) {
  std::vector<std::string> result;
  if (required.mount_load && !rating.has_load_range()) result.emplace_back("load range");
  if (required.mass > 0 && !rating.mass) result.emplace_back("mass");
  if (required.price && !(rating.price && rating.price->currency == required.price->currency))
    result.push_back("price in " + foundation::quoted(required.price->currency));
  return result;
}

/// Every mount of every choice can be used at its places, and has a price in the required currency, a mass and a load
/// range, where these count.
void refuse_unusable_mounts(const MountCombinations& all) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lacking;  // data and the mounts without them
  const auto add = [&](const std::string& data, const std::string& mount) {
    auto at = std::ranges::find_if(lacking, [&](const auto& one) { return one.first == data; });
    if (at == lacking.end()) at = lacking.insert(at, {data, {}});
    if (std::ranges::find(at->second, mount) == at->second.end()) at->second.push_back(mount);
  };
  for (const project::Case* variant : all.cases()) {
    const project::Requirements required = variant->analyses.requirements.value_or(project::Requirements());
    for (std::size_t c = 0; c < all.choices().size(); ++c)
      for (std::size_t m = 0; m < all.choices()[c].mounts.size(); ++m) {
        const std::string shown = foundation::quoted(all.choices()[c].mounts[m]);
        try {
          const model::System system = all.system_with(*variant, c, m);
          for (const model::Element& element : system.elements())
            if (element.name == all.choices()[c].elements.front() && element.rating)
              for (const std::string& data : lacks(*element.rating, required)) add(data, shown);
        } catch (const foundation::NotComputable& refused) {
          throw foundation::InvalidInput("choices of mounts: " + shown + " cannot be used in the choice " +
                                         foundation::quoted(all.choices()[c].name) + ": " + refused.what());
        }
      }
  }
  if (lacking.empty()) return;
  std::string words;
  for (const auto& [data, mounts] : lacking)
    words += (words.empty() ? "no " : "; no ") + data + " of " + foundation::comma_separated(mounts);
  throw foundation::InvalidInput("choices of mounts: the catalogue gives " + words +
                                 "; add it to the catalogue, name choices without these mounts, or remove the "
                                 "requirement");
}

}  // namespace

std::vector<const project::Case*> deciding_cases(const project::Project& project) {
  const std::vector<std::string> hold_in = cases_to_hold(project);
  std::vector<const project::Case*> cases;
  for (const project::Case& variant : project.cases)
    if (std::ranges::find(hold_in, variant.name) != hold_in.end() && has_something_to_judge(variant))
      cases.push_back(&variant);
  if (cases.empty())
    throw foundation::InvalidInput(
        "requirements.hold_in: no case in which the requirements hold has any; name one that has requirements or "
        "limits");
  return cases;
}

MountCombinations::MountCombinations(const project::Project& project, std::vector<const project::Case*> cases)
    : choices_(project.base().analyses.choices), cases_(std::move(cases)) {
  if (choices_.empty())
    throw foundation::InvalidInput(
        "choices of mounts: the file has none; write [parameters.NAME] with path = 'elements.NAME.type' and "
        "choices = [\"catalogue:MOUNT\", …], or catalogue = \"FILE\"");
  for (const project::MountChoice& choice : choices_) {
    if (choice.mounts.size() > most_combinations / count_)
      throw foundation::InvalidInput(fmt::format(
          "choices of mounts: more than {:.0e} combinations; let more places share one choice, or name fewer "
          "mounts in choices",
          static_cast<double>(most_combinations)));
    strides_.push_back(count_);
    count_ *= choice.mounts.size();
  }
  refuse_overruled_cases(choices_, project, cases_);
  refuse_unusable_mounts(*this);
  try {
    for (const project::Case* variant : cases_) sums_.push_back(sums_of(*variant));
    compare_with_assembled();
  } catch (const NoSum& no_sum) {
    without_bounds_ = no_sum.reason;
  } catch (const foundation::NotComputable& refused) {
    without_bounds_ = refused.what();
  }
}

std::vector<std::size_t> MountCombinations::mounts(std::size_t combination) const {
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < choices_.size(); ++c) result.push_back(mount(combination, c));
  return result;
}

model::System MountCombinations::system_with(const project::Case& variant, std::size_t choice,
                                             std::size_t mount) const {
  return valid(judging::changed_system(variant, std::vector{change_of(choices_[choice], mount)}, true));
}

std::vector<project::Node> MountCombinations::changes(std::size_t combination) const {
  std::vector<project::Node> result;
  const std::vector<std::size_t> numbers = mounts(combination);
  for (std::size_t c = 0; c < numbers.size(); ++c) result.push_back(change_of(choices_[c], numbers[c]));
  return result;
}

model::System MountCombinations::system(const project::Case& variant, std::size_t combination) const {
  return valid(judging::changed_system(variant, changes(combination)));
}

project::Project MountCombinations::project(const project::Project& given, std::size_t combination) const {
  project::Project result{given.title, given.source, given.folder, given.sha256, {}};
  for (const project::Case& variant : given.cases) {
    const bool decides = std::ranges::find(cases_, &variant) != cases_.end();
    if (decides || &variant == &given.base())
      result.cases.push_back(valid(judging::changed_case(variant, changes(combination))));
  }
  return result;
}

void MountCombinations::add_decoupled(const CaseContext& given, Sums& sums) {
  const assembly::Assembled& assembled = given.assembled;
  const auto& bodies = given.system.bodies();
  if (assembled.layout.of_bodies() != assembled.matrices.size()) return;  // coordinates inside elements move along
  for (const project::Requirements::Decoupling& wanted : sums.required.decoupling) {
    const auto at = std::ranges::find_if(bodies, [&](const auto& body) { return body.name == wanted.body; });
    std::vector<Eigen::Index> rows;
    std::vector<int> coordinates;
    for (int j = 0; j < 6; ++j)
      if (const Eigen::Index row = assembled.layout.row(to_size(at - bodies.begin()), j); row >= 0) {
        rows.push_back(row);
        coordinates.push_back(j);
      }
    Decoupled& one = sums.decoupled.emplace_back();
    one.least = wanted.least;
    one.whole = to_index(rows.size()) == assembled.matrices.size();
    Eigen::MatrixXd at_pole;  // motions of the body, six coordinates × r
    at_pole.setZero(6, to_index(rows.size()));
    if (one.whole) {
      at_pole(coordinates, Eigen::all) = sums.shapes(rows, Eigen::all);
    } else {
      const Eigen::MatrixXd inertia = assembled.matrices.A(rows, rows);
      const Eigen::MatrixXd own = Eigen::MatrixXd(
          numerics::symmetric_eigen(Eigen::MatrixXd::Identity(inertia.rows(), inertia.rows()).eval(), inertia).vectors);
      at_pole(coordinates, Eigen::all) = own;
      const Eigen::MatrixXd of_body = Eigen::MatrixXd(assembled.matrices.A(Eigen::all, rows)) * own;
      one.basis = sums.shapes.transpose() * of_body;  // p = Φᵀ A q
    }
    const spatial::MassProperties& mass = at->mass;
    one.motion = spatial::rigid_motion(mass.centre) * at_pole;
    one.momentum.resize(6, one.motion.cols());
    one.momentum << mass.mass * one.motion.topRows<3>(), mass.inertia_about_centre * one.motion.bottomRows<3>();
  }
}

MountCombinations::Sums MountCombinations::sums_of(const project::Case& variant) const {
  const foundation::Progress silent;
  const CaseContext given(variant.system, silent);
  const SummedModel base = summed_model(variant.system, given.assembled);
  if (!numerics::is_positive_definite(base.inertia)) throw NoSum{"some coordinates have no mass"};
  Sums sums;
  sums.shapes = numerics::symmetric_eigen(base.stiffness, base.inertia).vectors;
  sums.stiffness = sums.shapes.transpose() * base.first * sums.shapes;
  sums.rest_stiffness = sums.shapes.transpose() * base.rest_stiffness * sums.shapes;
  sums.forces_at_rest = on_shapes(base.forces_at_rest, sums.shapes);
  sums.load = sums.shapes.transpose() * base.load;
  if (base.beside.size() > 0) sums.beside = sums.shapes.transpose() * base.beside;
  sums.loaded = variant.system.description().gravity || !variant.system.description().constant_forces.empty();
  if (variant.analyses.requirements) sums.required = *variant.analyses.requirements;
  add_decoupled(given, sums);
  const auto is_of = [](const project::MountChoice& choice, const std::string& name) {
    return std::ranges::find(choice.elements, name) != choice.elements.end();
  };
  add_mounts(
      given, sums.shapes,
      [&](const std::string& name) {
        return std::ranges::none_of(choices_, [&](const auto& choice) { return is_of(choice, name); });
      },
      sums.mounts, sums.price, sums.mass);
  for (std::size_t c = 0; c < choices_.size(); ++c) {
    std::vector<Option>& options = sums.options.emplace_back();
    for (std::size_t m = 0; m < choices_[c].mounts.size(); ++m) {
      const model::System changed = system_with(variant, c, m);
      const CaseContext context(changed, silent);
      const SummedModel assembly = summed_model(changed, context.assembled);
      if (!equal(assembly.inertia, base.inertia)) throw NoSum{"the mounts change the inertia"};
      Option& option = options.emplace_back();
      option.stiffness = sums.shapes.transpose() * (assembly.first - base.first) * sums.shapes;
      option.rest_stiffness = sums.shapes.transpose() * (assembly.rest_stiffness - base.rest_stiffness) * sums.shapes;
      option.forces_at_rest = on_shapes(assembly.forces_at_rest, sums.shapes) - sums.forces_at_rest;
      option.load = sums.shapes.transpose() * (assembly.load - base.load);
      add_mounts(
          context, sums.shapes, [&](const std::string& name) { return is_of(choices_[c], name); }, option.mounts,
          option.price, option.mass);
    }
  }
  return sums;
}

void MountCombinations::compare_with_assembled() {
  for (const std::size_t combination : spread_combinations()) {
    const std::vector<std::size_t> numbers = mounts(combination);
    for (std::size_t v = 0; v < cases_.size(); ++v) {
      const model::System whole = system(*cases_[v], combination);
      const SummedModel assembled = summed_model(whole, assembly::assemble(whole));
      const Added sum = added(sums_[v], numbers);
      const Eigen::MatrixXd& shapes = sums_[v].shapes;
      const auto on_p = [&](const Eigen::MatrixXd& of_q) -> Eigen::MatrixXd {
        return shapes.transpose() * of_q * shapes;
      };
      if (!equal(sum.stiffness, on_p(sum.has_rest ? assembled.stiffness : assembled.first)) ||
          !equal(sum.rest_stiffness, on_p(assembled.rest_stiffness)) ||
          !equal(sum.load, Eigen::VectorXd(shapes.transpose() * assembled.load)) ||
          !equal(on_p(assembled.inertia), Eigen::MatrixXd(Eigen::MatrixXd::Identity(sum.load.size(), sum.load.size()))))
        throw NoSum{"the model of a combination is no sum over its mounts"};
    }
  }
}

MountCombinations::Added MountCombinations::added(const Sums& sums, const std::vector<std::size_t>& mounts) {
  Added result{sums.stiffness, sums.rest_stiffness, {}, sums.load};
  Eigen::MatrixXd forces_at_rest = sums.forces_at_rest;
  for (std::size_t c = 0; c < mounts.size(); ++c) {
    const Option& option = sums.options[c][mounts[c]];
    result.stiffness += option.stiffness;
    result.rest_stiffness += option.rest_stiffness;
    result.load += option.load;
    forces_at_rest += option.forces_at_rest;
  }
  result.standing = result.rest_stiffness;
  if (forces_at_rest.size() == 0) return result;
  result.has_rest = numerics::is_positive_definite(result.rest_stiffness);
  if (!result.has_rest) return result;
  const Eigen::Index n = result.load.size();
  const Eigen::VectorXd sum = forces_at_rest.col(0) +
      forces_at_rest.rightCols(n) * numerics::cholesky_solution(result.rest_stiffness, result.load);
  result.stiffness += sum.reshaped(n, n);
  result.standing += sum.reshaped(n, n);
  return result;
}

MountCombinations::Bound MountCombinations::bound(const Sums& sums, const std::vector<std::size_t>& mounts) const {
  Bound result{foundation::infinity, MountTest::none};
  const auto judge = [&](MountTest test, double margin) {
    if (margin < 1 && result.failed == MountTest::none) result.failed = test;
    result.margin = std::min(result.margin, margin);
    const double square = 1 / (margin * margin), fourth = square * square, eighth = fourth * fourth;
    result.crowding += eighth * eighth;
  };
  double price = sums.price, mass = sums.mass;
  for (std::size_t c = 0; c < mounts.size(); ++c) {
    price += sums.options[c][mounts[c]].price;
    mass += sums.options[c][mounts[c]].mass;
  }
  if (sums.required.price) judge(MountTest::price, margin_of(sums.required.price->amount, price));
  if (sums.required.mass > 0) judge(MountTest::mass, margin_of(sums.required.mass, mass));
  const bool wants_loads = sums.required.mount_load && sums.loaded;
  const bool wants_frequencies = !sums.required.avoided.empty() || sums.required.separation > 0;
  const bool wants_decoupling = !sums.decoupled.empty();
  if (!wants_loads && !wants_frequencies && !wants_decoupling) return result;
  const auto [stiffness, rest_stiffness, standing, load, has_rest] = added(sums, mounts);
  if (!has_rest) return result;  // no position of rest to first order: the verdict says so
  const bool wants_shapes = wants_decoupling && std::ranges::any_of(sums.decoupled, &Decoupled::whole);
  const UnitModes modes =
      wants_shapes ? unit_modes(stiffness) : UnitModes{numerics::symmetric_eigenvalues(stiffness), {}};
  const Eigen::VectorXd& squares = modes.squares;
  if (squares(0) < -at_rest * squares.tail<1>()(0)) return result;  // falls over: the verdict says so
  if (wants_loads) {
    if (squares(0) <= at_rest * squares.tail<1>()(0))
      return result;  // no position of rest: the verdict gives the reason
    if (!numerics::is_positive_definite(rest_stiffness) || !numerics::is_positive_definite(standing)) return result;
    Eigen::VectorXd rest;
    if (sums.beside.size() == 0) rest = numerics::cholesky_solution(rest_stiffness, load);
    else
      rest = numerics::cholesky_solution(rest_stiffness, Eigen::VectorXd(load - sums.beside)) +
          numerics::cholesky_solution(standing, sums.beside);
    std::vector<const Mount*> all;
    const auto add = [&](const std::vector<Mount>& list) {
      for (const Mount& mount : list) all.push_back(&mount);
    };
    add(sums.mounts);
    for (std::size_t c = 0; c < mounts.size(); ++c) add(sums.options[c][mounts[c]].mounts);
    std::vector<response::RatedLoad> loads;
    for (const Mount* mount : all) {
      const MountRows& rows = mount->rows;
      loads.push_back(
          {loads.size(), rows.load * rest + rows.load_at_rest, rows.deflection.dot(rest) + rows.deflection_at_rest});
    }
    response::remove_round_off(loads);
    for (const response::RatedLoad& one : loads)
      judge(MountTest::load, bound_of_loads(all[one.element]->rating, one.load));
    for (const response::RatedLoad& one : loads)
      if (const auto& limit = all[one.element]->rating.deflection)
        judge(MountTest::deflection, margin_of(*limit, one.deflection));
  }
  if (wants_frequencies) judge_frequencies(sums.required, squares, judge);
  if (!wants_decoupling) return result;
  for (const Decoupled& one : sums.decoupled) {
    double share = 0;
    if (one.whole) {
      share = least_decoupling(one.motion, one.momentum, modes);
    } else {
      share = least_decoupling(one.motion, one.momentum, unit_modes(one.basis.transpose() * stiffness * one.basis));
    }
    judge(MountTest::decoupling, margin_of_least(one.least, share));
  }
  return result;
}

std::vector<MountCombinations::Bound> MountCombinations::bounds(const std::vector<std::size_t>& combinations,
                                                                const foundation::Progress& progress) const {
  std::vector<Bound> result(combinations.size(), {foundation::infinity, MountTest::none});
  if (!without_bounds_.empty()) return result;
  constexpr std::size_t piece = 256;
  foundation::parallel_for(combinations.size(),
                           {.size = piece, .progress = progress, .task = "loads and natural frequencies"},
                           [&](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last; ++i)
                               for (const Sums& sums : sums_) {
                                 const Bound here = bound(sums, mounts(combinations[i]));
                                 result[i].margin = std::min(result[i].margin, here.margin);
                                 if (result[i].failed == MountTest::none) result[i].failed = here.failed;
                                 result[i].crowding += here.crowding;
                               }
                           });
  return result;
}

std::vector<std::size_t> MountCombinations::spread_combinations() const {
  constexpr std::size_t count = 6;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i + 1 < count; ++i) result.push_back((count_ - 1) / (count - 1) * i);
  result.push_back(count_ - 1);
  return result;
}

std::vector<std::size_t> MountCombinations::scattered(std::size_t wanted) const {
  const double golden = std::numbers::phi - 1;  // its multiples modulo 1 lie evenly
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < wanted; ++k) {
    const double share = golden * static_cast<double>(k);
    result.push_back(static_cast<std::size_t>((share - std::floor(share)) * static_cast<double>(count_)));
  }
  std::ranges::sort(result);
  result.erase(std::ranges::unique(result).begin(), result.end());
  return result;
}

std::vector<std::size_t> MountCombinations::all() const {
  if (count_ > most_judged_combinations)
    throw foundation::InvalidInput(
        fmt::format("choices of mounts: {:.3g} combinations, more than {}; let more places share one choice, or name "
                    "fewer mounts in choices",
                    static_cast<double>(count_), most_judged_combinations));
  std::vector<std::size_t> result(count_);
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

}  // namespace trivet::study
