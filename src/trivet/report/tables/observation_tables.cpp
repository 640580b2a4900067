// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/html_table.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/tables/input_tables.h"

namespace trivet::report {
namespace {

std::string components_words(const Eigen::Vector3d& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v(0), v(1), v(2));
}

std::string section_words(const model::Description& d, const model::Section& section) {
  std::vector<std::string> names;
  for (const std::size_t e : section.elements) names.push_back(d.elements[e].name);
  return foundation::comma_separated(names);
}

}  // namespace

std::string observations_table(const model::Description& d) {
  std::vector<std::vector<Cell>> rows;
  for (const model::RelativeMotion& motion : d.relative_motions)
    rows.push_back({{motion.name},
                    {"relative motion"},
                    {motion.of.name + " relative to " + motion.to.name},
                    {"axis " + components_words(motion.axes.col(2))}});
  for (const model::Section& section : d.sections)
    rows.push_back({{section.name},
                    {"section"},
                    {section_words(d, section)},
                    {"about " + components_words(section.at) + " m, z axis " + components_words(section.axes.col(2))}});
  for (const model::Clearance& clearance : d.clearances)
    rows.push_back({{clearance.name},
                    {"clearance"},
                    {clearance.of.name + " to " + clearance.to.name},
                    {fmt::format("gap {:.6g} m along {}", clearance.gap, components_words(clearance.direction))}});
  return html_table({{"name"}, {"kind"}, {"of"}, {"ground frame"}}, rows);
}

}  // namespace trivet::report
