// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/first_page.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "trivet/documents/document.h"
#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/machine_drawing.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/page/result_sections.h"
#include "trivet/results/analyses/operation_words.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/written_results.h"
#include "trivet/results/model/mounts_document.h"

namespace trivet::report {
namespace {

bool is_folded(const Part& part) {
  const auto* table = std::get_if<Table>(&part.content);
  return table && table->folded;
}

/// A document without the sentences that are on the first page.
Document without_sentences(Document document) {
  std::erase_if(document.parts, [](const Part& part) {
    const auto* sentence = std::get_if<Sentence>(&part.content);
    return sentence && sentence->place == Sentence::Place::text;
  });
  return document;
}

/// Parts that would open by a click are open.
std::string opened(std::string html) {
  const std::string closed = "<details>", open = "<details open>";
  for (std::size_t at = html.find(closed); at != std::string::npos; at = html.find(closed, at + open.size()))
    html.replace(at, closed.size(), open);
  return html;
}

}  // namespace

std::string speeds_part(const std::vector<ShownCase>& cases) {
  Document document;
  for (const ShownCase& shown : cases) {
    if (!shown.results.operation) continue;
    for (const study::OperatingSpeed& at : shown.results.operation->speeds) {
      Sentence sentence = results::operation_sentence(at);
      if (cases.size() > 1) sentence.parts.insert(sentence.parts.begin(), shown.name() + ". ");
      document.add(std::move(sentence));
    }
  }
  return cases.empty() ? "" : section("speeds", "Operating speeds", as_html(document, cases.front().variant.display));
}

std::string drawing_part(const project::Case& machine, const std::string& label) {
  return "<figure class=\"drawing\"><div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" + label + "\">" +
      machine_drawing(machine) + "</div><div class=\"narrow\">" + narrow_machine_drawing(machine) + "</div></figure>\n";
}

std::string machine_part(const project::Project& project) {
  const project::Case& base = project.base();
  return section("machine", "Machine and mounts" + std::string(project.cases.size() > 1 ? " of the base model" : ""),
                 drawing_part(base, "Drawing of the machine") + as_html(results::mounts_document(base), base.display));
}

std::string overview_part(const std::string& picture, bool is_short) {
  return "<figure id=\"overview\">\n<div class=\"scroll\" tabindex=\"0\" role=\"group\" "
         "aria-label=\"Overview picture\">" +
      picture + "</div>\n<figcaption>Amplitude characteristics (the first group of curves), all on one scale." +
      (is_short ? "" : "<span class=\"on-screen\"> Interactive charts of the selected case follow below.</span>") +
      "</figcaption>\n</figure>\n";
}

namespace {

std::string mode_pictures(const ShownCase& shown) {
  const std::vector<Figure> figures = mode_figures(shown.variant, shown.results);
  if (figures.empty()) return "";
  const std::string which = figures.size() < shown.results.modes.list.size()
      ? fmt::format(" Drawn: the lowest {} above 0.", count_words(figures.size(), "mode"))
      : "";
  return figures_html(figures) + hint("Grey: at rest. Blue: displaced, enlarged; the sign is arbitrary." + which);
}

}  // namespace

std::string modes_part(const ShownCase& shown, const std::string& title, bool folded) {
  if (!shown.variant.analyses.modes) return "";
  const project::DisplayUnits& display = shown.variant.display;
  Document first = results::result_document("modes", shown.variant, shown.results), last = first;
  std::erase_if(first.parts, is_folded);
  std::erase_if(last.parts, [](const Part& part) { return !is_folded(part); });
  return section("modes", title,
                 as_html(first, display) + mode_pictures(shown) + (folded ? as_html(last, display) : ""));
}

std::string short_results(const std::vector<ShownCase>& cases) {
  if (cases.empty()) return "";
  const ShownCase& base = cases.front();
  const auto document = [&](const char* result) {
    return results::result_document(result, base.variant, base.results);
  };
  const auto html = [&](const Document& shown) { return as_html(shown, base.variant.display); };
  const std::string of_base = cases.size() > 1 ? " of the base model" : "";
  const std::string speeds = base.results.operation ? html(without_sentences(document("operation"))) : "";
  const std::string best = base.results.optimization ? html(results::optimum_in_short(*base.results.optimization)) +
          figures_html(best_design_figures(base.variant, base.results))
                                                     : "";
  return section("answer", "Best design", best) + modes_part(base, "Undamped modes" + of_base, false) +
      section("answer", "Operating shapes" + of_base, figures_html(shape_figures(base.variant, base.results))) +
      section("answer", "At the operating speed" + std::string(of_base.empty() ? "" : ", base model"), opened(speeds));
}

}  // namespace trivet::report
