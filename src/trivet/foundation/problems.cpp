// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/problems.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"

namespace trivet::foundation {
namespace {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string place(const Origin& origin) {
  const bool has_lines = !origin.source.starts_with(setting_source);  // a setting is one line
  return has_lines && origin.line > 0 && !origin.source.empty() ? origin.source + ":" + std::to_string(origin.line)
                                                                : origin.source;
}

Problem with_word_of_settings(Problem problem, std::string_view word) {
  for (std::string* text : {&problem.origin.source, &problem.subject}) {
    if (!text->starts_with(setting_source)) continue;
    text->replace(0, setting_source.size(), word);
    if (text == &problem.origin.source) problem.origin.line = problem.origin.column = 0;  // a setting is one line
  }
  return problem;
}

std::string message(const Problem& problem) {
  std::string text;
  if (!problem.origin.source.empty()) text += place(problem.origin) + ": ";
  text += problem.severity == Severity::error ? "error: " : "warning: ";
  text += problem.subject;
  if (!problem.finding.empty()) text += (problem.subject.empty() ? "" : ": ") + problem.finding;
  if (!problem.rule.empty()) text += "; " + problem.rule;
  if (!problem.remedy.empty()) text += "; " + problem.remedy;
  return on_one_line(text);
}

Problem& Problems::error(std::string subject, std::string finding, std::string rule, std::string remedy) {
  return list_.emplace_back(
      Problem{Severity::error, {}, std::move(subject), std::move(finding), std::move(rule), std::move(remedy)});
}

Problem& Problems::warning(std::string subject, std::string finding, std::string rule, std::string remedy) {
  return list_.emplace_back(
      Problem{Severity::warning, {}, std::move(subject), std::move(finding), std::move(rule), std::move(remedy)});
}

void Problems::add(const Problems& others) { list_.insert(list_.end(), others.list_.begin(), others.list_.end()); }

std::size_t Problems::errors() const { return to_size(std::ranges::count(list_, Severity::error, &Problem::severity)); }

void Problems::sort_by_origin() {
  const auto line = [](const Problem& p) {
    return p.origin.line > 0 ? p.origin.line : std::numeric_limits<int>::max();
  };
  // Files in the order in which they first occur: the project file, then its data.
  std::vector<std::string> files;
  for (const Problem& p : list_)
    if (std::ranges::find(files, p.origin.source) == files.end()) files.push_back(p.origin.source);
  const auto file = [&](const Problem& p) {
    return p.origin.line > 0 ? std::ranges::find(files, p.origin.source) - files.begin() : std::ptrdiff_t{0};
  };
  std::ranges::stable_sort(list_, [&](const Problem& a, const Problem& b) {
    return std::make_pair(file(a), line(a)) < std::make_pair(file(b), line(b));
  });
  std::set<std::tuple<Severity, std::string, std::string, std::string>> seen;
  std::erase_if(list_,
                [&](const Problem& p) { return !seen.emplace(p.severity, p.subject, p.finding, p.rule).second; });
}

tl::unexpected<Problems> failure(Problem problem) {
  Problems problems;
  problems.add(std::move(problem));
  return tl::unexpected<Problems>(std::move(problems));
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_compared = 64;  // a longer key is not a typing error
  constexpr std::size_t most_compared = 2000;   // with more names, a suggestion would take seconds per typing error
  if (candidates.size() > most_compared) return {};
  if (name.size() > longest_compared) return {};
  std::string best;
  std::size_t best_distance = 1 + std::max<std::size_t>(1, name.size() / 3);
  for (const auto& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace trivet::foundation
