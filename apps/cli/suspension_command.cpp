// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "cli/commands.h"
#include "cli/console.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/suspension_json.h"
#include "trivet/results/suspension_text.h"
#include "trivet/study/suspension.h"

namespace trivet::cli {
namespace {

/// "x", "y", "z" or three numbers.
std::vector<Eigen::Vector3d> torques(const std::string& text) {
  if (text.empty()) return {};
  for (int i = 0; i < 3; ++i)
    if (text == std::string(1, "xyz"[i])) return {Eigen::Vector3d::Unit(i)};
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, axis(i));
    if (error != std::errc() || (i < 2 ? next == end || *next != ',' : next != end) || !(std::abs(axis(i)) < 1e30))
      throw BadArgument(fmt::format("--torque \"{}\": give x, y, z or three numbers like 0.9,0,0.1", text));
    at = next + 1;
  }
  if (axis.isZero(0)) throw BadArgument(fmt::format("--torque \"{}\": a moment needs a direction", text));
  return {axis};
}

}  // namespace

int suspension_command(const Options& options) {
  const auto project = read_or_complain(options, questions_of(options, {}));
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const std::vector<double> excitations =
        options.excitations.empty() ? std::vector<double>{} : frequencies("--excitation", options.excitations);
    const study::SuspensionAnswer answer = study::suspension(variant, torques(options.torque), excitations);
    if (options.csv) write_problems(answer.warnings);
    write_output(options.json      ? results::suspension_json(variant, answer)
                     : options.csv ? results::suspension_csv(variant, answer)
                                   : results::suspension_text(variant, answer));
    return done;
  } catch (const BadArgument& bad) {
    write_failure(bad);
  } catch (const foundation::InvalidInput& bad) {
    write_failure(bad);
  }
  return wrong_input;
}

}  // namespace trivet::cli
