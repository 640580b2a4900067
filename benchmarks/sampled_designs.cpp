// SPDX-License-Identifier: BSD-3-Clause
// How long do ten million designs within twenty tolerances take? A machine on eight mounts: natural frequencies, and
// the highest amplitudes of its three translations in a band, also with rules on peaks. Compared with NumPy, and with
// OpenTURNS and SALib if they are there: the worst margins, the yields and the shares of the variance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measure.h"
#include "process.h"
#include "trivet/foundation/temporary_folder.h"

namespace {

using namespace trivet::benchmarks;
using nlohmann::json;
namespace fs = std::filesystem;

const std::string question = "designs within tolerances";

json answer_of(const std::string& command, const fs::path& file) {
  static_cast<void>(median({"/bin/sh", "-c", "exec " + command + " > '" + file.string() + "'"}, 1));
  return json::parse(std::ifstream(file));
}

/// CPU time of a sample without its start, per design.
double seconds_of(const fs::path& project, int designs, const std::string& more = "") {
  std::vector<std::string> words = {TRIVET_PROGRAM,
                                    "sample",
                                    project.string(),
                                    "--set",
                                    "analyses.sample.worst_case=false",
                                    "--set",
                                    fmt::format("analyses.sample.designs={}", designs)};
  if (!more.empty()) words.insert(words.end(), {"--set", more});
  return median(words, 3).cpu;
}

/// Worst margins to the digits of a refined grid, yields within five standard deviations of the random designs.
void compare(const json& ours, const json& theirs, double designs) {
  const json& requirements = ours.at("cases").at(0).at("requirements");
  for (std::size_t r = 0; r < theirs.at("worst").size(); ++r)
    compared("worst margin of " + requirements[r].at("requirement").get<std::string>(),
             std::abs(requirements[r].at("worst_margin").get<double>() / theirs.at("worst")[r].get<double>() - 1),
             1e-8);
  for (std::size_t r = 0; r < requirements.size(); ++r) {
    const double yield = requirements[r].at("yield").get<double>();
    compared("yield of " + requirements[r].at("requirement").get<std::string>(),
             std::abs(yield - theirs.at("yields")[r].get<double>()), 5 * std::sqrt(yield * (1 - yield) / designs));
  }
}

/// First and total shares of the first requirement with those of other programs, by the path of each number.
void compare_shares(const json& ours, const json& theirs) {
  std::vector<json> of;
  const std::string requirement = ours.at("cases").at(0).at("requirements").at(0).at("requirement");
  for (const json& one : ours.at("shares").at("list"))
    if (requirement.starts_with(one.at("requirement").get<std::string>())) of.push_back(one);
  const auto place = [&](const json& one) {
    const std::string name = one.at("number");
    for (std::size_t i = 0; i < theirs.at("numbers").size(); ++i)
      if (name.ends_with(theirs.at("numbers")[i].get<std::string>()) || (name == "core" && i + 1 == of.size()))
        return i;
    return of.size();
  };
  for (const auto& [program, shares] : theirs.at("shares").items()) {
    double first = 0, total = 0;
    for (const json& one : of) {
      first =
          std::max(first, std::abs(one.at("first").get<double>() - shares.at("first").at(place(one)).get<double>()));
      total =
          std::max(total, std::abs(one.at("total").get<double>() - shares.at("total").at(place(one)).get<double>()));
    }
    constexpr double of_random = 0.03;  // both are those of some thousand pairs
    compared("first shares of the variance by " + program, first, of_random);
    compared("total shares of the variance by " + program, total, of_random);
    record(question, "shares of the variance by " + program + ": largest difference of a total share", total, "", "",
           true);
    record(question, "… of a share alone", first, "", "", true);
  }
}

/// Limits at a speed and over a range of speeds under an unbalance, whose kernels are those of one order.
void measure_limits_at_speeds(const fs::path& folder) {
  const fs::path project = folder / "fan.toml";
  fs::copy_file(TRIVET_FAN, project);
  std::ofstream(project, std::ios::app) << R"(
[operation]
speeds = ["980 rpm", ["700 rpm", "1000 rpm"]]
limits = {"fan.z" = "2.8 mm/s rms", "ground.force.z" = "400 N"}
)";
  constexpr int designs = 100'000;
  const double start = seconds_of(project, 100), all = seconds_of(project, designs);
  record(question, "`trivet sample` of a fan, two limits at a speed and over a range, 100,000 designs", all, "s", "",
         true);
  record(question, "… a design, without its start", 1e6 * (all - start) / designs, "µs", "", true);
}

}  // namespace

int main() {
  const OneCore one_core;
  const trivet::foundation::TemporaryFolder folder;
  const fs::path project = folder.path() / "machine.toml";
  fs::copy_file(TRIVET_EIGHT_MOUNTS, project);
  const std::string sample = fmt::format("'{}' sample '{}' --shares --json", TRIVET_PROGRAM, project.string());
  const json ours = answer_of(sample, folder.path() / "ours.json");
  constexpr int designs_of_rivals = 5000;
  const json theirs = answer_of(fmt::format("'{}' '{}/sampled.py' '{}' {}", TRIVET_PYTHON, TRIVET_RIVALS,
                                            folder.path().string(), designs_of_rivals),
                                folder.path() / "theirs.json");
  compare(ours, theirs, designs_of_rivals);
  compare_shares(ours, theirs);

  constexpr int million = 1'000'000, many = 10 * million;
  const double start = seconds_of(project, 100), one = seconds_of(project, million), ten = seconds_of(project, many),
               with_peaks =
                   seconds_of(project, many, "requirements.no_peak=[\"machine.x\", \"machine.y\", \"machine.z\"]");
  record(question, "`trivet sample`, 1,000,000 designs", one, "s", "", true);
  record(question, "`trivet sample`, 10,000,000 designs", ten, "s", "≤ 60", ten <= 60);
  record(question, "… with rules on the peaks of three coordinates", with_peaks, "s", "≤ 120", with_peaks <= 120);
  const double per_design = (ten - start) / many;
  record(question, "… a design, without its start", 1e6 * per_design, "µs", "", true);
  measure_limits_at_speeds(folder.path());
  const json& seconds = theirs.at("seconds");
  const double of_numpy = seconds.at("numpy"), goal = 100 * goal_factor();
  record(question, "NumPy, batched eigvalsh and solve at 200 frequencies, a design", 1e6 * of_numpy, "µs", "", true);
  record(question, "… × ours", of_numpy / per_design, "", fmt::format("≥ {:.0f}", goal), of_numpy / per_design >= goal);
  if (!seconds.contains("openturns")) return 0;
  // It calls the NumPy function, so it computes a design in the same way and has no goal of its own.
  const double of_openturns = seconds.at("openturns");
  record(question, "OpenTURNS, which calls that function, a design", 1e6 * of_openturns, "µs", "", true);
  record(question, "… × ours", of_openturns / per_design, "", "", true);
}
