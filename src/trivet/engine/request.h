// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace trivet::engine {

/// The value of a key as a command line, a page or Python has it: a text, perhaps with a unit, a number in SI, yes or
/// no, or a list of values.
struct Value : std::variant<std::string, double, bool, std::vector<Value>> {
  using variant::variant;
};

/// Keys of a command with their values; a repeatable key may be there several times.
using Keys = std::vector<std::pair<std::string, Value>>;

/// What is asked of a session.
struct Request {
  std::string command;           ///< "modes": a row of `commands()`
  std::string case_name = {};    ///< of a command of one case; empty: the base model
  Keys keys = {};                ///< of that row
  int threads = 0;               ///< at most so many; 0: all of the machine
  std::string before_keys = {};  ///< how messages name a key: "--" on a command line
  /// Once it is true, a search ends with the best design so far. Called on any thread; empty: never.
  std::function<bool()> ends_search = {};
  /// Once it is true, a study ends with what it has in its folder. Called on any thread; empty: never.
  std::function<bool()> ends_study = {};
};

}  // namespace trivet::engine
