// SPDX-License-Identifier: BSD-3-Clause
// |y|² of the curves of DrivenDesigns as partial fractions in x = ω, one design per lane. With poles p = −iλ and
// y = c + Σ ρ_k/(ω − p_k), ρ = −i residue, |y|² is |c|² + 2 Re Σ C_k/(ω − p_k) at real ω, C_k = ρ_k ȳ(p_k),
// ȳ(ω) = c̄ + Σ ρ̄_l/(ω − p̄_l). Where powers of s add up to 3 or 4, c is a polynomial of ω, and |y|² has also
// |c|² and 2 Re Σ ρ_k (c̄(ω) − c̄(p_k))/(ω − p_k), a polynomial too.
#if defined(TRIVET_NUMERICS_DRIVEN_CURVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVET_NUMERICS_DRIVEN_CURVES_INL_H_
#undef TRIVET_NUMERICS_DRIVEN_CURVES_INL_H_
#else
#define TRIVET_NUMERICS_DRIVEN_CURVES_INL_H_
#endif

#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <memory>

#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/curve_search-inl.h"
#include "trivet/numerics/batch/round_off-inl.h"
#include "trivet/numerics/roots/design_columns-inl.h"
#include "trivet/numerics/roots/designs.h"
#include "trivet/numerics/roots/driven_poles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// A few objects with packs in them. (With g++ 12, a std::vector of them allocated 16 bytes as alignment, not 64.)
template <typename Item>
class PackList {
 public:
  PackList() = default;
  explicit PackList(std::size_t size) : size_(size), items_(new Item[size]) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  Item& operator[](std::size_t i) {
    assert(i < size_);
    return items_[i];
  }
  const Item& operator[](std::size_t i) const {
    assert(i < size_);
    return items_[i];
  }
  [[nodiscard]] const Item* begin() const { return items_.get(); }
  [[nodiscard]] const Item* end() const { return items_.get() + size_; }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<Item[]> items_;
};

/// Φᵀ times a DesignTerm.
template <typename Size>
struct ModalTerm {
  int power = 0;
  ComplexPack value[Size::most];
};

template <typename Size>
HWY_INLINE void in_modes_of_term(Size n, const PackOfModes<Size>& modes, const DesignTerm& term, Eigen::Index first,
                                 ModalTerm<Size>& result) {
  Pack part[Size::most], image[Size::most];
  result.power = term.power;
  for (int j = 0; j < n; ++j) part[j] = column_of(term.re, j, first);
  in_modes_of_vector(n, modes, part, image);
  for (int j = 0; j < n; ++j) result.value[j].re = image[j], part[j] = column_of(term.im, j, first);
  in_modes_of_vector(n, modes, part, image);
  for (int j = 0; j < n; ++j) result.value[j].im = image[j];
}

HWY_INLINE ComplexPack integer_power_of(const ComplexPack& z, int power) {
  ComplexPack result = {all(1.0), all(0.0)};
  const ComplexPack factor = power < 0 ? quick_inverse(z) : z;
  for (int i = 0; i < std::abs(power); ++i) result = result * factor;
  return result;
}

/// Σ λ^power valueᵀ v at root p.
template <typename Size>
HWY_INLINE ComplexPack sum_at_root(Size n, const DrivenPoles<Size>& poles, int p,
                                   const PackList<ModalTerm<Size>>& terms) {
  ComplexPack sum = zero();
  for (const ModalTerm<Size>& term : terms) {
    ComplexPack part = zero();
    each(n, [&](int j) TRIVET_LANES { part = add_product(part, term.value[j], poles.v[p * n + j]); });
    sum = sum + integer_power_of(poles.lambda[p], term.power) * part;
  }
  return sum;
}

/// One load of a pack of designs: its participation in every root, and scales of the motion.
template <typename Size>
struct DrivenLoad {
  PackList<ModalTerm<Size>> terms;
  ComplexPack participation[2 * Size::most];
  Pack visible[2 * Size::most], possible[2 * Size::most];  ///< see round_off-inl.h
};

