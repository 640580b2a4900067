// SPDX-License-Identifier: BSD-3-Clause
// How long does a change of one number take until its modes, and all curves and peaks, are there? The generator set of
// the examples in one process, compared with reading the changed file again.
#include <fmt/format.h>

#include <cstdlib>

#include "measure.h"
#include "trivet/engine/session.h"

using namespace trivet;
using namespace trivet::benchmarks;

namespace {

engine::Session value_or_exit(foundation::Expected<engine::Session> session) {
  if (session) return std::move(*session);
  std::fputs(foundation::message(session.error().list().front()).c_str(), stderr);
  std::exit(1);
}

engine::Result asked(const engine::Session& session, const char* command) {
  engine::Result result = session.ask({command});
  if (!result.failure.empty() || result.errors.has_errors()) std::exit(1);
  return result;
}

std::string setting(int step) { return fmt::format("elements.\"front left\".scale = {}", 1 + 1e-3 * step); }

/// Text of the modes, and of curves and peaks.
std::string modes_of(const engine::Session& session) { return engine::whole(asked(session, "modes").json); }
std::string curves_of(const engine::Session& session) {
  return engine::whole(asked(session, "response").json) + engine::whole(asked(session, "peaks").json);
}

}  // namespace

int main() {
  const OneCore one_core;
  const std::string file = TRIVET_EXAMPLES "/genset/genset.toml";
  const engine::Session base = value_or_exit(engine::Session::open({file}));
  int step = 0;
  const auto changed = [&] { return value_or_exit(base.changed({setting(++step % 100)})); };
  const auto again = [&] { return value_or_exit(engine::Session::open({file}, {setting(++step % 100)})); };
  const engine::Session one = value_or_exit(base.changed({setting(7)})),
                        other = value_or_exit(engine::Session::open({file}, {setting(7)}));
  compared("a live change", modes_of(one) == modes_of(other) && curves_of(one) == curves_of(other) ? 0 : 1, 0);
  std::size_t length = 0;
  const std::vector<double> modes = measure(
      {"a live change", "one body, modes", "change"},
      {in_process("Trivet, session changed", 1, [&] { length += asked(changed(), "modes").warnings.list().size(); }),
       in_process("Trivet, file read again", 1, [&] { length += asked(again(), "modes").warnings.list().size(); })});
  const auto all = [&](const engine::Session& session) {
    asked(session, "modes");
    asked(session, "response");
    length += asked(session, "peaks").warnings.list().size();
  };
  const auto drafted = [&](const engine::Session& session) {
    asked(session, "modes");
    engine::Request request{"curves"};
    request.keys.emplace_back("draft", true);
    length += engine::whole(session.ask(request).json).size();
  };
  const std::vector<double> draft = measure({"a live change", "one body, modes, all curves as functions", "change"},
                                            {in_process("Trivet, session changed", 1, [&] { drafted(changed()); }),
                                             in_process("Trivet, file read again", 1, [&] { drafted(again()); })});
  const std::vector<double> curves = measure({"a live change", "one body, modes, all curves and peaks", "change"},
                                             {in_process("Trivet, session changed", 1, [&] { all(changed()); }),
                                              in_process("Trivet, file read again", 1, [&] { all(again()); })});
  record("a live change", "ms until modes", 1e3 * modes[0], "ms", "≤ 3", modes[0] <= 3e-3);
  record("a live change", "ms until modes and curves as functions", 1e3 * draft[0], "ms", "≤ 3", draft[0] <= 3e-3);
  record("a live change", "ms until modes, curves and peaks", 1e3 * curves[0], "ms", "≤ 15", curves[0] <= 15e-3);
  return length == static_cast<std::size_t>(-1);
}
