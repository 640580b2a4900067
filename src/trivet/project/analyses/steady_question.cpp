// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/steady_question.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/nonlinear/deflections.h"
#include "trivet/project/analyses/question_reader.h"
#include "trivet/project/text/band_reader.h"

namespace trivet::project {
namespace {

constexpr int most_harmonics = 200;

std::unique_ptr<Question> read_steady(TableReader& reader, const ResultNames& names, const NamesInFile& in_file) {
  auto asked = std::make_unique<SteadyQuestion>();
  read_selection(reader, names, in_file.harmonic_excitations, "harmonic", asked->selection);
  asked->band = read_band(reader, "band");
  if (asked->band && !(asked->band->from > 0))
    reader.error("band", "a band from 0", "the motions are followed over a frequency above 0",
                 "begin at a low frequency, such as a tenth of the first natural one");
  if (const auto harmonics = reader.number("harmonics", Quantity::pure)) {
    if (*harmonics >= 1 && *harmonics <= most_harmonics && *harmonics == std::floor(*harmonics))
      asked->harmonics = static_cast<int>(*harmonics);
    else
      reader.error("harmonics", fmt::format("{:.6g}", *harmonics),
                   fmt::format("a whole number from 1 to {} is expected", most_harmonics),
                   "remove it: their number is found by `tolerance`");
  }
  if (const auto tolerance = reader.number("tolerance", Quantity::pure)) {
    if (*tolerance > 0 && *tolerance < 1) asked->tolerance = *tolerance;
    else
      reader.error("tolerance", fmt::format("{:.6g}", *tolerance), "it is a share between 0 and 1",
                   "for instance tolerance = 1e-3");
    if (reader.has("harmonics"))
      reader.error("tolerance", "harmonics and tolerance", "a given number of harmonics is not searched",
                   "remove one of them");
  }
  return asked;
}

void check_nonlinear(const Question&, const model::System& system, foundation::Problems& problems) {
  if (!nonlinear::is_nonlinear(system))
    problems.error("analyses.steady", "a linear machine", "steady motions are those of machines with nonlinear parts",
                   "take response, or give an element laws or a stop (docs/nonlinear.md)");
}

}  // namespace

const QuestionReader steady_question = {
    .drive = Drive::harmonic, .read = read_steady, .check = check_nonlinear, .keys = R"json({"properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "band": {"$ref": "#/$defs/band"},
   "harmonics": {"type": "integer", "minimum": 1, "maximum": 200, "description": "number of harmonics (default: as many as tolerance needs)"},
   "tolerance": {"$ref": "#/$defs/number", "description": "share of the deflections beyond the last harmonic, 0 to 1 (default: 1e-3)"}}})json"};

}  // namespace trivet::project
