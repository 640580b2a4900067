// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/results/answer_writer.h"

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

std::vector<ComparedChannel> compared_channels(const study::Answers& answers) {
  std::vector<ComparedChannel> all;
  for (const MeasurementComparison& measurement : answers.measurements)
    for (const ChannelComparison& channel : measurement.channels) all.push_back({&measurement, &channel});
  return all;
}

// ---------------------------------------------------------------- JSON

json::Json peak_json(const PeakDifference& peak) {
  const auto& computed = peak.computed;
  return {{"measured", {{"angular_frequency", peak.angular_frequency}, {"amplitude", json::number(peak.amplitude)}}},
          {"resolution", peak.resolution},
          {"computed",
           computed ? json::Json{{"angular_frequency", computed->angular_frequency},
                                 {"amplitude", json::number(computed->amplitude)}}
                    : json::Json(nullptr)},
          {"frequency_difference", json::number(peak.frequency_difference())},
          {"height_db", json::number(peak.height_db())}};
}

json::Json channel_json(const ChannelComparison& channel) {
  json::Json peaks = json::Json::array();
  for (const PeakDifference& peak : channel.peaks) peaks.push_back(peak_json(peak));
  json::Json result{{"result", channel.result},
                    {"source", channel.source},
                    {"unit", channel.unit},
                    {"computed_vanishes", channel.vanishes},
                    {"rms_db", json::number(channel.rms_db)},
                    {"largest_db", json::number(channel.largest_db)},
                    {"largest_at", channel.largest_at},
                    {"frac", json::number(channel.assurance)},
                    {"mean_coherence", json::optional(channel.mean_coherence)},
                    {"peaks", std::move(peaks)},
                    {"angular_frequency", json::list(channel.angular_frequency)},
                    {"measured", json::list(channel.measured)},
                    {"computed", json::list(channel.computed)}};
  if (channel.coherence.size() > 0) result["coherence"] = json::list(channel.coherence);
  return result;
}

json::Json shape_json(const ShapeComparison& shape) {
  return {{"measured_mode", shape.measured},
          {"measured_angular_frequency", shape.measured_frequency},
          {"measured_damping_ratio", shape.damping_ratio},
          {"mode", shape.mode > 0 ? json::Json(shape.mode) : json::Json(nullptr)},
          {"angular_frequency", json::optional(shape.angular_frequency)},
          {"frequency_difference", json::number(shape.frequency_difference())},
          {"mac", shape.assurance}};
}

json::Json measurements_json(const project::Case&, const study::Answers& answers) {
  json::Json result = json::Json::array();
  for (const MeasurementComparison& one : answers.measurements) {
    json::Json channels = json::Json::array(), shapes = json::Json::array();
    for (const ChannelComparison& channel : one.channels) channels.push_back(channel_json(channel));
    for (const ShapeComparison& shape : one.shapes) shapes.push_back(shape_json(shape));
    result.push_back({{"name", one.name},
                      {"file", one.file},
                      {"excitation", one.excitation.empty() ? json::Json(nullptr) : json::Json(one.excitation)},
                      {"band", {one.band.from, one.band.to}},
                      {"channels", std::move(channels)},
                      {"shape_components", one.components},
                      {"modes", std::move(shapes)},
                      {"mac", json::rows(one.assurance)}});
  }
  return result;
}

// ---------------------------------------------------------------- text

std::string band_text(const ChannelComparison& channel, const project::ShownUnits& display) {
  return fmt::format("{:.5g} … {:.5g}", shown_frequency(display, channel.angular_frequency.front()),
                     shown_frequency(display, channel.angular_frequency.back()));
}

std::string percent_text(double share) { return number_text(100 * share, 3); }

std::string channels_text(const MeasurementComparison& measurement, const project::ShownUnits& display) {
  bool coherent = false;
  for (const ChannelComparison& channel : measurement.channels) coherent = coherent || channel.mean_coherence;
  std::vector<std::string> header = {"result",   "measured",     "lines [" + frequency_unit(display) + "]",
                                     "rms [dB]", "largest [dB]", "at [" + frequency_unit(display) + "]",
                                     "FRAC"};
  if (coherent) header.emplace_back("coherence");
  TextTable table(std::move(header));
  for (const ChannelComparison& channel : measurement.channels) {
    std::vector<std::string> row = {
        channel.result,
        channel.source,
        band_text(channel, display),
        number_text(channel.rms_db, 3),
        number_text(channel.largest_db, 3),
        channel.vanishes ? "–" : number_text(shown_frequency(display, channel.largest_at), 5),
        channel.vanishes ? "computed: 0" : number_text(channel.assurance, 4)};
    if (coherent) row.push_back(channel.mean_coherence ? number_text(*channel.mean_coherence, 3) : "–");
    table.add(std::move(row));
  }
  return measurement.channels.empty() ? "" : table.text();
}

