// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "trivet/modal/foundation_feet.h"
#include "trivet/results/format/result_writer.h"

/// Damped roots.
namespace trivet::results {
namespace {

using modal::Root;

/// Rows for people: of two conjugate roots the one with the positive imaginary part.
std::vector<std::size_t> without_conjugates(const std::vector<Root>& list) {
  constexpr double same = 1e-9;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::complex<double> one = list[i].eigenvalue;
    const auto is_conjugate = [&](const Root& other) {
      return std::abs(other.eigenvalue - std::conj(one)) < same * std::abs(one);
    };
    if (one.imag() >= 0 || std::ranges::none_of(list, is_conjugate)) rows.push_back(i);
  }
  return rows;
}

std::string kind_words(const Root& root) {
  const std::string words = root.kind == modal::RootKind::growing ? "▲ GROWING" : modal::name(root.kind);
  return words + (root.exact ? "" : " (approximate)");
}

Table root_table(const project::Case& variant, const std::vector<Root>& list) {
  const Rows row(list);
  Table table{
      .key = "roots",
      .axis = "root",
      .plain_names = true,
      .file = "roots.csv",
      .title = "Damped roots λ, motion ~ exp(λt); of two conjugate roots the one with Im λ > 0",
      .rows = row.size(),
      .columns = {row("eigenvalue", Kind::number, "", &Root::eigenvalue, {.unit = "1/s", .forms = in_json | in_arrays}),
                  row("real", Kind::number, "Re λ", [](const Root& root) { return root.eigenvalue.real(); },
                      {.unit = "1/s", .digits = 7, .forms = in_csv | for_people}),
                  row("imaginary", Kind::frequency, "Im λ", [](const Root& root) { return root.eigenvalue.imag(); },
                      {.digits = 7, .forms = in_csv | for_people}),
                  row("kind", Kind::words, "", [](const Root& root) { return modal::name(root.kind); }),
                  row("kind_words", Kind::words, "kind", kind_words, {.forms = for_people}),
                  row("angular_frequency", Kind::frequency, "|λ|", &Root::angular_frequency, {.digits = 7}),
                  row("damped_angular_frequency", Kind::frequency, "damped", &Root::damped_angular_frequency,
                      {.digits = 7, .forms = in_json | in_arrays | on_page}),
                  row("damping_ratio", Kind::number, "damping ratio", &Root::damping_ratio),
                  row("exact", Kind::yes_no, "", &Root::exact),
                  row.lists("shape", "", "coordinate", shape_coordinates(variant), &Root::shape,
                            {.unit = unit_of_the_row}),
                  row("nearest_mode", Kind::number, "nearest mode", &Root::nearest_mode)},
      .csv = {{"real [1/s]", "real"},
              {"imaginary [rad/s]", "imaginary"},
              "kind",
              "angular_frequency [rad/s]",
              "damping_ratio",
              "nearest_mode"},
      .people_rows = without_conjugates(list),
      .mark = [&list](std::size_t i) { return list[i].kind == modal::RootKind::growing ? Mark::bad : Mark::plain; }};
  if (!modal::elements_on_foundations(variant.system).empty())
    table.columns.push_back(row("feet", Kind::words, "",
                                [](const Root& root) { return json::rows(root.feet.transpose().eval()); },
                                {.forms = in_json}));
  return table;
}

Document roots_document(const project::Case& variant, const study::CaseResults& results) {
  Document document;
  document.add(Words{.key = "bodies", .list = names_of(variant.system.bodies())});
  add_feet(variant, document);
  document.add(root_table(variant, results.roots.list));
  add_shape_coordinates(variant, {"1", "rad/m"}, document);
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter roots_results = {
    .has_result = [](const project::Case& variant, const study::CaseResults&) { return variant.analyses.roots; },
    .document = roots_document,
    .files = {"roots.csv"}};

}  // namespace trivet::results
