// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/chunk_set.h"

#include <algorithm>
#include <string>

namespace trivet::study {
namespace {

/// Merging the counts of a chunk takes as long as judging some designs by kernels.
constexpr std::uint64_t most_pieces_of_small_chunk = 4;
constexpr std::uint64_t fewest_chunks = 64;

constexpr std::string_view digits = "0123456789abcdef";

}  // namespace

std::uint64_t StudyChunks::designs_of(std::uint64_t chunk) const { return std::min(size, designs - first(chunk)); }

StudyChunks study_chunks(std::uint64_t designs, std::uint64_t piece) {
  const auto pieces_for = [&](std::uint64_t chunks) {
    return std::max<std::uint64_t>(1, (designs + chunks * piece - 1) / (chunks * piece));
  };
  return {designs,
          piece * std::max(pieces_for(most_chunks), std::min(most_pieces_of_small_chunk, pieces_for(fewest_chunks)))};
}

void ChunkSet::add(std::uint64_t chunk) {
  size_ += holds_[chunk] ? 0 : 1;
  holds_[chunk] = true;
}

void ChunkSet::add(const ChunkSet& other) {
  for (std::uint64_t chunk = 0; chunk < chunks(); ++chunk)
    if (other.holds(chunk)) add(chunk);
}

bool ChunkSet::overlaps(const ChunkSet& other) const {
  for (std::uint64_t chunk = 0; chunk < chunks(); ++chunk)
    if (holds(chunk) && other.holds(chunk)) return true;
  return false;
}

void ChunkSet::store(foundation::StoredWords& words) const {
  words.whole(chunks());
  std::string bits((chunks() + 3) / 4, '0');
  for (std::uint64_t digit = 0; digit < bits.size(); ++digit) {
    unsigned value = 0;
    for (unsigned bit = 0; bit < 4 && 4 * digit + bit < chunks(); ++bit)
      if (holds(4 * digit + bit)) value |= 1u << bit;
    bits[digit] = digits[value];
  }
  words.text(bits);
}

ChunkSet ChunkSet::restored(foundation::WordReader& words, std::uint64_t most_chunks) {
  ChunkSet set(words.at_most(most_chunks));
  const std::string bits = words.text();
  if (bits.size() != (set.chunks() + 3) / 4) throw foundation::DamagedText("a set of chunks has another size");
  for (std::uint64_t digit = 0; digit < bits.size(); ++digit) {
    const std::size_t value = digits.find(bits[digit]);
    if (value == std::string_view::npos) throw foundation::DamagedText("a set of chunks has a wrong digit");
    for (unsigned bit = 0; bit < 4; ++bit) {
      if ((value >> bit & 1) == 0) continue;
      if (4 * digit + bit >= set.chunks()) throw foundation::DamagedText("a chunk is beyond the last one");
      set.add(4 * digit + bit);
    }
  }
  return set;
}

}  // namespace trivet::study
