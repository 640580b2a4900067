// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "trivet/documents/table.h"
#include "trivet/project/text/display_units.h"

/// A result, described once for all forms (docs/decisions/documents.md).
namespace trivet::documents {

/// A column of a curve in CSV: its heading and which real number of a complex one.
struct CurveColumn {
  std::string heading;
  double (*part)(const std::complex<double>& value);
};

/// A curve over an axis.
struct Curve {
  std::string name;  ///< of its array, and key of JSON
  std::string unit;
  Numbers values;
  bool harmonic = false;
  unsigned forms = in_csv | in_arrays;
  std::vector<CurveColumn> csv = {};  ///< empty: "name [unit]", the value or its size
};

/// Curves over a common axis: arrays, and columns of one file.
struct Curves {
  std::string axis;  ///< "angular_frequency"; name of its array, and key of JSON
  std::string unit;
  Numbers points;
  std::string file = {};                       ///< "response.csv"
  std::vector<std::string> axis_columns = {};  ///< their headings: "speed [rad/s]", "speed [rpm]"
  std::vector<Curve> list = {};
  unsigned forms = for_programs;  ///< of the axis; its curves have their own
};

/// One value, or a JSON value of any kind for JSON only.
struct Single {
  std::string name;
  Json value;
  std::string unit = "1";
  unsigned forms = in_json;
};

/// Words, or names on an axis.
struct Words {
  std::string key;   ///< of JSON; empty: not in JSON
  std::string axis;  ///< of the arrays; empty: no arrays
  std::vector<std::string> list;
  std::string name = {};  ///< of the array, if not that of the axis
};

/// A number in a sentence, shown in the units of [display].
struct Quantity {
  double value = 0;  ///< SI
  std::string unit = {};
  Kind kind = Kind::quantity;  ///< of a number that is not harmonic
  int digits = 5;
};

struct Sentence {
  /// A note is below a table; the screen breaks the lines of a text.
  enum class Place { paragraph, note, item, text };
  std::vector<std::variant<std::string, Quantity>> parts;
  Place place = Place::paragraph;
  unsigned forms = for_people;
};

struct Part;
/// Parts in an object of their own in JSON, or below a title for people, on the screen after a blank line; the page
/// shows them after a click then.
struct Group {
  std::string key;  ///< empty: no object of their own
  std::vector<Part> parts;
  std::string title = {};
  bool in_list = false;  ///< one of the objects of the list `key`; blank lines separate them on the screen
};

/// `LabelledArrays` are those with more axes than rows and a list in each.
struct Part {
  std::variant<Table, Curves, Single, Words, Sentence, Group, LabelledArrays> content;
};

/// The parts of a result in their order.
struct Document {
  std::vector<Part> parts;
  std::shared_ptr<const void> held = {};  ///< what it refers to, if nothing else keeps it
  template <typename Content>
  Content& add(Content content) {
    return std::get<Content>(parts.emplace_back(Part{std::move(content)}).content);
  }
};

/// The forms. Documents are views of results, which must outlive them and their arrays.
[[nodiscard]] Json as_json(const Document& document);
/// The same as text, with line breaks.
[[nodiscard]] std::string as_json_text(const Document& document);
/// The table or curves with this file name. @throws foundation::InvalidInput if there is none
[[nodiscard]] std::string as_csv(const Document& document, const std::string& file);
void add_arrays(const Document& document, LabelledArrays& list);
/// A column as CSV has it, with values in the units of [display]; null: there is none.
struct TypedColumn {
  std::string name;
  std::string unit;  ///< empty: none, or that of the row in the column "unit"
  std::vector<Json> values;
};
/// The columns of the table or curves with this file name. Two that become the same are one: speeds in rad/s and rpm.
/// @throws foundation::InvalidInput if there is none
[[nodiscard]] std::vector<TypedColumn> as_columns(const Document& document, const std::string& file,
                                                  const project::DisplayUnits& display);
/// @param form  on_screen or in_summary
[[nodiscard]] std::string as_text(const Document& document, const project::DisplayUnits& display,
                                  Form form = on_screen);
[[nodiscard]] std::string as_html(const Document& document, const project::DisplayUnits& display);

}  // namespace trivet::documents
