// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/stored_words.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace stored_words_test {

using trivet::foundation::DamagedText;
using trivet::foundation::StoredWords;
using trivet::foundation::WordReader;

TEST(StoredWords, AreReadAgainExactly) {
  StoredWords words;
  words.word("begin");
  words.whole(std::numeric_limits<std::uint64_t>::max());
  words.exact(-0.1);
  words.end_line();
  words.exact(std::numeric_limits<double>::quiet_NaN());
  words.text("two words\nand a line: 7 ");
  words.text("");
  words.whole(7);
  WordReader reader(words.words());
  reader.word("begin");
  EXPECT_EQ(reader.whole(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(reader.exact(), -0.1);
  EXPECT_TRUE(std::isnan(reader.exact()));
  EXPECT_EQ(reader.text(), "two words\nand a line: 7 ");
  EXPECT_EQ(reader.text(), "");
  EXPECT_EQ(reader.whole(), 7);
  reader.end();
}

TEST(WordReader, RejectsWhatWasNotStored) {
  EXPECT_THROW(static_cast<void>(WordReader("").whole()), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("-1").whole()), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("12x").whole()), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("99999999999999999999").whole()), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("6").at_most(5)), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("5 abc").text()), DamagedText);
  EXPECT_THROW(static_cast<void>(WordReader("18446744073709551615 abc").text()), DamagedText);
  EXPECT_THROW(WordReader("one").word("two"), DamagedText);
  EXPECT_THROW(WordReader(" 1").end(), DamagedText);
}

}  // namespace stored_words_test
