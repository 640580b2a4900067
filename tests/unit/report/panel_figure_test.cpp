// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/panel_figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace trivet {
namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

report::PanelRow panel(const std::string& title, const std::string& key, const std::string& stroke) {
  report::PanelRow row;
  row.x = {0, 1, false, "t [s]"};
  row.y = {0, 1, false, "force [N]"};
  row.curves = {{{key}, {0, 1}, {0, 1}, stroke}};
  row.title = title;
  return row;
}

TEST(PanelFigure, HasOneKeyIfEachStrokeMeansTheSameInAllPanels) {
  const report::Figure figure =
      report::panel_figure("Run-up", "run-up.svg",
                           {panel("x", "order 1", "stroke=\"red\""), panel("y", "order 1", "stroke=\"red\""),
                            panel("z", "order 1", "stroke=\"red\""), panel("θx", "order 2", "stroke=\"blue\"")});
  EXPECT_EQ(count(figure.svg, ">order 1<"), 1);
  EXPECT_EQ(count(figure.svg, ">order 2<"), 1);
  for (const char* title : {">x<", ">y<", ">z<", ">θx<"}) EXPECT_EQ(count(figure.svg, title), 1) << title;
  EXPECT_EQ(figure.strips.size(), 2u);  // three panels, and one below them
}

TEST(PanelFigure, HasAKeyForEachPanelIfAStrokeHasTwoMeanings) {
  const report::Figure figure =
      report::panel_figure("Steady motion", "steady.svg",
                           {panel("", "stable", "stroke=\"red\""), panel("", "harmonic 1", "stroke=\"red\""),
                            panel("", "stable", "stroke=\"red\"")});
  EXPECT_EQ(count(figure.svg, ">stable<"), 2);
  EXPECT_EQ(count(figure.svg, ">harmonic 1<"), 1);
  EXPECT_EQ(figure.strips.size(), 2u);  // two panels in a row
}

TEST(PanelFigure, OfOnePanelHasItsKeyBesideIt) {
  const report::Figure figure = report::panel_figure("Level", "level.svg", {panel("", "seat", "stroke=\"red\"")});
  EXPECT_EQ(count(figure.svg, ">seat<"), 1);
  EXPECT_TRUE(figure.strips.empty());
}

double number_after(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  return at == std::string::npos ? -1 : std::stod(text.substr(at + part.size()));
}

TEST(PanelFigure, NamesAMarkBesideTheCurveAboveIt) {
  report::PanelRow row = panel("", "limit", "stroke=\"red\"");
  row.curves.front().y = {0.55, 0.55};  // where the name would be
  row.marks = {{0.5, 0.5, "blue", "+1.2 dB"}};
  const std::string svg = report::panel_figure("Limit", "limit.svg", {row}).svg;
  const std::string text = svg.substr(0, svg.find(">+1.2 dB<"));
  const double centre = number_after(svg.substr(svg.find("<circle")), "cy=\""),
               baseline = number_after(text.substr(text.rfind("<text")), "y=\"");
  EXPECT_GT(baseline, centre + 10);  // below the mark
}

}  // namespace
}  // namespace trivet
