// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/viscoelastic.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace trivet::elements {
namespace {

using Complex = std::complex<double>;

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

/// x/(1 + x) without overflow for large x.
Complex share(Complex x) { return std::abs(x) > 1 ? 1.0 / (1.0 + 1.0 / x) : x / (1.0 + x); }

Complex prony(const std::vector<double>& ratios, const std::vector<double>& times, Complex s) {
  Complex sum = 0;
  for (std::size_t i = 0; i < ratios.size(); ++i) sum += ratios[i] * share(s * times[i]);
  return sum;
}

class Check {
 public:
  void time(const std::string& key, double value) {
    if (!(value > 0) || !std::isfinite(value))
      problems_.error(key, fmt::format("{} = {:.6g} s", key, value), "a relaxation time must be > 0",
                      "give the time in seconds");
    constexpr double shortest = 1e-12, longest = 1e9;  // period of atomic vibration; 30 years
    if (value > 0 && std::isfinite(value) && (value < shortest || value > longest))
      problems_.error(key, fmt::format("{} = {:.6g} s", key, value),
                      "a relaxation time must be between 1e-12 and 1e9 s",
                      "check the unit; a spring without relaxation does not need this law");
  }
  void ratio(const std::string& key, double value) {
    if (!(value >= 0) || !std::isfinite(value))
      problems_.error(key, fmt::format("{} = {:.6g}", key, value),
                      "a stiffness ratio must be ≥ 0, or the element would create energy",
                      "give branch stiffness over long-term stiffness");
    constexpr double largest = 1e6;  // glassy over rubbery stiffness of polymers is about 1e3
    if (std::isfinite(value) && value > largest)
      problems_.error(key, fmt::format("{} = {:.6g}", key, value),
                      "a stiffness ratio is at most 1e6; polymers have up to 1e3", "check the number");
  }
  void order(double value) {
    if (!(value > 0 && value <= 1))
      problems_.error("order", fmt::format("order = {:.6g}", value), "the fractional order must be in (0, 1]",
                      "filled rubber has about 0.3 … 0.7");
  }
  void branches(const GeneralizedMaxwell& law) {
    constexpr std::size_t most = 100;  // a branch for each tenth of a decade over ten decades
    if (law.ratios.size() > most || law.times.size() > most) {
      problems_.error("ratios", fmt::format("{} branches", std::max(law.ratios.size(), law.times.size())),
                      "a generalized Maxwell law has at most 100", "one or two for each decade of time are usual");
      return;
    }
    if (law.ratios.empty())
      problems_.error("ratios", "no ratios", "a generalized Maxwell law has at least one branch",
                      "give ratios and times");
    if (law.ratios.size() != law.times.size())
      problems_.error("times", fmt::format("{} times for {} ratios", law.times.size(), law.ratios.size()),
                      "each branch has one ratio and one time", "make both lists equally long");
    for (std::size_t i = 0; i < law.ratios.size(); ++i) ratio(fmt::format("ratios[{}]", i), law.ratios[i]);
    for (std::size_t i = 0; i < law.times.size(); ++i) time(fmt::format("times[{}]", i), law.times[i]);
  }
  foundation::Problems release_problems() { return std::move(problems_); }

 private:
  foundation::Problems problems_;
};

}  // namespace

Complex relative_modulus(const Viscoelastic& law, Complex angular_frequency) {
  const Complex s = Complex(0, 1) * angular_frequency;
  return std::visit(Overloaded{[&](const KelvinVoigt& l) { return 1.0 + s * l.time; },
                               [&](const Zener& l) { return 1.0 + l.ratio * share(s * l.time); },
                               [&](const GeneralizedMaxwell& l) { return 1.0 + prony(l.ratios, l.times, s); },
                               [&](const FractionalZener& l) {
                                 return s == 0.0 ? Complex(1) : 1.0 + l.ratio * share(std::pow(s * l.time, l.order));
                               }},
                    law);
}

Complex relative_modulus(const RationalForm& form, Complex angular_frequency) {
  const Complex s = Complex(0, 1) * angular_frequency;
  return 1.0 + form.viscous_time * s + prony(form.ratios, form.times, s);
}

foundation::Problems check(const Viscoelastic& law) {
  Check check;
  std::visit(Overloaded{[&](const KelvinVoigt& l) { check.time("time", l.time); },
                        [&](const Zener& l) { check.ratio("ratio", l.ratio), check.time("time", l.time); },
                        [&](const GeneralizedMaxwell& l) { check.branches(l); },
                        [&](const FractionalZener& l) {
                          check.ratio("ratio", l.ratio), check.time("time", l.time), check.order(l.order);
                        }},
             law);
  return check.release_problems();
}

std::string name(const Viscoelastic& law) {
  const char* names[] = {"Kelvin–Voigt", "Zener", "generalized Maxwell", "fractional Zener"};
  return names[law.index()];
}

std::string law_description(const Viscoelastic& law) {
  const std::string numbers =
      std::visit(Overloaded{[](const KelvinVoigt& l) { return fmt::format("time {:.6g} s", l.time); },
                            [](const Zener& l) { return fmt::format("ratio {:.6g}, time {:.6g} s", l.ratio, l.time); },
                            [](const GeneralizedMaxwell& l) {
                              return fmt::format("ratios {:.6g}, times {:.6g} s", fmt::join(l.ratios, " "),
                                                 fmt::join(l.times, " "));
                            },
                            [](const FractionalZener& l) {
                              return fmt::format("ratio {:.6g}, time {:.6g} s, order {:.6g}", l.ratio, l.time, l.order);
                            }},
                 law);
  return name(law) + ", " + numbers;
}

}  // namespace trivet::elements
