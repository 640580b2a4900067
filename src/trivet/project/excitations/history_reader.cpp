// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/excitations/universal_course.h"
#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {
namespace {

/// Reads the numbers of one pulse: a missing one without a default is a problem.
struct PulseReader {
  TableReader& table;
  Quantity measured;

  double amplitude() const { return table.required_number("amplitude", measured); }
  /// Of a sine, which may be at a level.
  double sine_amplitude() const { return table.required_number("amplitude", measured, Levels::of_harmonic); }
  double time(const std::string& key) const { return table.required_number(key, Quantity::time); }
  double start() const { return table.number("start", Quantity::time).value_or(0); }
};

excitation::Signal read_sweep(const PulseReader& of) {
  excitation::Sweep sweep;
  sweep.amplitude = of.sine_amplitude();
  sweep.from = of.table.required_number("from", Quantity::angular_frequency);
  sweep.to = of.table.required_number("to", Quantity::angular_frequency);
  sweep.duration = of.time("duration");
  sweep.start = of.start();
  sweep.phase = of.table.number("phase", Quantity::angle).value_or(0);
  if (of.table.choice("law", {"linear", "logarithmic"}) == "logarithmic")
    sweep.law = excitation::Sweep::Law::logarithmic;
  if (of.table.choice("amplitude_law", {"constant", "speed_squared"}) == "speed_squared")
    sweep.amplitude_law = excitation::Sweep::Amplitude::speed_squared;
  return excitation::sweep_signal(sweep);
}

struct Pulse {
  const char* name;
  std::function<excitation::Signal(const PulseReader&)> read;
};

const std::vector<Pulse>& pulses() {
  using namespace excitation;
  static const std::vector<Pulse> list = {
      {"step", [](const PulseReader& p) { return step(p.amplitude(), p.start()); }},
      {"ramp", [](const PulseReader& p) { return ramp(p.amplitude(), p.time("rise"), p.start()); }},
      {"rounded_step", [](const PulseReader& p) { return rounded_step(p.amplitude(), p.time("rise"), p.start()); }},
      {"rectangular", [](const PulseReader& p) { return rectangular(p.amplitude(), p.time("duration"), p.start()); }},
      {"half_sine", [](const PulseReader& p) { return half_sine(p.amplitude(), p.time("duration"), p.start()); }},
      {"versed_sine", [](const PulseReader& p) { return versed_sine(p.amplitude(), p.time("duration"), p.start()); }},
      {"trapezoid",
       [](const PulseReader& p) {
         return trapezoid(p.amplitude(), p.time("rise"), p.time("hold"), p.time("fall"), p.start());
       }},
      {"triangle",
       [](const PulseReader& p) { return triangle(p.amplitude(), p.time("rise"), p.time("fall"), p.start()); }},
      {"sawtooth",
       [](const PulseReader& p) { return terminal_peak_sawtooth(p.amplitude(), p.time("duration"), p.start()); }},
      {"sine_burst",
       [](const PulseReader& p) {
         return sine_burst(p.sine_amplitude(), p.table.required_number("frequency", Quantity::angular_frequency),
                           p.table.required_number("cycles", Quantity::pure), p.start());
       }},
      {"sweep", read_sweep},
  };
  return list;
}

std::optional<excitation::Signal> read_pulse(TableReader& history, const Pulse& pulse, Quantity measured) {
  const Node* table = history.table(pulse.name);
  if (!table) return std::nullopt;
  TableReader reader(*table, history.path() + "." + pulse.name, history.problems());
  const std::size_t before = reader.errors();
  std::optional<excitation::Signal> signal;
  std::string refusal;
  try {
    signal = pulse.read({reader, measured});
  } catch (const foundation::InvalidInput& wrong) {
    refusal = wrong.what();
  } catch (const foundation::NotComputable& wrong) {
    refusal = wrong.what();
  }
  reader.finish();
  if (reader.errors() > before) return std::nullopt;  // a missing number counts as 0 above
  if (!refusal.empty())
    reader.error("", refusal, "the numbers of a pulse are finite and its times > 0", "correct the number");
  return signal;
}

std::optional<excitation::Signal> signal_from_rows(TableReader& reader, const std::string& key,
                                                   const Eigen::MatrixXd& rows, double scale, bool hold) {
  excitation::Samples samples;
  samples.times.assign(rows.col(0).begin(), rows.col(0).end());
  for (const double value : rows.col(1)) samples.values.push_back(scale * value);
  samples.afterwards = hold ? excitation::Samples::Afterwards::hold : excitation::Samples::Afterwards::zero;
  const foundation::Problems findings = excitation::check(samples, key);
  reader.add(findings);
  if (findings.has_errors()) return std::nullopt;
  try {
    return excitation::from_samples(samples);
  } catch (const foundation::InvalidInput& wrong) {
    reader.error(key, wrong.what(), "straight lines between samples have finite slopes", "check the times");
    return std::nullopt;
  }
}

/// A file or rows: bare values in SI, or in `unit`.
std::optional<excitation::Signal> read_samples(TableReader& history, Quantity measured) {
  const double scale = history.number("scale", Quantity::pure).value_or(1);
  const ColumnQuantity value = read_bare_unit(history, measured);
  const bool hold = history.choice("after", {"hold", "zero"}).value_or("hold") == "hold";
  const auto rows = read_rows_over_time(history, value);
  return rows ? signal_from_rows(history, history.has("rows") ? "rows" : "file", *rows, scale * value.bare, hold)
              : std::nullopt;
}

}  // namespace

std::optional<Eigen::MatrixXd> read_rows_over_time(TableReader& history, const ColumnQuantity& value) {
  if (history.has("rows")) return read_pairs(history, "rows", Quantity::time, value);
  if (names_universal_file(history)) return read_time_response(history, value);
  return read_pairs_of_file(history, "time", "value", Quantity::time, value, most_rows_over_time);
}

std::optional<excitation::Signal> read_history(TableReader& reader, const std::string& key,
                                               const model::Action& action) {
  const Node* node = reader.node(key);
  if (!node) {
    reader.missing(key,
                   "give {file = \"a.csv\"}, {half_sine = {amplitude = \"50 g\", duration = \"11 ms\"}}, {step = "
                   "{amplitude = …}} …");
    return std::nullopt;
  }
  const Node* table = reader.table(key);
  if (!table) return std::nullopt;
  TableReader history(*table, reader.path() + "." + key, reader.problems());
  const Quantity measured = course_quantity(action);
  std::vector<const Pulse*> given;
  for (const Pulse& pulse : pulses())
    if (history.has(pulse.name)) given.push_back(&pulse);
  const bool sampled = history.has("file") || history.has("rows");
  std::optional<excitation::Signal> signal;
  if (given.size() + (sampled ? 1 : 0) != 1) {
    std::string names;
    for (const Pulse& pulse : pulses()) names += std::string(", ") + pulse.name;
    history.error("", given.empty() && !sampled ? "no signal" : "more than one signal",
                  "exactly one of file, rows" + names + " is expected", "use one excitation for each signal");
    for (const Pulse* pulse : given) static_cast<void>(history.node(pulse->name));
    if (given.empty() && !sampled) return std::nullopt;
    for (const char* name : {"file", "rows", "unit", "scale", "after"}) static_cast<void>(history.node(name));
  } else {
    signal = sampled ? read_samples(history, measured) : read_pulse(history, *given.front(), measured);
  }
  history.finish();
  return signal;
}

}  // namespace trivet::project
