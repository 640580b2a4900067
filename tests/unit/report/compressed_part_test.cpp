// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "trivet/report/page/compressed_part.h"

namespace compressed_part_test {

using namespace trivet;
using ::testing::HasSubstr;

/// Readable zeros without memory.
class Zeros {
 public:
  explicit Zeros(std::size_t size)
      : size_(size), at_(mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {}
  ~Zeros() { munmap(at_, size_); }
  Zeros(const Zeros&) = delete;
  Zeros& operator=(const Zeros&) = delete;
  [[nodiscard]] bool exist() const { return at_ != MAP_FAILED; }
  [[nodiscard]] std::string_view text() const { return {static_cast<const char*>(at_), size_}; }

 private:
  std::size_t size_;
  void* at_;
};

TEST(CompressedPart, ATextThatZlibCannotCountIsRefusedNotCut) {
  const Zeros zeros((std::size_t{1} << 32) + 5);
  ASSERT_TRUE(zeros.exist());
  try {
    (void)report::compressed_part(zeros.text());
    FAIL() << "the text was cut";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("4294967301 bytes, cannot be compressed: it has more than 4294967295"));
  }
}

}  // namespace compressed_part_test
