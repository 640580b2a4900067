// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/analysis_types.h"

#include "trivet/project/analyses/question_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

std::unique_ptr<Question> read_orders_question(TableReader& reader, const ResultNames& names,
                                               const NamesInFile& in_file) {
  auto asked = std::make_unique<OrdersQuestion>();
  read_selection(reader, names, in_file.order_excitations, "order", asked->selection);
  if (!reader.has("speed"))
    reader.missing("speed", "give the range of shaft speeds: speed = [\"600 rpm\", \"3000 rpm\"]");
  asked->speed = read_band(reader, "speed").value_or(assembly::Band{0, 1});
  return asked;
}

}  // namespace

const QuestionReader orders_question = {
    .drive = Drive::orders, .read = read_orders_question, .searches_peaks = true, .keys = R"json({"properties": {
   "of": {"$ref": "#/$defs/answers_of"},
   "quantity": {"$ref": "#/$defs/quantity"},
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "speed": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2,
     "description": "shaft speeds, rad/s or with a unit"}},
  "required": ["speed"]})json"};

}  // namespace trivet::project
