// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/read_project.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/sample_tally.h"

namespace trivet {
namespace unit_sample_test {

using testing::HasSubstr;

/// Two masses in a row under a force.
const std::string machine = test::driven_pair() + R"(
[analyses]
response = {of = ["m1.x", "m2.x"]}
[tolerances.rubber]
path = ["elements.k1.scale", "elements.k2.scale"]
half_width = "15 %"
[tolerances.casting]
path = "bodies.m1.mass"
standard_deviation = "3 %"
)";
const std::string required = "[requirements]\nlimits = {\"m1.x\" = \"2.2 mm\", \"m2.x\" = \"3.6 mm\"}\n";

std::string json_with(const project::Project& project, int threads) {
  const foundation::ThreadLimit limit(threads);
  const study::Sample found = study::sample(project);
  return results::as_json_text(results::sample_document(found, {}));
}

TEST(Sample, IsTheSameForAnyNumberOfThreads) {
  for (const char* sampling : {"sobol", "random"}) {
    const project::Project project = test::project(
        machine + required, {"analyses.sample.designs=5000", std::string("analyses.sample.sampling=") + sampling});
    const std::string one = json_with(project, 1);
    EXPECT_THAT(one, HasSubstr("\"met\""));
    EXPECT_EQ(json_with(project, 2), one);
    EXPECT_EQ(json_with(project, 4), one);
  }
}

TEST(Sample, DependsOnItsSeed) {
  const auto with = [](const char* seed) {
    return json_with(test::project(machine + required, {"analyses.sample.designs=500", seed}), 1);
  };
  EXPECT_EQ(with("analyses.sample.seed=1"), with("analyses.sample.seed=1"));
  EXPECT_NE(with("analyses.sample.seed=1"), with("analyses.sample.seed=2"));
}

// A damping ratio has no kernel: the same numbers by assembled models.
TEST(Sample, IsTheSameByKernelsAndByModels) {
  const std::vector<std::string> few = {"analyses.sample.designs=400"};
  const study::Sample quick = study::sample(test::project(machine + required, few));
  const study::Sample slow = study::sample(test::project(machine + required + "damping_ratio = 1e-6\n", few));
  EXPECT_EQ(quick.cases[0].no_kernels, "");
  EXPECT_THAT(slow.cases[0].no_kernels, HasSubstr("has no kernel over many designs"));
  EXPECT_EQ(slow.cases[0].one_by_one, 400);
  EXPECT_EQ(quick.yield.met, slow.yield.met);
  for (std::size_t r = 0; r < 2; ++r) {
    const study::SampledRequirement &a = quick.cases[0].requirements[r], &b = slow.cases[0].requirements[r];
    EXPECT_EQ(a.yield.met, b.yield.met);
    EXPECT_EQ(a.first, b.first);
    EXPECT_EQ(a.margin.median, b.margin.median);
    EXPECT_NEAR(a.margin.extremes.least / b.margin.extremes.least, 1, 1e-8);
    EXPECT_EQ(a.margin.extremes.least_at, b.margin.extremes.least_at);
  }
}

TEST(Sample, CountsWhatBreaksFirstAndWhatIsMetAlone) {
  const study::Sample found = study::sample(test::project(machine + required, {"analyses.sample.designs=2000"}));
  ASSERT_EQ(found.cases.size(), 1);
  const auto& list = found.cases[0].requirements;
  EXPECT_EQ(list[0].first + list[1].first, 2000 - found.yield.met) << "each violated design once";
  EXPECT_GT(list[0].first, 0);
  EXPECT_GT(list[1].first, 0);
  for (const study::SampledRequirement& one : list) {
    EXPECT_GE(one.yield.met, found.yield.met);
    // Amplitudes: value = limit/margin, so the largest value has the least margin.
    EXPECT_NEAR(one.value->extremes.largest * one.margin.extremes.least, one.given.allowed, 1e-15);
    EXPECT_LT(one.value->low, one.value->median);
    EXPECT_LT(one.value->median, one.value->high);
    EXPECT_NEAR(*one.mean, one.value->median, 0.1 * one.value->median);
    EXPECT_GT(*one.deviation, 0);
  }
  const double least = std::min(list[0].margin.extremes.least, list[1].margin.extremes.least);
  EXPECT_EQ(found.worst_margin, least);
}

// A mass of which 0.3 % are negative: those designs have no model.
TEST(Sample, CountsDesignsWithoutAModelAsFailed) {
  const std::string text = machine + required;
  const std::vector<std::string> wide = {"analyses.sample.designs=4000",
                                         "tolerances.casting.standard_deviation=\"37 %\""};
  const auto project = judging::project_from_text(text, "test.toml", wide);
  ASSERT_TRUE(project);
  ASSERT_EQ(project->base().warnings.list().size(), 1);
  EXPECT_THAT(foundation::message(project->base().warnings.list().front()),
              HasSubstr("tolerances.casting: 0.344 % of its numbers at \"bodies.m1.mass\" are ≤ 0"));
  const study::Sample found = study::sample(*project);
  EXPECT_NEAR(static_cast<double>(found.failed) / 4000, 0.00344, 0.001);
  ASSERT_TRUE(found.first_failed);
  EXPECT_LT(found.first_failed->numbers[2].value, 0);
  EXPECT_THAT(found.first_failure, HasSubstr("mass"));
  const study::SampledCaseResult& only = found.cases[0];
  EXPECT_EQ(only.in_kernels + only.one_by_one + found.failed, 4000);
  EXPECT_EQ(only.requirements[0].first + only.requirements[1].first + found.yield.met + found.failed, 4000);
  // The first failed design is the first with a negative mass.
  const study::DrawnDesigns drawn(found.tolerances, found.request);
  const Eigen::MatrixXd draws = drawn.draw(0, 4000);
  std::uint64_t first = 0;
  while (draws(static_cast<Eigen::Index>(first), 2) > 0) ++first;
  EXPECT_EQ(found.first_failed->number, first);
}

// 8 % of a normal number: one in 10^36 is negative, which no study meets.
TEST(Sample, DoesNotWarnOfWhatNeverOccurs) {
  const project::Project project = test::project(machine + required, {"tolerances.casting.standard_deviation=\"8 %\""});
  EXPECT_TRUE(project.base().warnings.list().empty());
}

// Cases have the same designs: a case that changes nothing has the same numbers.
TEST(Sample, HasTheSameDesignsInAllCases) {
  const std::string cases = "[cases.same.bodies.m2]\nmass = 4.0\n[cases.hot.elements]\nk1.scale = 0.8\n";
  const study::Sample found = study::sample(test::project(
      machine + required + "hold_in = [\"\", \"same\", \"hot\"]\n" + cases, {"analyses.sample.designs=500"}));
  ASSERT_EQ(found.cases.size(), 3);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(found.cases[1].requirements[r].margin.extremes, found.cases[0].requirements[r].margin.extremes);
    EXPECT_LT(found.cases[2].requirements[r].margin.median, found.cases[0].requirements[r].margin.median);
    EXPECT_LE(found.yield.met, found.cases[2].requirements[r].yield.met);
  }
}

