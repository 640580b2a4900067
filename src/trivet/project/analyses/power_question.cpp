// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/question_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// Mean power into the ground at each mount.
std::unique_ptr<Question> read_power(TableReader& reader, const ResultNames&, const NamesInFile& in_file) {
  auto asked = std::make_unique<BandQuestion>();
  asked->selection.excitations = read_selected(reader, in_file.harmonic_excitations, "harmonic");
  asked->band = read_band(reader, "band");
  return asked;
}

}  // namespace

const QuestionReader power_question = {
    .drive = Drive::harmonic, .read = read_power, .searches_peaks = true, .keys = R"json({"properties": {
   "excitations": {"$ref": "#/$defs/selected_excitations"},
   "band": {"$ref": "#/$defs/band"}}})json"};

}  // namespace trivet::project
