// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trivet/foundation/stored_words.h"

namespace trivet::study {

/// Designs of a study in numbered chunks of equal size; the last one may be smaller.
struct StudyChunks {
  std::uint64_t designs = 0, size = 1;

  [[nodiscard]] std::uint64_t count() const { return (designs + size - 1) / size; }
  [[nodiscard]] std::uint64_t first(std::uint64_t chunk) const { return chunk * size; }
  [[nodiscard]] std::uint64_t designs_of(std::uint64_t chunk) const;
};

/// Chunks of whole pieces, as few of them as pieces, at most 65,536: their finished ones are a bit each in a file.
/// @param piece  designs that are judged at once
[[nodiscard]] StudyChunks study_chunks(std::uint64_t designs, std::uint64_t piece);

/// A set of chunks by their numbers.
class ChunkSet {
 public:
  explicit ChunkSet(std::uint64_t chunks = 0) : holds_(chunks) {}

  [[nodiscard]] std::uint64_t chunks() const { return holds_.size(); }  ///< that it may hold
  [[nodiscard]] std::uint64_t size() const { return size_; }            ///< that it holds
  [[nodiscard]] bool holds(std::uint64_t chunk) const { return holds_[chunk]; }
  void add(std::uint64_t chunk);
  /// Both of as many chunks.
  void add(const ChunkSet& other);
  [[nodiscard]] bool overlaps(const ChunkSet& other) const;
  bool operator==(const ChunkSet&) const = default;

  /// As a word of hexadecimal digits, four chunks each.
  void store(foundation::StoredWords& words) const;
  /// @throws foundation::DamagedText
  [[nodiscard]] static ChunkSet restored(foundation::WordReader& words, std::uint64_t most_chunks);

 private:
  std::vector<bool> holds_;
  std::uint64_t size_ = 0;
};

inline constexpr std::uint64_t most_chunks = 65'536;

}  // namespace trivet::study
