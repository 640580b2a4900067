// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/projects.h"
#include "trivet/study/sample/sample_manifest.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/stored_tally.h"
#include "trivet/study/shared/part_file.h"
#include "trivet/study/shared/study_manifest.h"

namespace trivet {
namespace study_files_test {

using study::ChunkSet;
using study::PartRecord;
using study::StudyChunks;
using study::StudyManifest;
using study::StudyPart;

TEST(StudyChunks, CoverAllDesignsInWholePieces) {
  for (const std::uint64_t piece : {8, 120})
    for (const std::uint64_t designs : {100ull, 119ull, 20'000ull, 1'000'000ull, 999'999'999ull}) {
      const StudyChunks chunks = study::study_chunks(designs, piece);
      EXPECT_EQ(chunks.size % piece, 0);
      EXPECT_LE(chunks.count(), study::most_chunks);
      const std::uint64_t last = chunks.count() - 1;
      EXPECT_EQ(chunks.first(last) + chunks.designs_of(last), designs);
      EXPECT_GT(chunks.designs_of(last), 0);
    }
}

TEST(ChunkSet, IsTheSameFromItsWords) {
  ChunkSet set(70), other(70);
  for (const std::uint64_t chunk : {0, 3, 4, 63, 64, 69}) set.add(chunk);
  set.add(3);
  other.add(5);
  EXPECT_EQ(set.size(), 6);
  EXPECT_FALSE(set.overlaps(other));
  other.add(set);
  EXPECT_TRUE(set.overlaps(other));
  EXPECT_EQ(other.size(), 7);
  foundation::StoredWords words;
  set.store(words);
  foundation::WordReader reader(words.words());
  EXPECT_EQ(ChunkSet::restored(reader, 70), set);
  for (const char* damaged : {"70 2 ff", "70 18 00000000000000000f", "8 2 fg", "71 18 000000000000000000", "9 3 ff2"}) {
    foundation::WordReader wrong(damaged);
    EXPECT_THROW(static_cast<void>(ChunkSet::restored(wrong, 70)), foundation::DamagedText) << damaged;
  }
}

TEST(StudyPart, HasEachChunkOnce) {
  for (std::uint64_t chunk = 0; chunk < 20; ++chunk) {
    int parts = 0;
    for (std::uint64_t number = 1; number <= 7; ++number) parts += StudyPart{number, 7}.has(chunk) ? 1 : 0;
    EXPECT_EQ(parts, 1);
  }
  EXPECT_EQ(StudyPart::of_file((StudyPart{3, 64}).file_name()), (StudyPart{3, 64}));
  for (const char* other : {"part-0-of-3", "part-4-of-3", "part-03-of-3", "part-1-of-3.new", "part-1", "study.txt"})
    EXPECT_FALSE(StudyPart::of_file(other)) << other;
}

TEST(PartRecord, IsReadOnlyUndamaged) {
  PartRecord record{.study = "a hash", .written_at = 7, .computed = 960, .has_ended = true, .chunks = ChunkSet(9)};
  record.chunks.add(8);
  record.results = "1 2\n3 sha256: 4";
  const std::string text = record.text();
  const auto found = PartRecord::read(text);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text(), text);
  EXPECT_EQ(found->results, record.results);
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_FALSE(PartRecord::read(text.substr(0, i))) << i;
    std::string other = text;
    other[i] = static_cast<char>(other[i] ^ 1);
    EXPECT_FALSE(PartRecord::read(other)) << i;
  }
}

TEST(StudyManifest, IsTheSameFromItsTextAndStatesDifferences) {
  const StudyManifest manifest{{{"seed", "1"}, {"settings", "a: 1\nb"}, {"file \"x\"", std::string(64, 'a')}},
                               study::FixedBySample{{1000, 120}, {{{0.1, 0.01}, {1, 1}}, {}}}.text()};
  const auto found = StudyManifest::read(manifest.text());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text(), manifest.text());
  EXPECT_EQ(found->hash(), manifest.hash());
  EXPECT_EQ(found->identity, manifest.identity);
  const auto fixed = study::FixedBySample::read(found->fixed);
  ASSERT_TRUE(fixed);
  EXPECT_EQ(fixed->chunks.size, 120);
  EXPECT_EQ(fixed->text(), manifest.fixed);
  EXPECT_FALSE(study::FixedBySample::read(""));  // of a command without chunks
  EXPECT_FALSE(StudyManifest::read(manifest.text() + " "));
  EXPECT_EQ(study::identity_differences(manifest.identity, found->identity), "");
  EXPECT_EQ(study::identity_differences(manifest.identity,
                                        {{"seed", "2"}, {"settings", ""}, {"file \"x\"", std::string(64, 'b')}}),
            "seed: 1 there, 2 here; settings: a: 1\nb there, none here; the file \"x\" has another content there");
}

/// Two masses in a row under a force.
const std::string machine = test::driven_pair() + R"(
[analyses]
response = {of = ["m1.x", "m2.x"]}
sample = {designs = 960}
[tolerances.rubber]
path = ["elements.k1.scale", "elements.k2.scale"]
half_width = "15 %"
[requirements]
limits = {"m1.x" = "2.2 mm", "m2.x" = "3.6 mm"}
)";

TEST(StoredTally, OfPartsIsThatOfAllDesigns) {
  const project::Project project = test::project(machine);
  const study::SampleRun run(project);
  const study::SampleMagnitudes magnitudes = run.first_designs({}).magnitudes;
  const auto words = [](const study::SampleTally& tally) {
    foundation::StoredWords stored;
    study::store_tally(tally, stored);
    return stored.words();
  };
  study::SampleTally all = run.empty_tally(magnitudes), merged = run.empty_tally(magnitudes);
  run.count(0, 960, all);
  for (const std::uint64_t first : {480, 0, 240, 720}) {
    study::SampleTally part = run.empty_tally(magnitudes), restored = run.empty_tally(magnitudes);
    run.count(first, 240, part);
    const std::string stored = words(part);
    foundation::WordReader reader(stored);
    study::restore_tally(reader, restored);
    reader.end();
    merged.merge(restored);
  }
  EXPECT_EQ(merged.met, all.met);
  EXPECT_EQ(merged.least, all.least);
  EXPECT_EQ(merged.of[0][1].margins, all.of[0][1].margins);
  EXPECT_EQ(merged.of[0][1].values, all.of[0][1].values);
  EXPECT_EQ(merged.of[0][1].squares, all.of[0][1].squares);
  foundation::WordReader wrong("3 1 2 3");
  EXPECT_THROW(study::restore_tally(wrong, merged), foundation::DamagedText);
}

}  // namespace study_files_test
}  // namespace trivet
