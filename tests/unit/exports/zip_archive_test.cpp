// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/zip_archive.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "trivet/foundation/invalid_input.h"

namespace zip_archive_test {

using trivet::exports::ZipArchive;
using trivet::foundation::InvalidInput;

/// An independent reader of archives without extra fields and comments.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {
    const std::size_t end = bytes.size() - 22;
    if (number(end, 4) != 0x06054b50) throw std::runtime_error("no end of the directory");
    std::size_t at = number(end + 16, 4);
    for (std::size_t i = 0; i < number(end + 10, 2); ++i) at = read_entry(at);
    if (at != end) throw std::runtime_error("the directory does not end where it should");
  }
  std::vector<std::string> names;
  std::map<std::string, std::string> contents;
  std::map<std::string, std::size_t> methods;

 private:
  [[nodiscard]] std::size_t number(std::size_t at, int count) const {
    std::size_t value = 0;
    for (int i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_.at(at + i));
    return value;
  }

  std::size_t read_entry(std::size_t at) {
    if (number(at, 4) != 0x02014b50) throw std::runtime_error("no entry of the directory");
    const std::size_t method = number(at + 10, 2), crc = number(at + 16, 4), packed = number(at + 20, 4);
    const std::size_t size = number(at + 24, 4), length = number(at + 28, 2), file = number(at + 42, 4);
    const std::string name = bytes_.substr(at + 46, length);
    if (number(file, 4) != 0x04034b50 || bytes_.substr(file + 30, length) != name)
      throw std::runtime_error("the header of a file differs from its entry");
    const std::string content = unpacked(bytes_.substr(file + 30 + length, packed), method, size);
    if (crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())) != crc)
      throw std::runtime_error("wrong check sum");
    names.push_back(name);
    contents[name] = content;
    methods[name] = method;
    return at + 46 + length;
  }

  static std::string unpacked(std::string packed, std::size_t method, std::size_t size) {
    if (method == 0) return packed;
    std::string content(size, '\0');
    z_stream stream = {};
    inflateInit2(&stream, -15);
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(content.size());
    const int status = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    if (status != Z_STREAM_END || stream.avail_out != 0) throw std::runtime_error("wrong compressed data");
    return content;
  }

  const std::string& bytes_;
};

std::string noise(std::size_t size) {
  std::string text(size, '\0');
  std::uint32_t state = 1;
  for (char& character : text) {
    state = state * 1664525u + 1013904223u;
    character = static_cast<char>(state >> 24);
  }
  return text;
}

TEST(ZipArchive, GivesBackTheContentsInTheOrderInWhichTheyWereAdded) {
  const std::map<std::string, std::string> contents = {
      {"z.txt", std::string(300000, 'a')}, {"folder/ü.bin", noise(200000)}, {"a", ""}, {"zeros", std::string(5, '\0')}};
  ZipArchive archive;
  for (const char* name : {"z.txt", "folder/ü.bin", "a", "zeros"}) archive.add(name, contents.at(name));
  const std::string bytes = archive.bytes();
  const Reader reader(bytes);
  EXPECT_THAT(reader.names, testing::ElementsAre("z.txt", "folder/ü.bin", "a", "zeros"));
  EXPECT_EQ(reader.contents, contents);
  EXPECT_LT(bytes.size(), 205000u);
}

TEST(ZipArchive, CompressesOnlyWhatBecomesSmaller) {
  ZipArchive archive;
  archive.add("text", std::string(1000, 'x'));
  archive.add("noise", noise(1000));
  const std::string bytes = archive.bytes();
  EXPECT_THAT(Reader(bytes).methods,
              testing::UnorderedElementsAre(testing::Pair("text", 8), testing::Pair("noise", 0)));
}

TEST(ZipArchive, MayBeEmpty) {
  const std::string bytes = ZipArchive().bytes();
  EXPECT_EQ(bytes.size(), 22u);
  EXPECT_TRUE(Reader(bytes).names.empty());
}

TEST(ZipArchive, HasTheSameBytesForTheSameContents) {
  const auto bytes = [] {
    ZipArchive archive;
    archive.add("one", "1");
    archive.add("two", "22");
    return archive.bytes();
  };
  EXPECT_EQ(bytes(), bytes());
}

TEST(ZipArchive, RejectsNamesThatAreNoRelativePathsOrAreUsedTwice) {
  ZipArchive archive;
  archive.add("name", "");
  for (const char* name :
       {"", "/etc/passwd", "../up", "a//b", "a/./b", "folder/", "a\\b", "c:x", "line\nbreak", "name"})
    EXPECT_THROW(archive.add(name, "x"), InvalidInput) << name;
  EXPECT_NO_THROW(archive.add("names", "x"));
}

TEST(ZipArchive, RejectsContentsAbove4GB) {
  const std::string_view pretended("x", std::size_t{1} << 32);  // rejected before it is read
  ZipArchive archive;
  EXPECT_THROW(archive.add("large", pretended), InvalidInput);
  EXPECT_TRUE(Reader(archive.bytes()).names.empty());
}

}  // namespace zip_archive_test
