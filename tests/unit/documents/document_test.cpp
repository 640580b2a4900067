// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "trivet/documents/text_table.h"

/// One table and its curves in five forms.
namespace document_test {

using namespace trivet::documents;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using trivet::project::DisplayUnits;
using trivet::project::Level;

constexpr double infinity = std::numeric_limits<double>::infinity(), two_pi = 2 * std::numbers::pi;

double rpm(double omega) { return omega * 60 / two_pi; }

struct Resonance {
  std::string curve, unit;
  double omega = 0, amplitude = 0, share = 0;
  std::optional<int> mode;
  bool excited = false;
};

const std::vector<Resonance>& resonances() {
  static const std::vector<Resonance> list = {{"machine.z", "m", 2 * two_pi, 0.00125, 0.25, 3, true},
                                              {"machine, top", "m", 4 * two_pi, 2e-5, 0.5, {}, false},
                                              {"ground.force.z", "N", 8 * two_pi, infinity, 1, 1, true}};
  return list;
}

Table resonance_table() {
  const Rows row(resonances());
  return {
      .key = "peaks",
      .axis = "peak",
      .plain_names = true,
      .file = "peaks.csv",
      .title = "Peaks",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "curve", &Resonance::curve), row("unit", Kind::words, "", &Resonance::unit),
                  row("angular_frequency", Kind::frequency, "f", &Resonance::omega),
                  row("amplitude", Kind::amplitude, "amplitude", &Resonance::amplitude),
                  row("share", Kind::share, "share", &Resonance::share),
                  row("mode", Kind::number, "mode", &Resonance::mode),
                  row("excited", Kind::yes_no, "excited", &Resonance::excited)},
      .csv = {"name",
              "angular_frequency [rad/s]",
              {"frequency [Hz]", "angular_frequency [Hz]"},
              "angular_frequency [rpm]",
              "amplitude",
              "unit",
              "mode",
              "excited"},
      .mark = [](std::size_t i) { return i == 2 ? Mark::bad : Mark::plain; }};
}

Document document() {
  static const std::vector<double> speed = {1, 2.5};
  static const Eigen::VectorXcd response = (Eigen::VectorXcd(2) << std::complex(3.0, 4.0), 1).finished();
  Document all;
  all.add(Sentence{.parts = {"Highest at ", Quantity{two_pi, "rad/s", Kind::frequency}, ": ",
                             Quantity{0.002, "m", Kind::amplitude}}});
  all.add(resonance_table());
  all.add(Curves{.axis = "speed",
                 .unit = "rad/s",
                 .points = speed,
                 .file = "orders.csv",
                 .axis_columns = {"speed [rad/s]", "speed [rpm]"},
                 .list = {{.name = "machine.z", .unit = "m", .values = response, .harmonic = true}}});
  all.add(Single{.name = "searched_to", .value = infinity, .unit = "rad/s", .forms = in_json | in_arrays});
  all.add(Words{.key = "bodies", .axis = "body", .list = {"machine"}});
  all.add(Group{.key = "more", .parts = {{Single{.name = "count", .value = 3}}}});
  return all;
}

DisplayUnits inches_peak_to_peak() {
  DisplayUnits display;
  display.length = "in";
  display.level = Level::peak_to_peak;
  display.frequency = "rpm";
  return display;
}

TEST(DocumentAsJson, HasTheNumbersInSiAndNullWhereThereIsNone) {
  const Json all = Json::parse(trivet::documents::json::text(as_json(document())));
  ASSERT_EQ(all["peaks"].size(), resonances().size());
  EXPECT_EQ(all["peaks"][0]["angular_frequency"], 2 * two_pi);
  EXPECT_EQ(all["peaks"][0]["amplitude"], 0.00125);
  EXPECT_EQ(all["peaks"][0]["mode"], 3);
  EXPECT_TRUE(all["peaks"][1]["mode"].is_null());
  EXPECT_TRUE(all["peaks"][2]["amplitude"].is_null());
  EXPECT_EQ(all["speed"], Json({1.0, 2.5}));
  EXPECT_FALSE(all.contains("machine.z"));  // the curve is not for JSON
  EXPECT_EQ(all["more"]["count"], 3);
  EXPECT_EQ(all["bodies"], Json({"machine"}));
}

