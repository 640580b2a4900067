// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// Shock response spectra.
namespace trivet::results {
namespace {

using excitation::ShockResponse;
using study::ShockSpectrumResult;
using Spectra = std::vector<ShockSpectrumResult>;

/// A number of a response, described for the rows of a spectrum and for the lists of all spectra.
struct ShockNumber {
  const char *name, *unit, *heading;
  std::function<double(const ShockResponse&)> value;
};

const std::vector<ShockNumber>& shock_numbers() {
  static const std::vector<ShockNumber> list = {
      {"largest", "m/s²", "largest", &ShockResponse::largest},
      {"smallest", "m/s²", "smallest", &ShockResponse::smallest},
      {"maximax", "m/s²", "", &ShockResponse::maximax},
      {"primary", "m/s²", "", &ShockResponse::primary},
      {"residual", "m/s²", "", &ShockResponse::residual},
      {"relative_displacement", "m", "relative displacement", &ShockResponse::relative_displacement},
      {"pseudo_velocity", "m/s", "pseudo-velocity", &ShockResponse::pseudo_velocity}};
  return list;
}

Table spectrum_rows(const std::vector<ShockResponse>& spectrum) {
  const Rows row(spectrum);
  Table table{
      .key = "rows",
      .rows = row.size(),
      .columns = {row("angular_frequency", Kind::frequency, "natural frequency", &ShockResponse::angular_frequency)}};
  for (const ShockNumber& one : shock_numbers())
    table.columns.push_back(row(one.name, Kind::number, one.heading, one.value, {.unit = one.unit}));
  return table;
}

/// A spectrum for the screen: some of its rows.
Table shown_spectrum(const ShockSpectrumResult& spectrum) {
  constexpr std::size_t most_rows = 24;
  Table table = spectrum_rows(spectrum.spectrum);
  table.key.clear();
  table.title = fmt::format("Shock response spectrum of {}, damping ratio {:.4g} (absolute acceleration)",
                            spectrum.excitation, spectrum.damping_ratio);
  table.people_rows.emplace();
  const std::size_t step = (table.rows + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < table.rows; i += step) table.people_rows->push_back(i);
  table.forms = on_screen | in_summary;
  return table;
}

/// One row per spectrum: its rows in JSON, lists of numbers as arrays, its extremes on the page.
Table spectrum_table(const Spectra& spectra) {
  const Rows row(spectra);
  Table table{
      .key = "spectra",
      .axis = spectra.empty() ? "" : "excitation",
      .plain_names = true,
      .rows = row.size(),
      .columns = {row("excitation", Kind::words, "excitation", &ShockSpectrumResult::excitation),
                  row("unit", Kind::words, "", &ShockSpectrumResult::unit, {.forms = in_json | for_people}),
                  row("damping_ratio", Kind::number, "damping ratio", &ShockSpectrumResult::damping_ratio),
                  row("rows", Kind::words, "",
                      [](const ShockSpectrumResult& s) { return as_json({{{spectrum_rows(s.spectrum)}}}).at("rows"); },
                      {.forms = in_json})},
      .forms = for_programs | on_page};
  for (const ShockNumber& one : shock_numbers())
    table.columns.push_back(row.lists(one.name, "", "angular_frequency", {},
                                      [&one](const ShockSpectrumResult& s) {
                                        std::vector<double> numbers;
                                        for (const ShockResponse& r : s.spectrum) numbers.push_back(one.value(r));
                                        return numbers;
                                      },
                                      {.unit = one.unit, .forms = in_arrays}));
  const auto add_extreme = [&](const char* heading, const char* unit, double (*size)(const ShockResponse&),
                               double sign) {
    const auto most = [size](const ShockSpectrumResult& s) -> const ShockResponse* {
      const auto found = std::ranges::max_element(s.spectrum, {}, size);
      return found == s.spectrum.end() ? nullptr : &*found;
    };
    using Found = std::optional<double>;
    table.columns.push_back(row(heading, Kind::quantity, heading,
                                [most, size, sign](const ShockSpectrumResult& s) {
                                  const ShockResponse* one = most(s);
                                  return one ? Found(sign * size(*one)) : Found();
                                },
                                {.unit = unit, .forms = on_page}));
    table.columns.push_back(row(std::string(heading) + " at", Kind::frequency, "at",
                                [most](const ShockSpectrumResult& s) {
                                  const ShockResponse* one = most(s);
                                  return one ? Found(one->angular_frequency) : Found();
                                },
                                {.forms = on_page}));
  };
  add_extreme("positive maximax", unit_of_the_row, [](const ShockResponse& r) { return r.largest(); }, 1);
  add_extreme("negative maximax", unit_of_the_row, [](const ShockResponse& r) { return -r.smallest(); }, -1);
  add_extreme("largest pseudo-velocity", "m/s", [](const ShockResponse& r) { return r.pseudo_velocity(); }, 1);
  add_extreme("largest relative displacement", "m", [](const ShockResponse& r) { return r.relative_displacement; }, 1);
  return table;
}

/// All rows of all spectra, for CSV.
struct NamedResponse {
  std::string excitation;
  ShockResponse response;
};

Table all_spectrum_rows(const Spectra& spectra) {
  std::vector<NamedResponse> all;
  for (const ShockSpectrumResult& s : spectra)
    for (const ShockResponse& r : s.spectrum) all.push_back({s.excitation, r});
  const Rows row(std::move(all));
  Table table{.file = "shock_spectrum.csv",
              .rows = row.size(),
              .columns = {row("excitation", Kind::words, "", &NamedResponse::excitation),
                          row("angular_frequency", Kind::frequency, "",
                              [](const NamedResponse& n) { return n.response.angular_frequency; })},
              .csv = {"excitation",
                      {"natural frequency [Hz]", "angular_frequency [Hz]"},
                      {"largest [m/s²]", "largest"},
                      {"smallest [m/s²]", "smallest"},
                      {"maximax [m/s²]", "maximax"},
                      {"pseudo velocity [m/s]", "pseudo_velocity"},
                      {"relative displacement [m]", "relative_displacement"}},
              .forms = in_csv};
  for (const ShockNumber& one : shock_numbers())
    table.columns.push_back(
        row(one.name, Kind::number, "", [&one](const NamedResponse& n) { return one.value(n.response); }));
  return table;
}

Document shock_spectrum_document(const project::Case&, const study::CaseResults& results) {
  const Spectra& spectra = *results.shock_spectrum;
  Document document;
  if (!spectra.empty())
    document.add(Curves{.axis = "angular_frequency",
                        .unit = "rad/s",
                        .points = {spectra.front().spectrum, &ShockResponse::angular_frequency},
                        .forms = in_arrays});
  for (const ShockSpectrumResult& spectrum : spectra) document.add(shown_spectrum(spectrum));
  document.add(spectrum_table(spectra));
  document.add(all_spectrum_rows(spectra));
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter shock_spectrum_results = {.document = shock_spectrum_document, .files = {"shock_spectrum.csv"}};

}  // namespace trivet::results