/// A rotor that runs at 600 rpm, with a limit up to 5 Hz.
const std::string rotor = test::chain({10}, {40000, 0}, {60, 0}) + R"(
[excitations.rotor]
type = "unbalance"
on = "m1"
at = [0, 0, 0]
axis = "z"
mass_eccentricity = 1e-3
[operation]
speeds = ["600 rpm"]
[requirements.limits]
"m1.x" = {limit = "1 m", band = ["1 Hz", "5 Hz"]}
[tolerances.rubber]
path = "elements.k1.scale"
half_width = "10 %"
)";

TEST(Sample, StatesWhatItNeeds) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(study::sample(test::project(text)));
    } catch (const std::exception& wrong) {
      return wrong.what();
    }
    return "";
  };
  EXPECT_THAT(message(machine), HasSubstr("neither requirements nor limits"));
  EXPECT_THAT(message(rotor),
              HasSubstr("tolerances: \"m1.x at 600 rpm\" cannot be judged: no limit holds at this speed"));
  EXPECT_THAT(message(test::chain({1}, {1}, {1}) + "[requirements]\ndamping_ratio = 0.1\n"),
              HasSubstr("the file has no tolerances"));
}

TEST(Tally, CountsADesignWithAFailureAndNoOther) {
  const project::Project project = test::project(machine + required);
  const std::vector<project::Tolerance>& tolerances = project.base().analyses.tolerances;
  const study::DrawnDesigns drawn(tolerances, {});
  const std::vector<study::SampledCase> cases(1, {project.base(), tolerances, drawn});
  study::SampleTally tally(cases, drawn.replicates(), {{{}, {}}});
  study::SampledMargins margins{Eigen::ArrayXXd::Constant(3, 2, 2.0), std::vector<std::string>(3)};
  margins.margins.row(1).setConstant(std::numeric_limits<double>::quiet_NaN());
  margins.failures[1] = "it has no model";
  tally.add(drawn, 10, {margins});
  EXPECT_EQ(tally.failed, 1);
  EXPECT_EQ(tally.first_failed, 11);
  EXPECT_EQ(tally.first_failure, "it has no model");
  EXPECT_EQ(tally.of[0][0].margins.count(), 2);
}

