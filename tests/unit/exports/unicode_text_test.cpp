// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/unique_names.h"

#include <gmock/gmock.h>

namespace unicode_text_test {

using trivet::exports::code_points;
using trivet::exports::utf16;

TEST(UnicodeText, HasOneCodePointPerCharacter) {
  EXPECT_EQ(code_points("aé∞\xF0\x9F\x9A\x82"), (std::u32string{U'a', U'é', U'∞', U'\U0001F682'}));
}

TEST(UnicodeText, ReplacesBytesThatAreNone) {
  EXPECT_EQ(code_points("\xff"), U"\ufffd");
  EXPECT_EQ(code_points("a\xe2\x88"), U"a\ufffd\ufffd");            // cut
  EXPECT_EQ(code_points("\xc3z"), (std::u32string{0xfffd, U'z'}));  // the second byte is no continuation
}

TEST(UnicodeText, WritesPairsBeyondSixteenBits) {
  EXPECT_EQ(utf16("é\xF0\x9F\x9A\x82"), (std::u16string{u'é', 0xd83d, 0xde82}));
}

}  // namespace unicode_text_test
