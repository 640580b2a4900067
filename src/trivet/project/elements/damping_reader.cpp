// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>

#include "trivet/project/elements/element_table_readers.h"

namespace trivet::project {
namespace {

using elements::Viscoelastic;

constexpr const char* rule =
    "damping is one of {proportional}, {loss_factor}, {matrix}, {translation, rotation}, {kelvin_voigt}, {zener}, "
    "{maxwell}, {fractional_zener}, {loops}";

/// The laws in the table, each once; `translation` and `rotation` count as one.
std::vector<std::string> laws_given(TableReader& damping) {
  std::vector<std::string> laws;
  for (const char* key :
       {"proportional", "loss_factor", "matrix", "kelvin_voigt", "zener", "maxwell", "fractional_zener", "loops"})
    if (damping.has(key)) laws.push_back(key);
  if (damping.has("translation") || damping.has("rotation"))
    laws.push_back(damping.has("translation") ? "translation" : "rotation");
  return laws;
}

void report_several(TableReader& reader, const Node& table, const std::vector<std::string>& laws) {
  std::string given;
  const Node* latest = &table;
  for (const std::string& law : laws) {
    given += (given.empty() ? "" : " and ") + law;
    if (table.find(law)->origin.line > latest->origin.line) latest = table.find(law);
  }
  reader.error("damping", given, rule, "keep one of them").origin = latest->origin;
}

/// {zener = {ratio = 0.8, time = "2 ms"}} and similar laws.
std::optional<Viscoelastic> read_viscoelastic(TableReader& damping) {
  std::optional<Viscoelastic> law;
  for (const char* key : {"kelvin_voigt", "zener", "maxwell", "fractional_zener"}) {
    const Node* table = damping.table(key);
    if (!table) continue;
    const std::string name = key;
    const std::size_t before = damping.errors();
    TableReader reader(*table, damping.path() + "." + name, damping.problems());
    if (name == "kelvin_voigt") law = elements::KelvinVoigt{reader.required_number("time", Quantity::time)};
    if (name == "zener")
      law = elements::Zener{reader.required_number("ratio", Quantity::pure),
                            reader.required_number("time", Quantity::time)};
    if (name == "fractional_zener")
      law = elements::FractionalZener{reader.required_number("ratio", Quantity::pure),
                                      reader.required_number("time", Quantity::time),
                                      reader.required_number("order", Quantity::pure)};
    if (name == "maxwell") {
      for (const char* list : {"ratios", "times"})
        if (!reader.has(list))
          reader.missing(list, "give one number per branch: ratios = [0.4, 0.2], times = [0.001, 0.01]");
      law = elements::GeneralizedMaxwell{reader.numbers("ratios", Quantity::pure).value_or(std::vector<double>{}),
                                         reader.numbers("times", Quantity::time).value_or(std::vector<double>{})};
    }
    const bool lists_read = name != "maxwell" || damping.errors() == before;
    reader.finish();
    if (lists_read) reader.add(elements::check(*law));
  }
  return law;
}

}  // namespace

Quantity matrix_entry(bool damping, int i, int j) {
  const bool moment = i % 6 >= 3, angle = j % 6 >= 3;
  if (damping) {
    if (moment) return angle ? Quantity::damping_moment_per_angle : Quantity::damping_moment_per_length;
    return angle ? Quantity::damping_force_per_angle : Quantity::damping_force_per_length;
  }
  if (moment) return angle ? Quantity::moment_per_angle : Quantity::moment_per_length;
  return angle ? Quantity::force_per_angle : Quantity::force_per_length;
}

/// Reports negative constants, also beside one that cannot be read.
void refuse_negative(TableReader& reader, const std::string& key, Quantity quantity) {
  const Node* list = reader.node(key);
  if (!list || list->kind != Node::Kind::array) return;
  for (const Node& item : list->items) {
    const bool is_bare = item.kind == Node::Kind::integer || item.kind == Node::Kind::real;
    const double value = is_bare        ? item.number
        : item.kind == Node::Kind::text ? to_si(item.text, quantity).value_or(0)
                                        : 0;
    if (value < 0)
      reader.error(key, is_bare ? fmt::format("{:.6g}", value) : value_text(item), "each constant must be ≥ 0",
                   "a negative one would be a source of energy");
  }
}

elements::Vector6 read_constants(TableReader& reader, Quantity translation, Quantity rotation, bool with_rotation) {
  elements::Vector6 k = elements::Vector6::Zero();
  if (!reader.has("translation"))
    reader.missing(
        "translation",
        fmt::format("give three constants in {} along the local axes: translation = [x, y, z]", si_unit(translation)));
  if (const auto t = reader.vector("translation", translation)) k.head<3>() = *t;
  if (with_rotation)
    if (const auto r = reader.vector("rotation", rotation)) k.tail<3>() = *r;
  refuse_negative(reader, "translation", translation);
  if (with_rotation) refuse_negative(reader, "rotation", rotation);
  return k;
}

elements::Matrix12 full_matrix(const Eigen::MatrixXd& given, const model::Span& span) {
  if (given.rows() == 12) return given;
  return elements::in_end_axes(elements::from_moved_end(given, span.arm), span.n_from_k);
}

void read_damping(TableReader& reader, const model::Span& span, double centre, model::Element& element) {
  const Node* table = reader.table("damping");
  if (!table) return;
  const std::size_t before = reader.errors();
  TableReader damping(*table, reader.path() + ".damping", reader.problems());
  const std::vector<std::string> laws = laws_given(damping);
  if (laws.size() > 1) report_several(reader, *table, laws);
  if (const auto factor = damping.number("proportional", Quantity::time)) {
    const auto of = damping.choice("of", {"scaled", "nominal"});
    element.law.damping = elements::ProportionalDamping{*factor, of == "nominal"};
  }
  if (const auto loss = damping.number("loss_factor", Quantity::pure))
    element.law.damping = elements::LossFactor{*loss};
  if (const auto matrix = damping.matrix("matrix", [](int, int i, int j) { return matrix_entry(true, i, j); }, {6, 12}))
    element.law.damping = elements::DampingMatrix{full_matrix(*matrix, span)};
  if (damping.has("translation") || damping.has("rotation")) {
    const elements::Vector6 c =
        read_constants(damping, Quantity::damping_force_per_length, Quantity::damping_moment_per_angle, true);
    element.law.damping = elements::DampingMatrix{
        elements::in_end_axes(elements::constants_at_point(c, span.arm, centre), span.n_from_k)};
  }
  if (const auto law = read_viscoelastic(damping)) element.law.damping = *law;
  if (damping.has("loops")) read_loops(damping, element);
  for (const char* key : {"of", "translation", "rotation"}) {
    const bool misplaced = std::string(key) == "of" && damping.has("of") && !damping.has("proportional");
    if (misplaced)
      damping.error("of", "of without proportional", "it selects the stiffness of a proportional damping", "remove it");
    static_cast<void>(damping.node(key));
  }
  damping.finish();
  if (laws.empty() && reader.errors() == before) reader.error("damping", "no law", rule, "give one of them");
}

}  // namespace trivet::project