std::string peaks_text(const MeasurementComparison& measurement, const project::ShownUnits& display) {
  TextTable table({"result", "measured peak [" + frequency_unit(display) + "]", "± [" + frequency_unit(display) + "]",
                   "computed [" + frequency_unit(display) + "]", "difference [%]", "height difference [dB]"});
  bool any = false;
  for (const ChannelComparison& channel : measurement.channels)
    for (const PeakDifference& peak : channel.peaks) {
      any = true;
      table.add({channel.result, number_text(shown_frequency(display, peak.angular_frequency), 5),
                 number_text(shown_frequency(display, peak.resolution), 2),
                 peak.computed ? number_text(shown_frequency(display, peak.computed->angular_frequency), 5) : "–",
                 percent_text(peak.frequency_difference()), number_text(peak.height_db(), 3)});
    }
  return any ? "  Peaks, and the nearest computed ones\n" + table.text() : "";
}

std::string shapes_text(const MeasurementComparison& measurement, const project::ShownUnits& display) {
  if (measurement.shapes.empty()) return "";
  TextTable table({"measured mode", "f [" + frequency_unit(display) + "]", "most similar mode",
                   "computed f [" + frequency_unit(display) + "]", "difference [%]", "MAC"});
  for (const ShapeComparison& shape : measurement.shapes)
    table.add({std::to_string(shape.measured), number_text(shown_frequency(display, shape.measured_frequency), 5),
               shape.mode > 0 ? std::to_string(shape.mode) : "–",
               shape.angular_frequency ? number_text(shown_frequency(display, *shape.angular_frequency), 5) : "–",
               percent_text(shape.frequency_difference()), number_text(shape.assurance, 4)});
  return fmt::format("  Mode shapes over {} components\n", measurement.components) + table.text();
}

std::string measurements_text(const project::Case&, const study::Answers& answers) {
  std::string text;
  for (const MeasurementComparison& one : answers.measurements) {
    const std::string force = one.excitation.empty() ? "" : ", excited by " + one.excitation + " alone";
    text += fmt::format("Measurement {} ({}) minus computed{}\n", one.name, one.file, force) +
        channels_text(one, answers.display) + peaks_text(one, answers.display) + shapes_text(one, answers.display);
  }
  return text;
}

// ---------------------------------------------------------------- CSV

/// One row per compared channel.
std::string measurements_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "measurement,result,source,unit,lines,from [rad/s],to [rad/s],rms [dB],largest [dB],largest at [rad/s],frac,"
      "mean coherence\n";
  for (const auto& [measurement, channel] : compared_channels(answers))
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(measurement->name), csv_field(channel->result),
                    csv_field(channel->source), csv_field(channel->unit), channel->angular_frequency.size(),
                    channel->angular_frequency.front(), channel->angular_frequency.back(), csv_number(channel->rms_db),
                    csv_number(channel->largest_db), channel->vanishes ? "" : csv_number(channel->largest_at),
                    csv_number(channel->assurance), csv_number(channel->mean_coherence));
  return text;
}

/// One row per measured frequency of each channel.
std::string measured_curves_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "measurement,result,unit,omega [rad/s],measured re,measured im,computed re,computed im,difference [dB]\n";
  for (const auto& [measurement, channel] : compared_channels(answers)) {
    const std::string names =
        csv_field(measurement->name) + "," + csv_field(channel->result) + "," + csv_field(channel->unit);
    for (Eigen::Index i = 0; i < channel->measured.size(); ++i) {
      const std::complex<double> m = channel->measured(i), c = channel->computed(i);
      text += names;
      for (const double value : {channel->angular_frequency[static_cast<std::size_t>(i)], m.real(), m.imag(), c.real(),
                                 c.imag(), 20 * std::log10(std::abs(m) / std::abs(c))})
        append_csv_number(text, value);
      text += '\n';
    }
  }
  return text;
}

std::string measured_peaks_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "measurement,result,unit,measured at [rad/s],resolution [rad/s],measured amplitude,computed at [rad/s],computed "
      "amplitude,frequency difference,height difference [dB]\n";
  for (const auto& [measurement, channel] : compared_channels(answers))
    for (const PeakDifference& peak : channel->peaks) {
      text += csv_field(measurement->name) + "," + csv_field(channel->result) + "," + csv_field(channel->unit);
      for (const double value :
           {peak.angular_frequency, peak.resolution, peak.amplitude,
            peak.computed ? peak.computed->angular_frequency : nothing,
            peak.computed ? peak.computed->amplitude : nothing, peak.frequency_difference(), peak.height_db()})
        append_csv_number(text, value);
      text += '\n';
    }
  return text;
}

std::string measured_modes_csv(const project::Case&, const study::Answers& answers) {
  std::string text =
      "measurement,measured mode,measured at [rad/s],damping ratio,mode,computed at [rad/s],frequency difference,mac\n";
  for (const MeasurementComparison& one : answers.measurements)
    for (const ShapeComparison& shape : one.shapes)
      text +=
          fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(one.name), shape.measured, shape.measured_frequency,
                      shape.damping_ratio, shape.mode > 0 ? std::to_string(shape.mode) : "",
                      csv_number(shape.angular_frequency), csv_number(shape.frequency_difference()), shape.assurance);
  return text;
}

