// SPDX-License-Identifier: BSD-3-Clause
// How long does a change of one number take until its modes, the curves that a page draws, and all curves and peaks
// are there? The generator set of the examples and a raft of ten bodies in one process, compared with reading the
// changed file again.
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

/// A machine, a number of it that changes, and the curves that a page draws of it.
struct Machine {
  const char* words;  ///< "one body"
  const char* file;
  const char* number;
  std::vector<engine::Value> drawn;
  double modes, draft, all;  ///< goals [ms]
};

/// Text of the modes, and of curves and peaks.
std::string modes_of(const engine::Session& session) { return engine::whole(asked(session, "modes").json); }
std::string curves_of(const engine::Session& session) {
  return engine::whole(asked(session, "response").json) + engine::whole(asked(session, "peaks").json);
}

/// Characters of all that a moving slider needs: modes, and the drawn curves as functions.
std::size_t drafted(const engine::Session& session, const Machine& machine) {
  engine::Request request{"curves"};
  request.keys.emplace_back("draft", true);
  request.keys.emplace_back("of", machine.drawn);
  return modes_of(session).size() + engine::whole(session.ask(request).json).size();
}

void measure_machine(const Machine& machine) {
  const std::string file = machine.file, question = "a live change";
  const engine::Session base = value_or_exit(engine::Session::open({file}));
  int step = 0;
  const auto setting = [&](int at) { return fmt::format("{} = {}", machine.number, 1 + 1e-3 * at); };
  const auto changed = [&] { return value_or_exit(base.changed({setting(++step % 100)})); };
  const auto again = [&] { return value_or_exit(engine::Session::open({file}, {setting(++step % 100)})); };
  const engine::Session one = value_or_exit(base.changed({setting(7)})),
                        other = value_or_exit(engine::Session::open({file}, {setting(7)}));
  compared(question, modes_of(one) == modes_of(other) && curves_of(one) == curves_of(other) ? 0 : 1, 0);
  std::size_t length = 0;
  const auto modes = [&](const engine::Session& session) { length += asked(session, "modes").warnings.list().size(); };
  const auto draft = [&](const engine::Session& session) { length += drafted(session, machine); };
  const auto all = [&](const engine::Session& session) {
    asked(session, "modes");
    asked(session, "response");
    length += asked(session, "peaks").warnings.list().size();
  };
  const auto ms = [&](const std::string& until, double goal, const auto& work) {
    const std::vector<double> seconds = measure({question, fmt::format("{}, {}", machine.words, until), "change"},
                                                {in_process("Trivet, session changed", 1, [&] { work(changed()); }),
                                                 in_process("Trivet, file read again", 1, [&] { work(again()); })});
    record(question, fmt::format("{}: ms until {}", machine.words, until), 1e3 * seconds[0], "ms",
           fmt::format("≤ {}", goal), 1e3 * seconds[0] <= goal);
  };
  ms("modes", machine.modes, modes);
  ms("modes and drawn curves as text", machine.draft, draft);
  ms("modes, all curves and peaks", machine.all, all);
  if (length == static_cast<std::size_t>(-1)) std::exit(1);
}

}  // namespace

int main() {
  const OneCore one_core;
  measure_machine({.words = "one body",
                   .file = TRIVET_EXAMPLES "/genset/genset.toml",
                   .number = "elements.\"front left\".scale",
                   .drawn = {"genset.x", "genset.y", "genset.z", "genset.rx", "genset.ry", "genset.rz"},
                   .modes = 3,
                   .draft = 3,
                   .all = 15});
  measure_machine({.words = "ten bodies",
                   .file = TRIVET_TEN_BODIES,
                   .number = "element_types.\"raft mount\".scale",
                   .drawn = {"diesel.x", "diesel.y", "diesel.z", "raft.x", "raft.y", "raft.z"},
                   .modes = 10,
                   .draft = 40,
                   .all = 500});
}