TEST(GroupsInAList, AreObjectsOfAListAndSeparatedByBlankLines) {
  Document all;
  for (const char* name : {"front", "rear"})
    all.add(Group{.key = "peaks",
                  .parts = {{Single{.name = "name", .value = name}}, {Sentence{.parts = {name}}}},
                  .in_list = true});
  all.add(Sentence{.parts = {"These are all."}});
  EXPECT_EQ(as_json(all), Json::parse(R"({"peaks": [{"name": "front"}, {"name": "rear"}]})"));
  EXPECT_EQ(as_text(all, {}), "front\n\nrear\n\nThese are all.\n");
}

TEST(DocumentOnTheScreen, BreaksTheLinesOfATextAndStartsATitleAfterABlankLine) {
  std::string words = "1";
  for (int i = 2; i <= 60; ++i) words += fmt::format(" {}", i);
  Document all;
  all.add(Sentence{.parts = {words}, .place = Sentence::Place::text});
  all.add(Group{.key = "", .parts = {{Sentence{.parts = {"one"}}}}, .title = "More"});
  const std::string text = as_text(all, {});
  EXPECT_TRUE(text.ends_with(" 60\n\nMore\none\n")) << text;
  EXPECT_NE(text.find("\n    "), std::string::npos);
  EXPECT_LE(text.find('\n'), 118U);
}

TEST(DocumentAsCsv, HasOneNumberInSeveralUnits) {
  EXPECT_EQ(as_csv(document(), "peaks.csv"),
            fmt::format("name,angular_frequency [rad/s],frequency [Hz],angular_frequency [rpm],amplitude,unit,mode,"
                        "excited\n"
                        "machine.z,{},2,{},0.00125,m,3,yes\n"
                        "\"machine, top\",{},4,{},2e-05,m,,no\n"
                        "ground.force.z,{},8,{},inf,N,1,yes\n",
                        2 * two_pi, rpm(2 * two_pi), 4 * two_pi, rpm(4 * two_pi), 8 * two_pi, rpm(8 * two_pi)));
  EXPECT_EQ(as_csv(document(), "orders.csv"),
            fmt::format("speed [rad/s],speed [rpm],machine.z [m]\n1,{},5\n2.5,{},1\n", rpm(1), rpm(2.5)));
  EXPECT_ANY_THROW((void)as_csv(document(), "other.csv"));
}

TEST(DocumentAsArrays, HasNamesUnitsAndAxes) {
  const Document all = document();
  LabelledArrays list;
  add_arrays(all, list);
  const LabelledArray& amplitude = *list.find("amplitude");
  EXPECT_EQ(amplitude.unit, unit_of_the_row);
  EXPECT_THAT(amplitude.axes, ElementsAre("peak"));
  EXPECT_THAT(amplitude.real_numbers(), ElementsAre(0.00125, 2e-5, infinity));
  EXPECT_TRUE(amplitude.harmonic && list.find("unit")->harmonic);
  EXPECT_FALSE(list.find("share")->harmonic);
  EXPECT_THAT(list.find("peak")->real_numbers(), ElementsAre(1, 2, 3));
  EXPECT_THAT(list.find("excited")->real_numbers(), ElementsAre(1, 0, 1));
  EXPECT_TRUE(std::isnan(list.find("mode")->real_numbers()[1]));
  EXPECT_THAT(list.find("name")->texts(), ElementsAre("machine.z", "machine, top", "ground.force.z"));
  EXPECT_THAT(list.find("machine.z")->complex_numbers(), ElementsAre(std::complex(3.0, 4.0), std::complex(1.0, 0.0)));
  EXPECT_EQ(list.find("searched_to")->unit, "rad/s");
}