template <typename Size>
HWY_NOINLINE void form_load(Size n, const DrivenPoles<Size>& poles, DrivenLoad<Size>& load) {
  Pack motion[2 * Size::most], modulus[2 * Size::most], at_rest = hn::Zero(Lanes()), accelerated = at_rest;
  for (int p = 0; p < 2 * n; ++p) {
    load.participation[p] = sum_at_root(n, poles, p, load.terms) * poles.by_slope[p];
    motion[p] = squared_modulus(load.participation[p]);
    modulus[p] = squared_modulus(poles.lambda[p]);
    at_rest = hn::Max(at_rest, hn::Div(motion[p], modulus[p]));
    accelerated = hn::Max(accelerated, hn::Mul(motion[p], modulus[p]));
  }
  for (int p = 0; p < 2 * n; ++p) {
    const Pack decay = poles.lambda[p].re;
    load.visible[p] = hn::Max(motion[p], hn::Mul(at_rest, hn::Mul(decay, decay)));
    load.possible[p] = hn::Max(motion[p], hn::Div(accelerated, modulus[p]));
  }
}

/// The curves of a pack of designs.
/// @tparam Poles  size of 2n
template <typename Size, typename Poles>
class DrivenCurves {
 public:
  DrivenCurves(Size n, const DrivenDesigns& designs, Eigen::Index first)
      : n_(n),
        designs_(designs),
        first_(first),
        poles_(new DrivenPoles<Size>),
        modal_(new LossyModalPack<Size>),
        inverses_(new Inverses) {}

  /// Poles and |y|² of all curves.
  HWY_NOINLINE void form(FormedCurves<Poles>& formed) {
    assert(formed.ends.size() == designs_.curves.size() && first_ < designs_.count() + table_lanes);
    formed.round_off = all(round_off);
    formed.pack.wanted = find_poles();
    place_poles(formed.pack.poles);
    form_loads();
    formed.complete = hn::Eq(formed.round_off, formed.round_off);
    for (std::size_t c = 0; c < designs_.curves.size(); ++c)
      formed.complete = hn::And(formed.complete, form_curve(designs_.curves[c], formed.curves[c].f));
  }

 private:
  static constexpr double round_off = 4e-15;     ///< of sums over the poles
  static constexpr double most_condition = 1e3;  ///< beyond, poles nearly coincide
  struct Inverses {
    ComplexPack of[Poles::most][Poles::most];  ///< 1/(p_k − p̄_l)
    Pack modulus[Poles::most][Poles::most];
  };

  LaneMask find_poles() {
    constexpr int triangle = Size::most * (Size::most + 1) / 2;
    Pack a[triangle], b[triangle], k[triangle], d[triangle];
    const bool lossy = designs_.D.size() > 0 && (designs_.D != 0).any();
    for (int entry = 0; entry < n_ * (n_ + 1) / 2; ++entry) {
      a[entry] = column_of(designs_.A, entry, first_);
      b[entry] = column_of(designs_.B, entry, first_);
      k[entry] = column_of(designs_.K, entry, first_);
      if (lossy) d[entry] = column_of(designs_.D, entry, first_);
    }
    const LaneMask definite = modes_of_pack<true>(n_, a, k, modes_);
    lossy_modal_pack(n_, modes_, b, lossy ? d : nullptr, *modal_);
    driven_poles(n_, *modal_, *poles_);
    Pack stiffest = all(0.0);
    for (int j = 0; j < n_; ++j) stiffest = hn::Max(stiffest, modes_.lambda[j]);
    // Smaller λ may be round-off of no stiffness: 64 n ε, eight times the limit of definiteness.
    const Pack least = hn::Mul(all(64 * n_ * 2.2e-16), stiffest);
    LaneMask good = hn::And(hn::And(definite, modes_.settled),
                            hn::And(poles_->good, hn::Le(poles_->condition, all(most_condition))));
    for (int j = 0; j < n_; ++j) good = hn::And(good, hn::Gt(modes_.lambda[j], least));
    return good;
  }

  /// p = −iλ, and the reciprocals of their differences.
  void place_poles(SquarePoles<Poles>& to) {
    const int count = 2 * n_;
    to.count = Poles{count};
    for (int p = 0; p < count; ++p) {
      const ComplexPack lambda = poles_->lambda[p];
      to.z[p] = {lambda.im, hn::Neg(lambda.re)};
      to.real[p] = hn::Lt(lambda.im, lambda.im);
      for (int l = 0; l < count; ++l) {
        const ComplexPack other = poles_->lambda[l];
        inverses_->of[p][l] = quick_inverse({hn::Sub(lambda.im, other.im), hn::Neg(hn::Add(lambda.re, other.re))});
        inverses_->modulus[p][l] = hn::Sqrt(squared_modulus(inverses_->of[p][l]));
      }
    }
    place(to);
  }

