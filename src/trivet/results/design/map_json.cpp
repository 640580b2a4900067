// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/map_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "trivet/documents/csv_field.h"
#include "trivet/results/design/map_document.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using json::Json;

/// Passes a text to a sink in pieces.
class Pieces {
 public:
  explicit Pieces(const TextSink& sink) : sink_(sink) {}
  std::string& text() {
    if (text_.size() >= piece) hand_on();
    return text_;
  }
  void hand_on() {
    sink_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = 1 << 16;
  const TextSink& sink_;
  std::string text_;
};

/// Margins and governing rules; a margin is null if the design has none or no rule limits it.
void write_grid(const study::DesignMap& map, Pieces& out) {
  out.text() += "{\"order\":\"row after row of y, x running\",\"margin\":[";
  const char* separator = "";
  for (const design::DesignOutcome& outcome : map.outcomes) {
    if (outcome.known() && std::isfinite(outcome.margin))
      fmt::format_to(std::back_inserter(out.text()), "{}{}", separator, outcome.margin);
    else (out.text() += separator) += "null";
    separator = ",";
  }
  out.text() += "],\"governing\":[";
  separator = "";
  for (const design::DesignOutcome& outcome : map.outcomes) {
    out.text() += separator;
    if (!outcome.known())
      out.text() += outcome.governing == design::DesignOutcome::no_model ? "\"no model\"" : "\"not computed\"";
    else if (std::isinf(outcome.margin)) out.text() += "\"none\"";
    else fmt::format_to(std::back_inserter(out.text()), "{}", outcome.governing);
    separator = ",";
  }
  out.text() += "]}";
}

}  // namespace

Json json::design_map(const study::DesignMap& map, const MapColours& colours) {
  Json result = as_json(map_document(map, colours));
  std::string grid;
  const TextSink sink = [&](std::string_view piece) { grid += piece; };
  Pieces pieces(sink);
  write_grid(map, pieces);
  pieces.hand_on();
  result["grid"] = Json::parse(grid);
  return result;
}

namespace {

void write_with_grid(const Json& rest, const study::DesignMap& map, const TextSink& sink) {
  std::string head = json::text(rest);
  head.pop_back();
  Pieces pieces(sink);
  pieces.text() += head + ",\"grid\":";
  write_grid(map, pieces);
  pieces.text() += "}";
  pieces.hand_on();
}

}  // namespace

void write_map_json(const study::DesignMap& map, const foundation::Problems& warnings, const TextSink& sink) {
  Json result = as_json(map_document(map));
  result["warnings"] = json::warnings(warnings);
  write_with_grid(result, map, sink);
  sink("\n");
}

void write_map_pairs_json(const std::vector<study::DesignMap>& maps, const foundation::Problems& warnings,
                          const TextSink& sink) {
  const MapColours colours(maps);
  sink("{\"pairs\":[");
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (k > 0) sink(",");
    write_with_grid(as_json(map_document(maps[k], colours)), maps[k], sink);
  }
  sink("],\"warnings\":" + json::text(json::warnings(warnings)) + "}\n");
}

namespace {

std::string column_head(const project::DesignAxis& a) {
  return csv_field(axis_unit(a).empty() ? a.name : a.name + " [" + axis_unit(a) + "]");
}

/// @param before  the first fields of each row, with a comma behind
void write_rows(const study::DesignMap& map, const std::string& before, Pieces& pieces) {
  std::vector<std::string> words;
  for (const design::MapRule& rule : map.rules) words.push_back(csv_field(rule.words));
  for (std::size_t k = 0; k < map.outcomes.size(); ++k) {
    const design::DesignPoint p = map.point(k);
    const design::DesignOutcome& o = map.outcomes[k];
    std::string& text = pieces.text();
    fmt::format_to(std::back_inserter(text), "{}{},{},", before, p.x, p.y);
    if (o.known())
      fmt::format_to(std::back_inserter(text), "{},{},{}\n", o.margin,
                     std::isinf(o.margin) ? "none" : words[o.governing], o.feasible() ? "yes" : "no");
    else text += o.governing == design::DesignOutcome::no_model ? ",no model,no\n" : ",not computed,no\n";
  }
}

std::string in_one_text(const std::function<void(const TextSink&)>& write) {
  std::string text;
  write([&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace

void write_map_csv(const study::DesignMap& map, const TextSink& sink) {
  Pieces pieces(sink);
  pieces.text() += column_head(map.request.x) + "," + column_head(map.request.y) + ",margin,governing,kept\n";
  write_rows(map, "", pieces);
  pieces.hand_on();
}

void write_map_pairs_csv(const std::vector<study::DesignMap>& maps, const TextSink& sink) {
  Pieces pieces(sink);
  pieces.text() += "x parameter,y parameter,x,y,margin,governing,kept\n";
  for (const study::DesignMap& map : maps)
    write_rows(map, column_head(map.request.x) + "," + column_head(map.request.y) + ",", pieces);
  pieces.hand_on();
}

std::string map_pairs_csv(const std::vector<study::DesignMap>& maps) {
  return in_one_text([&](const TextSink& sink) { write_map_pairs_csv(maps, sink); });
}

std::string map_csv(const study::DesignMap& map) {
  return in_one_text([&](const TextSink& sink) { write_map_csv(map, sink); });
}

}  // namespace trivet::results