// ---------------------------------------------------------------- arrays

void add_peak_arrays(const std::vector<ComparedChannel>& channels, LabelledArrays& list) {
  std::vector<std::string> names, units;
  std::vector<PeakDifference> peaks;
  for (const ComparedChannel& one : channels) {
    names.insert(names.end(), one.channel->peaks.size(), one.name());
    units.insert(units.end(), one.channel->peaks.size(), one.channel->unit);
    peaks.insert(peaks.end(), one.channel->peaks.begin(), one.channel->peaks.end());
  }
  list.count("peak", peaks.size());
  list.texts("peak.channel", "peak", std::move(names));
  list.texts("peak.unit", "peak", std::move(units));
  list.column("peak.measured_at", "rad/s", "peak", peaks, &PeakDifference::angular_frequency);
  list.column("peak.resolution", "rad/s", "peak", peaks, &PeakDifference::resolution);
  list.column("peak.measured", unit_of_the_row, "peak", peaks, &PeakDifference::amplitude);
  const auto of_computed = [&](double response::Peak::* member) {
    return [member](const PeakDifference& peak) { return peak.computed ? (*peak.computed).*member : nothing; };
  };
  list.column("peak.computed_at", "rad/s", "peak", peaks, of_computed(&response::Peak::angular_frequency));
  list.column("peak.computed", unit_of_the_row, "peak", peaks, of_computed(&response::Peak::amplitude));
  list.column("peak.frequency_difference", "1", "peak", peaks, &PeakDifference::frequency_difference);
  list.column("peak.height_db", "dB", "peak", peaks, &PeakDifference::height_db);
  list.mark_harmonic({"peak.unit", "peak.measured", "peak.computed"});
}

void add_mode_arrays(const std::vector<MeasurementComparison>& measurements, LabelledArrays& list) {
  std::vector<std::string> names;
  std::vector<ShapeComparison> shapes;
  for (const MeasurementComparison& one : measurements) {
    names.insert(names.end(), one.shapes.size(), one.name);
    shapes.insert(shapes.end(), one.shapes.begin(), one.shapes.end());
  }
  list.count("mode", shapes.size());
  list.texts("mode.measurement", "mode", std::move(names));
  list.column("mode.measured_number", "1", "mode", shapes, &ShapeComparison::measured);
  list.column("mode.measured_at", "rad/s", "mode", shapes, &ShapeComparison::measured_frequency);
  list.column("mode.computed_number", "1", "mode", shapes, &ShapeComparison::mode);
  list.column("mode.computed_at", "rad/s", "mode", shapes, &ShapeComparison::angular_frequency);
  list.column("mode.frequency_difference", "1", "mode", shapes, &ShapeComparison::frequency_difference);
  list.column("mode.mac", "1", "mode", shapes, &ShapeComparison::assurance);
}

void measurements_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  const std::vector<ComparedChannel> channels = compared_channels(answers);
  const std::string axis = "channel";
  const auto number = [&](const char* name, const char* unit, double ChannelComparison::* member) {
    list.column(name, unit, axis, channels, [member](const ComparedChannel& one) { return one.channel->*member; });
  };
  list.texts(axis, axis, channels, &ComparedChannel::name);
  list.texts("result", axis, channels, [](const ComparedChannel& one) { return one.channel->result; });
  list.texts("unit", axis, channels, [](const ComparedChannel& one) { return one.channel->unit; });
  number("rms_db", "dB", &ChannelComparison::rms_db);
  number("largest_db", "dB", &ChannelComparison::largest_db);
  number("largest_at", "rad/s", &ChannelComparison::largest_at);
  number("frac", "1", &ChannelComparison::assurance);
  list.column("mean_coherence", "1", axis, channels,
              [](const ComparedChannel& one) { return one.channel->mean_coherence; });
  for (const ComparedChannel& one : channels) {
    const std::string frequencies = one.name() + " angular_frequency";
    list.view(frequencies, "rad/s", frequencies, one.channel->angular_frequency);
    list.view(one.name() + " measured", one.channel->unit, frequencies, one.channel->measured);
    list.view(one.name() + " computed", one.channel->unit, frequencies, one.channel->computed);
    list.mark_harmonic({one.name() + " measured", one.name() + " computed"});
  }
  add_peak_arrays(channels, list);
  add_mode_arrays(answers.measurements, list);
}

}  // namespace

const AnswerWriter measurements_results = {
    .has_answer = [](const project::Case&, const study::Answers& answers) { return !answers.measurements.empty(); },
    .json = measurements_json,
    .tables = {{"measurements.csv", measurements_csv},
               {"measured_curves.csv", measured_curves_csv},
               {"measured_peaks.csv", measured_peaks_csv},
               {"measured_modes.csv", measured_modes_csv}},
    .text = measurements_text,
    .arrays = measurements_arrays,
};

}  // namespace trivet::results
