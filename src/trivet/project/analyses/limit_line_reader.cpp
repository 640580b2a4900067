// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <numbers>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/selection_reader.h"
#include "trivet/project/text/idle_key.h"
#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {

void read_limit_lines(TableReader& root, const ResultNames& names, Analyses& result) {
  const Node* table = root.table("limit_lines");
  if (!table) return;
  const Node* requirements = root.has("requirements") ? root.node("requirements") : nullptr;
  if (!result.response && !(requirements && requirements->find("limit_lines") && requirements->find("band")))
    root.error("limit_lines", "no response to compare with",
               "limit lines apply to the band of analyses.response, or to that of the requirements that name them",
               "add response = {…} to [analyses]");
  TableReader all(*table, "limit_lines", root.problems());
  for (const std::string& name : table->keys) {
    const Node* node = all.table(name);
    if (!node) continue;
    TableReader reader(*node, "limit_lines." + name, root.problems());
    LimitLineRequest request;
    request.of = reader.required_text("of");
    const auto quantity = reader.choice("quantity", {"displacement", "velocity", "acceleration"}).value_or("velocity");
    const auto motion_quantity = quantity == "velocity" ? assembly::MotionQuantity::velocity
        : quantity == "acceleration"                    ? assembly::MotionQuantity::acceleration
                                                        : assembly::MotionQuantity::displacement;
    const auto measured = names.component(request.of, motion_quantity);
    if (reader.has("of") && !measured)
      reader.error("of", foundation::quoted(request.of),
                   "a limit line belongs to one component: \"BODY.x\", \"BODY.POINT.z\", \"ELEMENT.force.z\"",
                   "check the name");
    request.line.name = name;
    request.line.rms = reader.choice("level", {"rms", "zero_to_peak"}).value_or("rms") == "rms";
    static constexpr std::array<const char*, 3> units = {"m", "m/s", "m/s²"}, turning = {"rad", "rad/s", "rad/s²"};
    if (measured && reader.has("quantity") && names.is_force(request.of))
      warn_of_idle_key(reader, "quantity", "\"" + quantity + "\" of a force", "it applies to motions only",
                       "remove it");
    if (measured) {
      const bool force = *measured == Quantity::force || *measured == Quantity::moment;
      const bool turns = request.of.size() > 3 && request.of[request.of.size() - 2] == 'r';
      request.line.unit = force ? (*measured == Quantity::force ? "N" : "N m")
                                : (turns ? turning : units)[static_cast<std::size_t>(motion_quantity)];
    }
    const ColumnQuantity level = read_bare_unit(reader, measured.value_or(Quantity::pure));
    const auto rows = reader.has("rows") ? read_pairs(reader, "rows", in_hertz(), level)
                                         : read_pairs_of_file(reader, "frequency_hz", "limit", in_hertz(), level);
    reader.finish();
    if (!rows || !measured) continue;
    for (const double hertz : rows->col(0)) request.line.angular_frequency.push_back(2 * std::numbers::pi * hertz);
    for (const double limit : rows->col(1)) request.line.limit.push_back(level.bare * limit);
    const foundation::Problems findings = assembly::check(request.line, reader.has("rows") ? "rows" : "file");
    reader.add(findings);
    if (!findings.has_errors()) result.limit_lines.push_back(std::move(request));
  }
}

}  // namespace trivet::project