TEST(DocumentForPeople, ShowsTheSameCellsOnTheScreenAndOnThePage) {
  const std::string text = as_text(document(), {}), html = as_html(document(), {});
  EXPECT_THAT(text, HasSubstr("Highest at 1 Hz: 2 mm 0-p\n"));
  EXPECT_THAT(html, HasSubstr("<p>Highest at 1 Hz: 2 mm 0-p</p>"));
  EXPECT_THAT(text, HasSubstr("f [Hz]"));
  for (const char* words : {"machine.z", "2.00000", "1.25000 mm 0-p", "20.0000 µm 0-p", "25.0 %", "∞", "–", "yes"}) {
    EXPECT_THAT(text, HasSubstr(words));
    std::string on_one_line;
    for (const char* c = words; *c; ++c) on_one_line += *c == ' ' ? std::string("\u00a0") : std::string(1, *c);
    EXPECT_THAT(html, HasSubstr(">" + on_one_line + "</td>"));
  }
  EXPECT_THAT(html, HasSubstr("<tr class=\"failed\"><td>ground.force.z</td>"));
}

TEST(DocumentForPeople, HasTheUnitsOfTheDisplayInTablesAndSentences) {
  const std::string text = as_text(document(), inches_peak_to_peak());
  EXPECT_THAT(text, HasSubstr("Highest at 60 rpm: 0.15748 in p-p\n"));
  EXPECT_THAT(text, HasSubstr("f [rpm]"));
  EXPECT_THAT(text, HasSubstr("0.0984252 in p-p"));  // 2 · 1.25 mm
}

TEST(DocumentForPeople, ShowsRoundOffAsZero) {
  static const std::vector<Resonance> list = {{"a", "m", 1, 1, 1, 1, true}, {"b", "m", 1, 1e-14, 1, 1, true}};
  const Rows row(list);
  Document one;
  one.add(Table{.rows = row.size(),
                .columns = {row("unit", Kind::words, "", &Resonance::unit),
                            row("amplitude", Kind::amplitude, "amplitude", &Resonance::amplitude)}});
  EXPECT_EQ(as_text(one, {}), "      amplitude\n  1.00000 m 0-p\n              0\n");
}

TEST(DocumentForPeople, ComparesRoundOffWithinOneColumnOnly) {
  static const std::vector<Resonance> list = {{"a", "m", 1e9, 1e-5, 1, 1, true}};  // a limit beside a small value
  const Rows row(list);
  Document one;
  one.add(Table{.rows = row.size(),
                .columns = {row("unit", Kind::words, "", &Resonance::unit),
                            row("allowed", Kind::quantity, "limit", &Resonance::omega),
                            row("value", Kind::quantity, "value", &Resonance::amplitude)}});
  EXPECT_THAT(as_text(one, {}), HasSubstr("10.0000 µm"));
}

TEST(DocumentForPeople, ShowsNoTableWithoutColumnsForThem) {
  const Rows row(resonances());
  Document one;
  one.add(Table{.title = "Peaks", .rows = row.size(), .columns = {row("unit", Kind::words, "", &Resonance::unit)}});
  EXPECT_EQ(as_text(one, {}) + as_html(one, {}), "");
}

TEST(DocumentForPeople, ShowsChosenRowsInTheirOrder) {
  Document one;
  Table& table = one.add(resonance_table());
  table.people_rows = {2, 0};
  table.most_rows = 1;
  const std::string text = as_text(one, {});
  EXPECT_THAT(text, HasSubstr("ground.force.z"));
  EXPECT_THAT(text, Not(HasSubstr("machine.z")));
  EXPECT_THAT(text, HasSubstr("the first 1 of 2"));
  EXPECT_THAT(as_html(one, {}), HasSubstr("machine.z"));
}

TEST(DocumentForPeople, ShowsTheHighestOfTooManyRowsInTheirOrder) {
  Document one;
  Table& table = one.add(resonance_table());
  table.people_rows = {2, 1, 0};
  table.most_rows = 2;
  const std::vector<double> heights = {2, std::numeric_limits<double>::quiet_NaN(), 1};
  table.height = [heights](std::size_t row) { return heights[row]; };
  const std::string text = as_text(one, {});
  EXPECT_THAT(text, Not(HasSubstr("ground.force.z")));
  EXPECT_THAT(text, HasSubstr("machine.z"));
  EXPECT_THAT(text, HasSubstr("(the 2 highest of 3; --csv or --json gives all)"));
}

}  // namespace document_test
