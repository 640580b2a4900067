// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/power.h"
#include "trivet/study/analyses/question_answer.h"

namespace trivet::study {
namespace {

response::PowerFlow answer_power(const CaseContext& c, const project::BandQuestion& asked, foundation::Problems&) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, asked.selection.excitations);
  if (loading.vanishes()) throw without_excitation("power");
  const std::vector<assembly::Channel> channels =
      assembly::channels(c.system, c.assembled, {"coordinates"}, assembly::MotionQuantity::velocity);
  const assembly::Band band = asked.band ? *asked.band : default_band(c);
  // They only choose the frequencies.
  const response::Peaks peaks = response::peaks(c.assembled, channels, loading, c.modes, c.roots(),
                                                {.search_to = band.to, .refine = false}, c.progress);
  std::vector<double> grid = grid_over(c, channels, loading, peaks, band);
  // At ω = 0 nothing moves; at an undamped resonance there is no steady power.
  const response::FrequencyResponse defined = response::frequency_response(c.assembled, channels, loading, grid);
  std::erase_if(grid, [&](double w) {
    return w == 0 || std::ranges::find(defined.check.undefined_at, w) != defined.check.undefined_at.end();
  });
  return response::power_flow(c.system, c.assembled, loading, grid, c.progress);
}

}  // namespace

const QuestionAnswer power_answer = answered_by<answer_power>("mean power into the ground at each mount");

}  // namespace trivet::study
