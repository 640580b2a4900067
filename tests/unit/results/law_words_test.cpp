// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/model_words.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "support/projects.h"

namespace law_words_test {

using namespace trivet;

std::vector<std::string> words(const std::string& element) {
  const project::Project given = test::project(
      "trivet = 1\n[bodies.b]\nmass = 1\ninertia = {about = \"center_of_mass\", xx = 1, yy = 1, zz = 1}\n" + element);
  std::vector<std::string> all;
  for (const model::Fact& fact : results::law_facts(given.base().system.elements().at(0)))
    all.push_back(fact.what + ": " + fact.value);
  return all;
}

std::string spring(const std::string& laws) {
  return "[elements.s]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [1e5, 1e5, 1e5]\n"
         "rotation = [1e3, 1e3, 1e3]\n" +
      laws;
}

TEST(LawWords, NameTheNumbersOfEachLaw) {
  EXPECT_THAT(
      words(spring("laws.z = {cubic = 4e10, friction = {slip = 40, stiffness = 4e5, breakaway = 50}}")),
      testing::UnorderedElementsAre("law along z: polynomial: 4e+10 δ^3 [N], δ in m",
                                    "law along z: friction: slips at 40 N (static 50 N), sticks with 400 kN/m"));
  EXPECT_THAT(words(spring("laws.rx = {gap_stop = {gaps = [0.01, 0.02], stiffness = 5e3}}")),
              testing::ElementsAre("law about x: gap stop: gap 10 mrad, gap below 20 mrad, 5 kN m/rad"));
  EXPECT_THAT(words("[elements.r]\ntype = \"stop\"\non = \"b\"\nat = [0, 0, 0]\naxis = \"z\"\nring = \"2.5 mm\"\n"
                    "stiffness = 3.5e5\nfriction = {coefficient = 0.12, stiffness = 4e5}\n" +
                    std::string("[elements.s]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\n"
                                "translation = [1e5, 1e5, 1e5]\nrotation = [1e3, 1e3, 1e3]\n")),
              testing::ElementsAre("law across its axis: gap stop: gap 2.5 mm, 350 kN/m",
                                   "around and along its wall: friction: up to 0.12 of the force that presses it, "
                                   "sticks with 400 kN/m"));
}

}  // namespace law_words_test
