// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/verdict_words.h"

namespace trivet::results {
namespace {

using study::Optimization;

/// The given design and the optimum beside each other.
struct Compared {
  std::string words;
  Json given, optimum;
  std::string verdict = {};
  Mark mark = Mark::plain;
};

Table compared(const std::string& heading, Kind kind, const std::vector<Compared>& list) {
  const Rows row{std::vector<Compared>(list)};
  const bool judged = std::ranges::any_of(list, [](const Compared& one) { return !one.verdict.empty(); });
  return {.rows = row.size(),
          .columns = {row("words", Kind::words, heading, &Compared::words),
                      row("given", kind, judged ? "given: margin" : "given", &Compared::given),
                      row("optimum", kind, judged ? "optimum: margin" : "optimum", &Compared::optimum),
                      row("verdict", Kind::words, judged ? "verdict" : "", &Compared::verdict)},
          .mark = [list](std::size_t i) { return list[i].mark; },
          .forms = for_people};
}

/// The words of a requirement; those of both designs if they differ, as load ranges of other mounts do.
std::string words_of_both(const study::RequirementResult& given, const study::RequirementResult& best,
                          const project::DisplayUnits& display) {
  const std::string words = best.words_for_people(display);
  return given.words == best.words ? words : fmt::format("{} (given: {})", words, given.words_for_people(display));
}

/// The requirements of each case by ascending margin.
std::vector<Compared> compared_requirements(const Optimization& found) {
  using study::RequirementResult;
  std::vector<Compared> list;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const std::vector<RequirementResult>&before = found.before[c].results, &after = found.after[c].results;
    std::vector<std::size_t> order(after.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return after[i].margin; });
    const auto margin = [](const RequirementResult& r) { return r.value ? Json(r.margin) : Json("not judged"); };
    for (const std::size_t i : order)
      list.push_back({words_in_case(found, c, words_of_both(before[i], after[i], found.after[c].display)),
                      margin(before[i]), margin(after[i]), verdict_word(after[i]),
                      !after[i].value      ? Mark::doubt
                          : after[i].met() ? Mark::plain
                                           : Mark::bad});
  }
  return list;
}

constexpr std::size_t most_compared = 12;  // in each case

std::vector<Compared> compared_frequencies(const Optimization& found) {
  std::vector<Compared> list;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const std::vector<double>&given = found.summaries_before[c].angular_frequencies,
          &best = found.summaries_after[c].angular_frequencies;
    const auto at = [](const std::vector<double>& values, std::size_t i) {
      return i < values.size() ? Json(values[i]) : Json();
    };
    for (std::size_t i = 0; i < std::min(std::max(given.size(), best.size()), most_compared); ++i)
      list.push_back({words_in_case(found, c, fmt::format("mode {}", i + 1)), at(given, i), at(best, i)});
  }
  return list;
}

std::vector<Compared> compared_decoupling(const Optimization& found) {
  std::vector<Compared> list;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const auto &before = found.summaries_before[c].decoupling, &after = found.summaries_after[c].decoupling;
    for (std::size_t b = 0; b < std::min(after.size(), most_compared); ++b) {
      const auto same = std::ranges::find(before, after[b].body, &study::BodyDecoupling::body);
      list.push_back({words_in_case(found, c, after[b].body),
                      same == before.end() ? Json("not known") : Json(same->least), after[b].least});
    }
  }
  return list;
}

}  // namespace

void add_comparison(const Optimization& found, Document& document) {
  document.add(compared("requirement", Kind::number, compared_requirements(found)));
  document.add(compared("natural frequency", Kind::frequency, compared_frequencies(found)));
  document.add(compared("decoupling, least of its modes", Kind::share, compared_decoupling(found)));
}

}  // namespace trivet::results
