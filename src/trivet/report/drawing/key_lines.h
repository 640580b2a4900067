// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trivet/report/drawing/curve_panel.h"

namespace trivet::report {

/// Strokes with their texts in lines of a limited width, outside the plots that they explain.
class KeyLines {
 public:
  explicit KeyLines(double width) : width_(width) {}

  /// Curves of one panel; a stroke with the same text is entered once.
  void add(const std::vector<PanelCurve>& curves);
  [[nodiscard]] bool is_ambiguous() const { return is_ambiguous_; }  ///< has one stroke two meanings?
  [[nodiscard]] double height() const;                               ///< [pixels]
  void draw(SvgCanvas& canvas, PixelPoint corner) const;

 private:
  struct Entry {
    std::string stroke, text;
    PixelPoint at;
  };
  /// Where the next entry begins, in a new line if this one has no room for it.
  PixelPoint place(const std::string& text);

  double width_;
  std::map<std::string, std::string> texts_;
  std::vector<Entry> entries_;
  PixelPoint last_;
  bool is_ambiguous_ = false;
};

}  // namespace trivet::report
