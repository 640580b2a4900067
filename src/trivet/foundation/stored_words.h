// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trivet::foundation {

/// Thrown by WordReader where a text is not what was stored.
class DamagedText : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes a text of numbers, each exactly, that is the same on every machine: words between spaces.
class StoredWords {
 public:
  void word(std::string_view name);  ///< without spaces
  void whole(std::uint64_t number);
  void exact(double number);          ///< its bits
  void text(std::string_view bytes);  ///< any bytes
  void end_line();

  [[nodiscard]] const std::string& words() const { return words_; }

 private:
  std::string words_;
};

/// Reads what StoredWords wrote, in the same order. @throws DamagedText where it is something else
class WordReader {
 public:
  /// @param words  lives as long as the reader
  explicit WordReader(std::string_view words) : rest_(words) {}

  void word(std::string_view name);
  [[nodiscard]] std::uint64_t whole();
  /// A whole number that is at most this: numbers of things to be read.
  [[nodiscard]] std::uint64_t at_most(std::uint64_t most);
  [[nodiscard]] double exact();
  [[nodiscard]] std::string text();
  /// Nothing else follows.
  void end();

 private:
  std::string_view next();
  std::string_view rest_;
};

}  // namespace trivet::foundation
