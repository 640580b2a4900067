// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/plain_text.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "trivet/foundation/message_list.h"

namespace plain_text_test {

using namespace trivet::foundation;

TEST(PlainText, ShowsControlCharactersAsEscapes) {
  EXPECT_EQ(on_one_line("a\x1b[31mb\n\tc"), "a\\x1b[31mb\\n\\x09c");
  EXPECT_EQ(on_one_line("a\xC2\x85z"), "a\\x85z");
  EXPECT_EQ(on_one_line("a\xE2\x80\xAEz"), "a\\u202ez");
  EXPECT_EQ(on_one_line("Größe 5 µm · ×"), "Größe 5 µm · ×");
}

TEST(PlainText, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(on_one_line("M\xFCller"), "M\\xfcller");
  EXPECT_EQ(on_one_line("Ger\xE4t"), "Ger\\xe4t");            // in UTF-8 this byte begins a three-byte character
  EXPECT_EQ(on_one_line("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // half of a surrogate pair
  EXPECT_EQ(on_one_line("\xC0\xAF"), "\\xc0\\xaf");           // overlong encoding of a slash
}

TEST(PlainText, IsShortenedBetweenCharacters) {
  EXPECT_EQ(shortened("жук", 6), "жук");
  EXPECT_EQ(shortened("жук", 3), "ж");
  EXPECT_EQ(quoted("жук", 5), "\"жу…\"");
  EXPECT_EQ(quoted("жук"), "\"жук\"");
}

TEST(PlainText, NamesWhatCannotBePrinted) {
  EXPECT_EQ(unprintable("front left — größer"), std::nullopt);
  EXPECT_EQ(unprintable("a\x1bz"), "the control character U+001B");
  EXPECT_EQ(unprintable("a\nz"), "the control character U+000A");
  EXPECT_EQ(unprintable("a\nz", false), std::nullopt);
  EXPECT_EQ(unprintable("M\xFCller"), "the byte FC, which is not UTF-8");
}

TEST(MessageList, HasAHundredMessagesErrorsFirstAndTheNumberOfTheRest) {
  Problems problems;
  for (int i = 0; i < 70; ++i) problems.warning("w" + std::to_string(i), "", "", "");
  for (int i = 0; i < 80; ++i) problems.error("e" + std::to_string(i), "", "", "");
  const Problems first = listed(problems);
  EXPECT_EQ(first.list().size(), most_messages);
  EXPECT_EQ(first.errors(), 80u);
  const std::string text = message_list(problems);
  EXPECT_EQ(std::ranges::count(text, '\n'), 101);
  EXPECT_THAT(text,
              testing::EndsWith("… and 50 more (0 errors, 50 warnings); correct what is listed and check again\n"));
}

TEST(MessageList, HasNoRestForAHundredMessages) {
  Problems problems;
  for (int i = 0; i < 100; ++i) problems.error("e", "", "", "");
  EXPECT_EQ(rest_of_list(problems), "");
}

}  // namespace plain_text_test
