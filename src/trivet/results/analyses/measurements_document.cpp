// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "trivet/results/format/result_writer.h"

/// Measured curves and mode shapes compared with computed ones.
namespace trivet::results {
namespace {

using study::ChannelComparison;
using study::MeasurementComparison;
using study::PeakDifference;
using study::ShapeComparison;

/// A channel with the measurement that it belongs to, as rows of one table.
struct ComparedChannel {
  const MeasurementComparison* measurement;
  const ChannelComparison* channel;

  [[nodiscard]] std::string name() const { return measurement->name + " " + channel->result; }
};
/// A line of a measured curve, a peak, or a mode, with what it belongs to.
struct ComparedLine : ComparedChannel {
  std::size_t line;
};
struct ComparedPeak : ComparedChannel {
  const PeakDifference* peak;
};
struct ComparedShape {
  const MeasurementComparison* measurement;
  const ShapeComparison* shape;
};

std::vector<ComparedChannel> channels_of(const std::vector<const MeasurementComparison*>& measurements) {
  std::vector<ComparedChannel> all;
  for (const MeasurementComparison* one : measurements)
    for (const ChannelComparison& channel : one->channels) all.push_back({one, &channel});
  return all;
}

const std::string& measurement_name(const ComparedChannel& one) { return one.measurement->name; }
const std::string& result_name(const ComparedChannel& one) { return one.channel->result; }
const std::string& result_unit(const ComparedChannel& one) { return one.channel->unit; }

json::Json peaks_json(const ComparedChannel& one) {
  json::Json peaks = json::Json::array();
  for (const PeakDifference& peak : one.channel->peaks) {
    const auto& computed = peak.computed;
    peaks.push_back(
        {{"measured", {{"angular_frequency", peak.angular_frequency}, {"amplitude", json::number(peak.amplitude)}}},
         {"resolution", peak.resolution},
         {"computed",
          computed ? json::Json{{"angular_frequency", computed->angular_frequency},
                                {"amplitude", json::number(computed->amplitude)}}
                   : json::Json(nullptr)},
         {"frequency_difference", json::number(peak.frequency_difference())},
         {"height_db", json::number(peak.height_db())}});
  }
  return peaks;
}

Table channel_table(const std::vector<const MeasurementComparison*>& measurements, unsigned forms) {
  const Rows row(channels_of(measurements));
  const auto of = [](auto member) {
    return [member](const ComparedChannel& one) -> const auto& { return one.channel->*member; };
  };
  bool coherent = false;
  for (const ComparedChannel& one : channels_of(measurements)) coherent = coherent || one.channel->mean_coherence;
  return {
      .key = "channels",
      .axis = "channel",
      .plain_names = true,
      .file = "measurements.csv",
      .rows = row.size(),
      .columns =
          {row("measurement", Kind::words, "", measurement_name, {.forms = in_csv}),
           row("channel", Kind::words, "", &ComparedChannel::name, {.forms = in_arrays}),
           row("result", Kind::words, "result", result_name),
           row("source", Kind::words, "measured", of(&ChannelComparison::source)),
           row("unit", Kind::words, "", result_unit),
           row("lines", Kind::number, "lines",
               [](const ComparedChannel& one) { return one.channel->angular_frequency.size(); },
               {.forms = in_csv | for_people}),
           row("from", Kind::frequency, "from",
               [](const ComparedChannel& one) { return one.channel->angular_frequency.front(); },
               {.digits = 5, .forms = in_csv | for_people}),
           row("to", Kind::frequency, "to",
               [](const ComparedChannel& one) { return one.channel->angular_frequency.back(); },
               {.digits = 5, .forms = in_csv | for_people}),
           row("computed_vanishes", Kind::yes_no, "", of(&ChannelComparison::vanishes), {.forms = in_json}),
           row("rms_db", Kind::number, "rms", of(&ChannelComparison::rms_db), {.unit = "dB", .digits = 3}),
           row("largest_db", Kind::number, "largest", of(&ChannelComparison::largest_db), {.unit = "dB", .digits = 3}),
           row("largest_at", Kind::frequency, "", of(&ChannelComparison::largest_at), {.forms = in_json | in_arrays}),
           row("largest_at", Kind::frequency, "at",
               [](const ComparedChannel& one) {
                 return one.channel->vanishes ? std::nullopt : std::optional(one.channel->largest_at);
               },
               {.digits = 5, .forms = in_csv | for_people}),
           row("frac", Kind::number, "", of(&ChannelComparison::assurance), {.forms = for_programs}),
           row("frac", Kind::number, "FRAC",
               [](const ComparedChannel& one) {
                 return one.channel->vanishes ? json::Json("computed: 0") : json::Json(one.channel->assurance);
               },
               {.digits = 4, .forms = for_people}),
           row("mean_coherence", Kind::number, coherent ? "coherence" : "", of(&ChannelComparison::mean_coherence),
               {.digits = 3}),
           row("peaks", Kind::words, "", peaks_json, {.forms = in_json}),
           row.lists("angular_frequency", "", "", {}, of(&ChannelComparison::angular_frequency), {.forms = in_json}),
           row.lists("measured", "", "", {}, of(&ChannelComparison::measured), {.forms = in_json}),
           row.lists("computed", "", "", {}, of(&ChannelComparison::computed), {.forms = in_json})},
      .csv = {"measurement",
              "result",
              "source",
              "unit",
              "lines",
              "from [rad/s]",
              "to [rad/s]",
              {"rms [dB]", "rms_db"},
              {"largest [dB]", "largest_db"},
              {"largest at [rad/s]", "largest_at"},
              "frac",
              {"mean coherence", "mean_coherence"}},
      .arrays = {"channel", "result", "unit", "rms_db", "largest_db", "largest_at", "frac", "mean_coherence"},
      .forms = forms};
}

Table measured_lines(const std::vector<const MeasurementComparison*>& measurements) {
  std::vector<ComparedLine> lines;
  for (const ComparedChannel& one : channels_of(measurements))
    for (std::size_t i = 0; i < one.channel->angular_frequency.size(); ++i) lines.push_back({one, i});
  const Rows row(std::move(lines));
  const auto number = [&row](const char* name, auto value, Kind kind = Kind::amplitude) {
    return row(name, kind, "", [value](const ComparedLine& one) {
      const auto i = static_cast<Eigen::Index>(one.line);
      return value(one.channel->measured(i), one.channel->computed(i));
    });
  };
  using Complex = std::complex<double>;
  return {
      .file = "measured_curves.csv",
      .rows = row.size(),
      .columns = {row("measurement", Kind::words, "", measurement_name), row("result", Kind::words, "", result_name),
                  row("unit", Kind::words, "", result_unit),
                  row("omega [rad/s]", Kind::frequency, "",
                      [](const ComparedLine& one) { return one.channel->angular_frequency[one.line]; }),
                  number("measured re", [](Complex m, Complex) { return m.real(); }),
                  number("measured im", [](Complex m, Complex) { return m.imag(); }),
                  number("computed re", [](Complex, Complex c) { return c.real(); }),
                  number("computed im", [](Complex, Complex c) { return c.imag(); }),
                  number(
                      "difference [dB]",
                      [](Complex m, Complex c) { return 20 * std::log10(std::abs(m) / std::abs(c)); }, Kind::number)},
      .forms = in_csv};
}

Curves channel_curves(const ComparedChannel& one) {
  return {.axis = one.name() + " angular_frequency",
          .unit = "rad/s",
          .points = one.channel->angular_frequency,
          .list = {{.name = one.name() + " measured",
                    .unit = one.channel->unit,
                    .values = one.channel->measured,
                    .harmonic = true},
                   {.name = one.name() + " computed",
                    .unit = one.channel->unit,
                    .values = one.channel->computed,
                    .harmonic = true}},
          .forms = in_arrays};
}

Table measured_peak_table(const std::vector<const MeasurementComparison*>& measurements, unsigned forms) {
  std::vector<ComparedPeak> peaks;
  for (const ComparedChannel& one : channels_of(measurements))
    for (const PeakDifference& peak : one.channel->peaks) peaks.push_back({one, &peak});
  const Rows row(std::move(peaks));
  const auto of = [](auto member) { return [member](const ComparedPeak& one) { return one.peak->*member; }; };
  const auto of_computed = [](double response::Peak::* member) {
    return [member](const ComparedPeak& one) {
      return one.peak->computed ? std::optional((*one.peak->computed).*member) : std::nullopt;
    };
  };
  const auto difference = [](const ComparedPeak& one) { return one.peak->frequency_difference(); };
  return {.axis = "peak",
          .file = "measured_peaks.csv",
          .title = "Measured peaks, and the nearest computed ones",
          .rows = row.size(),
          .columns = {row("measurement", Kind::words, "", measurement_name),
                      row("channel", Kind::words, "", &ComparedPeak::name),
                      row("result", Kind::words, "result", result_name), row("unit", Kind::words, "", result_unit),
                      row("measured_at", Kind::frequency, "measured peak", of(&PeakDifference::angular_frequency)),
                      row("resolution", Kind::frequency, "±", of(&PeakDifference::resolution), {.digits = 2}),
                      row("measured", Kind::amplitude, "height", of(&PeakDifference::amplitude), {.digits = 4}),
                      row("computed_at", Kind::frequency, "computed", of_computed(&response::Peak::angular_frequency)),
                      row("computed", Kind::amplitude, "computed height", of_computed(&response::Peak::amplitude),
                          {.digits = 4}),
                      row("frequency_difference", Kind::number, "", difference),
                      row("percent", Kind::number, "difference [%]",
                          [difference](const ComparedPeak& one) { return 100 * difference(one); }, {.digits = 3}),
                      row("height_db", Kind::number, "height difference",
                          [](const ComparedPeak& one) { return one.peak->height_db(); }, {.unit = "dB", .digits = 3})},
          .csv = {"measurement",
                  "result",
                  "unit",
                  {"measured at [rad/s]", "measured_at"},
                  "resolution [rad/s]",
                  {"measured amplitude", "measured"},
                  {"computed at [rad/s]", "computed_at"},
                  {"computed amplitude", "computed"},
                  {"frequency difference", "frequency_difference"},
                  {"height difference [dB]", "height_db"}},
          .arrays = {"channel", "unit", "measured_at", "resolution", "measured", "computed_at", "computed",
                     "frequency_difference", "height_db"},
          .forms = forms};
}

Table measured_mode_table(const std::vector<const MeasurementComparison*>& measurements, unsigned forms) {
  std::vector<ComparedShape> shapes;
  for (const MeasurementComparison* one : measurements)
    for (const ShapeComparison& shape : one->shapes) shapes.push_back({one, &shape});
  const Rows row(std::move(shapes));
  const auto of = [](auto member) { return [member](const ComparedShape& one) { return one.shape->*member; }; };
  const auto difference = [](const ComparedShape& one) { return one.shape->frequency_difference(); };
  return {
      .key = "modes",
      .axis = "mode",
      .file = "measured_modes.csv",
      .title = "Measured mode shapes, and the most similar computed ones",
      .rows = row.size(),
      .columns = {row("measurement", Kind::words, "", [](const ComparedShape& one) { return one.measurement->name; }),
                  row("measured_number", Kind::number, "measured mode", of(&ShapeComparison::measured)),
                  row("measured_at", Kind::frequency, "f", of(&ShapeComparison::measured_frequency)),
                  row("damping_ratio", Kind::number, "damping ratio", of(&ShapeComparison::damping_ratio),
                      {.digits = 4}),
                  row("mode", Kind::number, "most similar mode",
                      [](const ComparedShape& one) {
                        return one.shape->mode > 0 ? std::optional(one.shape->mode) : std::nullopt;
                      }),
                  row("computed_number", Kind::number, "", of(&ShapeComparison::mode)),
                  row("computed_at", Kind::frequency, "computed", of(&ShapeComparison::angular_frequency)),
                  row("frequency_difference", Kind::number, "", difference),
                  row("percent", Kind::number, "difference [%]",
                      [difference](const ComparedShape& one) { return 100 * difference(one); }, {.digits = 3}),
                  row("mac", Kind::number, "MAC", of(&ShapeComparison::assurance), {.digits = 4})},
      .json = {{"measured_mode", "measured_number"},
               {"measured_angular_frequency", "measured_at"},
               {"measured_damping_ratio", "damping_ratio"},
               "mode",
               {"angular_frequency", "computed_at"},
               "frequency_difference",
               "mac"},
      .csv = {"measurement",
              {"measured mode", "measured_number"},
              {"measured at [rad/s]", "measured_at"},
              {"damping ratio", "damping_ratio"},
              "mode",
              {"computed at [rad/s]", "computed_at"},
              {"frequency difference", "frequency_difference"},
              "mac"},
      .arrays = {"measurement", "measured_number", "measured_at", "computed_number", "computed_at",
                 "frequency_difference", "mac"},
      .forms = forms};
}

json::Json channels_json(const MeasurementComparison& one) {
  json::Json channels = as_json({{{channel_table({&one}, in_json)}}})["channels"];
  for (std::size_t i = 0; i < one.channels.size(); ++i)
    if (one.channels[i].coherence.size() > 0) channels[i]["coherence"] = json::list(one.channels[i].coherence);
  return channels;
}

Table measurement_table(const std::vector<MeasurementComparison>& measurements) {
  const Rows row(measurements);
  const auto json = [&row](const char* name, auto value) { return row(name, Kind::words, "", value); };
  return {
      .key = whole_json,
      .rows = row.size(),
      .columns = {json("name", &MeasurementComparison::name), json("file", &MeasurementComparison::file),
                  json("excitation",
                       [](const MeasurementComparison& one) {
                         return one.excitation.empty() ? json::Json(nullptr) : json::Json(one.excitation);
                       }),
                  json("band", [](const MeasurementComparison& one) { return json::Json{one.band.from, one.band.to}; }),
                  json("channels", channels_json), json("shape_components", &MeasurementComparison::components),
                  json("modes",
                       [](const MeasurementComparison& one) {
                         return as_json({{{measured_mode_table({&one}, in_json)}}})["modes"];
                       }),
                  json("mac", [](const MeasurementComparison& one) { return json::rows(one.assurance); })},
      .forms = in_json};
}

Document measurements_document(const project::Case&, const study::CaseResults& results) {
  std::vector<const MeasurementComparison*> all;
  for (const MeasurementComparison& one : results.measurements) all.push_back(&one);
  Document document;
  document.add(measurement_table(results.measurements));
  document.add(channel_table(all, in_csv | in_arrays));
  document.add(measured_lines(all));
  for (const ComparedChannel& one : channels_of(all)) document.add(channel_curves(one));
  document.add(measured_peak_table(all, in_csv | in_arrays));
  document.add(measured_mode_table(all, in_csv | in_arrays));
  for (const MeasurementComparison* one : all) {
    document.add(Sentence{.parts = {"Measurement " + one->name + " (" + one->file + ") minus computed" +
                                    (one->excitation.empty() ? "" : ", excited by " + one->excitation + " alone")}});
    document.add(channel_table({one}, for_people));
    document.add(measured_peak_table({one}, for_people));
    document.add(measured_mode_table({one}, for_people));
    if (!one->shapes.empty())
      document.add(Sentence{.parts = {fmt::format("Mode shapes over {} components", one->components)},
                            .place = Sentence::Place::note});
  }
  return document;
}

}  // namespace

const ResultWriter measurements_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return !results.measurements.empty(); },
    .document = measurements_document,
    .files = {"measurements.csv", "measured_curves.csv", "measured_peaks.csv", "measured_modes.csv"}};

}  // namespace trivet::results