// Where damping ratios are negative the margin is 0: neither these values nor what depends on them is known.
TEST(Sample, HasNoValuesOfNegativeDampingRatios) {
  const std::string damped = test::chain({10}, {40000, 0}, {60, 0}) + R"([tolerances.oil]
path = "elements.k1.damping.translation.x"
half_width = "20 %"
[requirements]
damping_ratio = 0.01
)";
  const study::Sample found = study::sample(test::project(damped, {"analyses.sample.designs=100"}));
  const study::SampledRequirement& one = found.cases.at(0).requirements.at(0);
  ASSERT_TRUE(one.value);
  const double given = 60 / (2 * std::sqrt(40000 * 10));
  EXPECT_NEAR(one.value->median, given, 0.01 * given) << "100 designs";
  EXPECT_FALSE(study::value_at_margin(one.given, 0));
  EXPECT_EQ(study::value_at_margin(one.given, 2), 0.02);
  study::RequirementResult limit = one.given;
  limit.kind = study::RequirementKind::amplitude;
  EXPECT_EQ(study::value_at_margin(limit, 0), std::numeric_limits<double>::infinity());
}

// Whether it has no value, or a constant one, each requirement says why it has no shares.
TEST(Sample, SaysWhyARequirementHasNoShares) {
  const std::string more = "no_peak = \"m1.x\"\npeak_tolerance = 0.5\n[analyses.sample]\ndesigns = 500\n";
  const project::Project project = test::project(machine + required + more);
  const study::Sample found = study::sample(project, {}, {.shares = true});
  ASSERT_EQ(found.shares->list.size(), 3);
  EXPECT_EQ(found.shares->list[0].reason, "");
  EXPECT_EQ(found.shares->list[2].reason, "its margin is not that of a value");
  EXPECT_TRUE(found.shares->list[2].sets.empty());
  const std::string text = results::as_json_text(results::sample_document(found, {}));
  EXPECT_THAT(text, HasSubstr("\"its margin is not that of a value\""));

  const std::string other = test::chain({10, 4}, {40000, 20000, 0}, {60, 30, 0}) +
      "[bodies.alone]\nmass = 1\nfree = [\"x\"]\n[elements.own]\ntype = \"three_springs\"\non = \"alone\"\n"
      "at = [0, 0, 0]\ntranslation = [1000, 0, 0]\n[excitations.force]\ntype = \"harmonic\"\non = \"m1\"\n"
      "at = [0, 0, 0]\nforce = [10, 0, 0]\n[tolerances.own]\npath = \"elements.own.scale\"\nhalf_width = \"5 %\"\n"
      "[analyses.sample]\ndesigns = 500\n";
  const study::Sample idle = study::sample(test::project(other + required), {}, {.shares = true});
  ASSERT_EQ(idle.shares->list.size(), 2);
  for (const study::RequirementShares& one : idle.shares->list) EXPECT_EQ(one.reason, "its value does not vary");
}

