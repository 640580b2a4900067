// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/project/elements/element_table_readers.h"

namespace trivet::project {
namespace {

/// A factor in `material`, 1 by default. Reading the material has reported what is wrong with it.
double factor_of_rubber(TableReader& reader, const std::string& key) {
  const Node* material = reader.has("material") ? reader.node("material") : nullptr;
  if (!material || !material->find(key)) return 1;
  foundation::Problems reported_with_the_material;
  return TableReader(*material, "", reported_with_the_material).number(key, Quantity::pure).value_or(1);
}

std::string stiffening_words(double stiffening) {
  return fmt::format("in vibration {:.4g} times as stiff as at rest; the 12×12 is that of vibration", stiffening);
}

}  // namespace

void stiffen(double stiffening, model::Element& element) {
  if (stiffening == 1) return;
  element.law.nominal_stiffness *= stiffening;
  element.stiffening = stiffening;
  element.facts.push_back({"stiffening", stiffening_words(stiffening)});
}

double stiffening_of(TableReader& reader) {
  const auto stiffening = reader.number("stiffening", Quantity::pure);
  constexpr double largest = 10;  // rubber reaches 3
  if (!stiffening || (*stiffening >= 1 && *stiffening <= largest)) return stiffening.value_or(1);
  reader.error("stiffening", fmt::format("{:.6g}", *stiffening),
               fmt::format("stiffness in vibration over static stiffness is 1 … {:.0f}", largest),
               "rubber is 1.1 to 3 times stiffer in vibration; write \"140 %\" if percent are meant");
  return 1;
}

void check_stiffening(TableReader& reader, const model::Element& element) {
  if (element.stiffening == 1 || !(element.rating || reader.has("stiffening"))) return;
  if (std::holds_alternative<elements::Viscoelastic>(element.law.damping))
    reader.error("damping", "stiffening with a damping law that relaxes",
                 "such a law states the stiffness over frequency itself", "remove one of them");
  if (model::has_laws(element))
    reader.error("laws", fmt::format("laws with a stiffening of {:.6g}", element.stiffening),
                 "one force is that of rest and of vibration", "remove stiffening");
}

ElementLength stiffened(TableReader& reader, ElementLength length, model::Element& element) {
  const double stiffening = factor_of_rubber(reader, "stiffening");
  if (!length || stiffening == 1) return length;
  if (element.over_deflection) {
    reader.error("nonlinear", fmt::format("nonlinear = true with a stiffening of {:.6g}", stiffening),
                 "one force is that of rest and of vibration", "give the material of vibration without stiffening");
    return std::nullopt;
  }
  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions({0, 0, *length}, Eigen::Matrix3d::Identity());
  const elements::Matrix6 metric = rigid.transpose() * rigid;
  const elements::Matrix12 deformation =
      elements::Matrix12::Identity() - rigid * numerics::inverse(metric) * rigid.transpose();
  const elements::Matrix12 at_rest = element.law.nominal_stiffness;
  element.law.nominal_stiffness += (stiffening - 1) * deformation.transpose() * at_rest * deformation;
  if (element.evidence) element.evidence->uncertainty *= stiffening;
  element.stiffening = stiffening;
  element.facts.push_back({"stiffening", stiffening_words(stiffening)});
  return length;
}

void read_creep_of_rubber(TableReader& reader, model::Element& element) {
  element.creep = factor_of_rubber(reader, "creep");
  if (element.creep > 1)
    element.facts.push_back({"creep", fmt::format("{:.4g} times the static deflection after years", element.creep)});
}

}  // namespace trivet::project
