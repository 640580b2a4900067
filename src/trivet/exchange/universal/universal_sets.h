// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_lines.h"

namespace trivet::exchange {

// Division of a universal file into its sets, each between two lines with -1.

struct TextLine {
  std::string_view text;
  int number = 0;
};

/// One set as it is in the file.
struct UniversalSet {
  int number = 0;  ///< place in the file, from 1
  int type = 0;    ///< 58 for example
  bool binary = false;
  int line = 0;                ///< number of the line with the type
  std::string_view type_line;  ///< "    58b     1     2          11        4096"
  std::string_view body;       ///< after the type line; of a binary set, to the end of the file
  bool closed = true;          ///< false if the file ends without the closing line of this set
};

/// Problems of one set. Their subject begins with the number and the type of the set.
class SetProblems {
 public:
  SetProblems(FileProblems& problems, const UniversalSet& set);
  void error(int line, const std::string& what, std::string finding, std::string rule, std::string remedy);
  /// Reports each `what` once per set.
  void warning(int line, const std::string& what, std::string finding, std::string rule, std::string remedy);
  [[nodiscard]] bool any() const { return errors_ > 0; }

 private:
  FileProblems& problems_;
  std::string name_;
  std::set<std::string> reported_;
  int errors_ = 0;
};

/// A line that opens or closes a set has only -1 in it, by the standard in columns 5 and 6.
[[nodiscard]] bool is_delimiter(std::string_view line);

/// Finds the sets of a universal file one after another. Lines between sets are comments and ignored.
class SetScanner {
 public:
  SetScanner(std::string_view bytes, FileProblems& problems) : rest_(bytes), problems_(problems) {}
  /// The next set, or nullopt at the end of the file.
  std::optional<UniversalSet> next();
  /// Continues after this number of bytes of the body of a binary set, which include its closing line.
  void continue_after(const UniversalSet& binary_set, std::size_t bytes_of_body);
  /// The first line that is not in a set.
  [[nodiscard]] const std::optional<TextLine>& first_comment() const { return first_comment_; }
  /// False if the file has no line with -1.
  [[nodiscard]] bool found_delimiter() const { return found_delimiter_; }

 private:
  std::string_view next_line();
  std::optional<UniversalSet> begin_set(std::string_view line);
  void find_end(UniversalSet& set, std::string_view opening);

  std::string_view rest_;
  FileProblems& problems_;
  int line_ = 0;
  int sets_ = 0;
  bool just_closed_ = false;
  bool found_delimiter_ = false;
  std::optional<TextLine> first_comment_;
};

// Records that sets 55 and 58 have in common: id lines and lines of numbers.

inline constexpr std::size_t universal_id_lines = 5;

/// One line of the head of a set.
struct HeadLine {
  std::string_view text;
  int line = 0;         ///< in the file
  std::size_t end = 0;  ///< bytes of the body up to the end of this line
};

/// The first lines of a set, at most `count`.
[[nodiscard]] std::vector<HeadLine> head_lines(const UniversalSet& set, std::size_t count);

/// The first `present` of the five id lines. Warns if some are missing or blank, or not UTF-8.
[[nodiscard]] std::array<std::string, universal_id_lines> read_ids(const std::vector<HeadLine>& head,
                                                                   std::size_t present, SetProblems& problems);

/// The numbers of one line of values: separated by blanks, or in columns if that fails, with a warning.
/// nullopt with an error if a number is missing or not finite.
[[nodiscard]] std::optional<std::vector<double>> values_of_line(std::string_view text, int line, FieldWidths widths,
                                                                SetProblems& problems);

}  // namespace trivet::exchange