  void form_loads() {
    loads_ = PackList<DrivenLoad<Size>>(designs_.loads.size());
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      loads_[l].terms = PackList<ModalTerm<Size>>(designs_.loads[l].size());
      for (std::size_t t = 0; t < loads_[l].terms.size(); ++t)
        in_modes_of_term(n_, modes_, designs_.loads[l][t], first_, loads_[l].terms[t]);
      form_load(n_, *poles_, loads_[l]);
    }
  }

  /// A sum and the sum of the moduli of its terms.
  struct Constant {
    ComplexPack value;
    Pack moduli;
  };

  /// c = c₀ + c₁ω + c₂ω²
  struct Polynomial {
    Constant of[3];
    bool grows = false;  ///< c₁ or c₂ may differ from 0
  };

  /// Adds the product of a row and a vector.
  void add(const ComplexPack* row, const ComplexPack* vector, Constant& to) const {
    each(n_, [&](int j) TRIVET_LANES {
      const ComplexPack part = row[j] * vector[j];
      to.value = to.value + part;
      to.moduli = hn::Add(to.moduli, one_norm(part));
    });
  }

  /// −ΦᵀBΦ times a vector.
  void damped(const ComplexPack* vector, ComplexPack* image) const {
    each(n_, [&](int i) TRIVET_LANES {
      image[i] = zero();
      for (int j = 0; j < n_; ++j) {
        const Pack entry = hn::Neg(modal_->b[packed_of(i, j)]);
        image[i] = image[i] + ComplexPack{hn::Mul(entry, vector[j].re), hn::Mul(entry, vector[j].im)};
      }
    });
  }

  /// Adds −(Ω² + iΦᵀDΦ) times a vector.
  void add_restored(const ComplexPack* vector, ComplexPack* image) const {
    each(n_, [&](int i) TRIVET_LANES {
      const Pack square = hn::Neg(modes_.lambda[i]);
      image[i] = image[i] + ComplexPack{hn::Mul(square, vector[i].re), hn::Mul(square, vector[i].im)};
      for (int j = 0; modal_->lossy && j < n_; ++j) {
        const Pack entry = modal_->d[packed_of(i, j)];
        image[i] = image[i] + ComplexPack{hn::Mul(entry, vector[j].im), hn::Neg(hn::Mul(entry, vector[j].re))};
      }
    });
  }

  /// c: of a prescribed motion, and the powers of s that are left of terms whose powers add up to 2 or more, from
  /// Z⁻¹ = s⁻² − B s⁻³ + (B² − Ω² − iD) s⁻⁴ … of modes; 0 if it is round-off of its terms.
  Polynomial constants_of(const DesignCurve& curve, const PackList<ModalTerm<Size>>& rows) const {
    Polynomial c;
    for (Constant& one : c.of) one = {zero(), hn::Zero(Lanes())};
    c.of[0].value = {column_of(curve.constant_re, 0, first_), column_of(curve.constant_im, 0, first_)};
    c.of[0].moduli = one_norm(c.of[0].value);
    for (const ModalTerm<Size>& row : rows)
      for (const ModalTerm<Size>& value : loads_[curve.load].terms) {
        const int beyond = row.power + value.power - most_power;
        if (beyond < 0) continue;
        assert(beyond <= 2 && "checked designs have powers of s up to s⁴");
        add(row.value, value.value, c.of[beyond]);
        if (beyond == 0) continue;
        c.grows = true;
        ComplexPack second[Size::most], third[Size::most];
        damped(value.value, second);
        add(row.value, second, c.of[beyond - 1]);
        if (beyond == 1) continue;
        damped(second, third);
        add_restored(value.value, third);
        add(row.value, third, c.of[0]);
      }
    for (Constant& one : c.of) {
      const LaneMask seen = hn::Gt(one_norm(one.value), hn::Mul(all(vanishing_share), one.moduli));
      one = {{hn::IfThenElseZero(seen, one.value.re), hn::IfThenElseZero(seen, one.value.im)},
             hn::IfThenElseZero(seen, one.moduli)};
    }
    // s = iω
    c.of[1].value = {hn::Neg(c.of[1].value.im), c.of[1].value.re};
    c.of[2].value = {hn::Neg(c.of[2].value.re), hn::Neg(c.of[2].value.im)};
    return c;
  }

  /// (Σ |λ|^power ‖Φᵀrow‖)² at root p.
  Pack weight_of(const PackList<ModalTerm<Size>>& rows, int p) const {
    const Pack square = squared_modulus(poles_->lambda[p]), modulus = hn::Sqrt(square);
    Pack sum = hn::Zero(Lanes());
    for (const ModalTerm<Size>& row : rows) {
      Pack length = hn::Zero(Lanes());
      each(n_, [&](int j) TRIVET_LANES { length = hn::Add(length, squared_modulus(row.value[j])); });
      length = hn::Sqrt(length);
      for (int i = 0; i < row.power; ++i) length = hn::Mul(length, modulus);
      sum = hn::Add(sum, length);
    }
    return hn::Mul(sum, sum);
  }

  /// Σ_p λ_p (rowᵀv_p)(v_pᵀvalue)/slope_p = rowᵀA⁻¹value for the sums of the rows and of the load: fails if a root that
  /// they see was found twice.
  LaneMask sees_every_root(const PackList<ModalTerm<Size>>& rows, const DrivenLoad<Size>& load) const {
    ComplexPack row[Size::most], value[Size::most], sum = zero();
    Pack moduli = hn::Zero(Lanes());
    for (int j = 0; j < n_; ++j) {
      row[j] = value[j] = zero();
      for (const ModalTerm<Size>& term : rows) row[j] = row[j] + term.value[j];
      for (const ModalTerm<Size>& term : load.terms) value[j] = value[j] + term.value[j];
      const ComplexPack product = row[j] * value[j];
      sum = sum - product;
      moduli = hn::Add(moduli, one_norm(product));
    }
    for (int p = 0; p < 2 * n_; ++p) {
      ComplexPack of_row = zero(), of_value = zero();
      each(n_, [&](int j) TRIVET_LANES {
        of_row = add_product(of_row, row[j], poles_->v[p * n_ + j]);
        of_value = add_product(of_value, value[j], poles_->v[p * n_ + j]);
      });
      const ComplexPack part = poles_->lambda[p] * poles_->by_slope[p] * of_row * of_value;
      sum = sum + part;
      moduli = hn::Add(moduli, one_norm(part));
    }
    return hn::Le(one_norm(sum), hn::Mul(all(1e-9), moduli));
  }

  /// Lanes in which the errors of the residues cannot be seen next to a constant.
  LaneMask hidden_by(const ComplexPack& constant, const DrivenLoad<Size>& load, const Pack* weight) const {
    constexpr double of_residue = 1e-15, unseen = 1e-11;
    const Pack limit = hn::Mul(all(unseen * unseen / (of_residue * of_residue)), squared_modulus(constant));
    LaneMask hidden = hn::Gt(limit, hn::Zero(Lanes()));
    for (int p = 0; p < 2 * n_; ++p) {
      const Pack decay = poles_->lambda[p].re;
      hidden = hn::And(hidden, hn::Le(hn::Mul(weight[p], load.possible[p]), hn::Mul(limit, hn::Mul(decay, decay))));
    }
    return hidden;
  }

  /// C_k = ρ_k ȳ(p_k), with the moduli of its terms.
  void form_fractions(const PairPack* r, const Polynomial& c, SquaredResponse<Poles::most>& f) const {
    const int count = 2 * n_;
    const Constant& constant = c.of[0];
    Pack size[Poles::most];
    for (int k = 0; k < count; ++k) size[k] = hn::Sqrt(squared_size(r[k]));
    for (int k = 0; k < count; ++k) {
      ComplexPack y = conjugate(constant.value);
      // ȳ(p_k) = c̄(p_k) + Σ_l ρ̄_l/(p_k − p̄_l)
      Pack moduli = constant.moduli;
      if (c.grows) {
        const ComplexPack at = pole(k);
        const Pack modulus = hn::Sqrt(squared_modulus(at));
        y = y + at * (conjugate(c.of[1].value) + at * conjugate(c.of[2].value));
        moduli = hn::MulAdd(modulus, hn::MulAdd(modulus, c.of[2].moduli, c.of[1].moduli), moduli);
      }
      for (int l = 0; l < count; ++l) {
        y = add_product(y, ComplexPack{r[l].first, hn::Neg(r[l].second)}, inverses_->of[k][l]);
        moduli = hn::MulAdd(size[l], inverses_->modulus[k][l], moduli);
      }
      const ComplexPack C = ComplexPack{r[k].first, r[k].second} * y;
      f.C[k] = {C.re, hn::Neg(C.im)};
      f.parts[k] = hn::Mul(size[k], moduli);
    }
    const Pack modulus = hn::Sqrt(squared_modulus(constant.value));
    f.constant = hn::Mul(all(0.5), hn::Mul(modulus, modulus));
    f.constant_parts = hn::Mul(modulus, constant.moduli);
    f.slope = f.slope_parts = hn::Zero(Lanes());
    f.grows = c.grows;
    if (c.grows) add_growth(r, size, c, f);
  }

  /// −iλ
  [[nodiscard]] ComplexPack pole(int k) const { return {poles_->lambda[k].im, hn::Neg(poles_->lambda[k].re)}; }

  /// Half of |c|² without |c₀|², and Re Σ ρ_k (c̄(ω) − c̄(p_k))/(ω − p_k) = Re Σ ρ_k (c̄₁ + c̄₂ (ω + p_k)).
  void add_growth(const PairPack* r, const Pack* size, const Polynomial& c, SquaredResponse<Poles::most>& f) const {
    ComplexPack sum = zero(), first = zero();
    Pack sum_parts = hn::Zero(Lanes()), first_parts = sum_parts;
    for (int k = 0; k < 2 * n_; ++k) {
      const ComplexPack rho = {r[k].first, r[k].second};
      sum = sum + rho;
      first = first + rho * pole(k);
      sum_parts = hn::Add(sum_parts, size[k]);
      first_parts = hn::MulAdd(size[k], hn::Sqrt(squared_modulus(pole(k))), first_parts);
    }
    const ComplexPack q0 = conjugate(c.of[0].value), q1 = conjugate(c.of[1].value), q2 = conjugate(c.of[2].value);
    const Pack m0 = c.of[0].moduli, m1 = c.of[1].moduli, m2 = c.of[2].moduli, half = all(0.5);
    f.constant = hn::Add(f.constant, (q1 * sum + q2 * first).re);
    f.constant_parts = hn::MulAdd(m1, sum_parts, hn::MulAdd(m2, first_parts, f.constant_parts));
    f.slope = (q0 * c.of[1].value + q2 * sum).re;
    f.slope_parts = hn::MulAdd(m0, m1, hn::Mul(m2, sum_parts));
    f.growth[0] = hn::MulAdd(half, squared_modulus(q1), (q0 * c.of[2].value).re);
    f.growth_parts[0] = hn::MulAdd(hn::Mul(half, m1), m1, hn::Mul(m0, m2));
    f.growth[1] = (q1 * c.of[2].value).re;
    f.growth_parts[1] = hn::Mul(m1, m2);
    f.growth[2] = hn::Mul(half, squared_modulus(q2));
    f.growth_parts[2] = hn::Mul(hn::Mul(half, m2), m2);
  }

  /// @return lanes in which the residues are accurate
  LaneMask form_curve(const DesignCurve& curve, SquaredResponse<Poles::most>& f) {
    const int count = 2 * n_;
    PackList<ModalTerm<Size>> rows(curve.rows.size());
    for (std::size_t t = 0; t < rows.size(); ++t) in_modes_of_term(n_, modes_, curve.rows[t], first_, rows[t]);
    const DrivenLoad<Size>& load = loads_[curve.load];
    // ρ_p = −i (Σ rows λ_pᵃ rowᵀv_p)(Σ values λ_pᵇ v_pᵀvalue)/slope_p, slope_p = v_pᵀ Z'(λ_p) v_p
    const Polynomial c = constants_of(curve, rows);
    PairPack r[Poles::most];
    Pack weight[Poles::most];
    for (int p = 0; p < count; ++p) {
      const ComplexPack residue = sum_at_root(n_, *poles_, p, rows) * load.participation[p];
      r[p] = {residue.im, hn::Neg(residue.re)};
      weight[p] = weight_of(rows, p);
    }
    const Pack constants = hn::Add(one_norm(c.of[0].value), hn::Add(one_norm(c.of[1].value), one_norm(c.of[2].value)));
    const LaneMask still = hn::Eq(constants, hn::Zero(Lanes()));
    LaneMask known = drop_round_off(Poles{count}, still, load.visible, load.possible, weight, r);
    if (!c.grows) known = hn::Or(known, hidden_by(c.of[0].value, load, weight));
    form_fractions(r, c, f);
    return hn::And(known, sees_every_root(rows, load));
  }

  Size n_;
  const DrivenDesigns& designs_;
  Eigen::Index first_;
  PackOfModes<Size> modes_;
  std::unique_ptr<DrivenPoles<Size>> poles_;
  std::unique_ptr<LossyModalPack<Size>> modal_;
  std::unique_ptr<Inverses> inverses_;
  PackList<DrivenLoad<Size>> loads_;
};

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