TEST(DrawnDesigns, AreTheSameInAnyPieces) {
  const project::Project project = test::project(machine + required);
  for (const bool sobol : {true, false}) {
    const study::DrawnDesigns drawn(project.base().analyses.tolerances, {.sobol = sobol, .seed = 7});
    const Eigen::MatrixXd whole = drawn.draw(0, 100);
    EXPECT_EQ(drawn.draw(40, 30), whole.middleRows(40, 30));
    EXPECT_EQ(drawn.replicates(), sobol ? 16 : 1);
    EXPECT_EQ(drawn.draws(), 3);
    EXPECT_EQ(drawn.name(1).words(), "rubber at elements.k2.scale");
    EXPECT_EQ(drawn.name(2).words(), "casting");
  }
}

TEST(YieldWords, StateBoundsAndDigits) {
  const auto words = [](std::uint64_t met, std::uint64_t all) {
    const study::Yield yield{met, all, numerics::share_of_trials(met, all, 0.95)};
    return results::yield_words(yield);
  };
  EXPECT_EQ(words(10000, 10000), "≥ 99.970 % with 95 % confidence");
  EXPECT_EQ(words(0, 10000), "≤ 0.030 % with 95 % confidence");
  EXPECT_EQ(words(9730, 10000), "97.30 % (95 % confidence: 96.96 % … 97.61 %)");
  EXPECT_EQ(words(9999, 10000), "99.990 % (95 % confidence: 99.944 % … 100.000 %)");
  const study::Yield replicates{19994, 20000, {.estimate = 0.999712, .from = 0.9997011, .to = 0.9997231}, true};
  EXPECT_EQ(results::yield_words(replicates), "99.9712 % (95 % confidence: 99.9701 % … 99.9724 %)");
  const auto shown = [](std::uint64_t met) {
    const results::Json json = results::yield_json({met, 1000, numerics::share_of_trials(met, 1000, 0.95)});
    return json["shown_share"].get<std::string>() + "|" + json["shown_interval"].get<std::string>();
  };
  EXPECT_EQ(shown(1000), "≥ 99.70 %|");
  EXPECT_EQ(shown(0), "≤ 0.30 %|");
  EXPECT_EQ(shown(946), "94.6 %|93.0 % … 96.0 %");
}

// 2430 of 4000 are 60.75 %, at most 62.2686 %; a wanted yield between a number and its rounded words gets more digits.
TEST(YieldWords, DifferFromTheWantedYieldAsTheNumbersDo) {
  const study::Yield some{2430, 4000, {.estimate = 0.6075, .from = 0.5921234, .to = 0.6226862}};
  EXPECT_EQ(results::yield_words(some, 0.607),
            "60.8 % (95 % confidence: 59.2 % … 62.3 %), NOT certainly the wanted 60.7 %");
  EXPECT_EQ(results::yield_words(some, 0.608),
            "60.75 % (95 % confidence: 59.21 % … 62.27 %), NOT certainly the wanted 60.8 %");
  EXPECT_EQ(results::yield_words(some, 0.62269),
            "60.7500 % (95 % confidence: 59.2123 % … 62.2687 %), NOT the wanted 62.269 %");
  EXPECT_EQ(results::yield_words(some, 0.59211), "60.750 % (95 % confidence: 59.212 % … 62.269 %), wanted 59.211 %");
  const study::Yield all{2000, 2000, numerics::share_of_trials(2000, 2000, 0.95)};  // 0.05^(1/2000) = 99.85033 %
  EXPECT_EQ(results::yield_words(all, 0.998503), "≥ 99.8503 % with 95 % confidence, wanted 99.8503 %");
}

TEST(YieldWords, OfSharesContainZeroOnlyWithTheInterval) {
  EXPECT_EQ(results::share_words({0.642, 0.63817, 0.64581}), "64.20 % (63.81 % … 64.59 %)");
  EXPECT_EQ(results::share_words({0.003, 0.0002, 0.0058}), "0.30 % (0.02 % … 0.58 %)");
  EXPECT_EQ(results::share_words({0.003, -0.0002, 0.0058}), "cannot be told from 0, ≤ 0.58 %");
}

}  // namespace unit_sample_test
}  // namespace trivet
