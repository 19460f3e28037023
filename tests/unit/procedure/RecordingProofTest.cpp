#include "record/Chain.h"
#include "record/HeaderText.h"
#include "support/TestData.h"
#include "unit/procedure/HandMotion.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <random>
#include <thread>

namespace insonate {
namespace {

using record::BlockHead;
using record::BlockKind;
using record::Bytes;
using testing::HasSubstr;

RecordKey keyOf(std::uint8_t first) {
  RecordKey key;
  std::iota(key.begin(), key.end(), first);
  return key;
}

std::string hexOf(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

/// Values of Python's hashlib.blake2b(digest_size=32).
TEST(Chain, IsBlake2bOverAllThatWasBefore) {
  record::ChainWriter chain(keyOf(0));
  chain.linked({'a', 'b', 'c'});
  const Bytes second = chain.linked({'d', 'e'});
  const auto head = record::headAt(std::span(second).subspan(2));
  ASSERT_TRUE(head);
  EXPECT_EQ(head->kind, BlockKind::Link);
  const auto link = record::unpacked(std::span(second).subspan(2 + BlockHead::kBytes), head->rawBytes, head->checksum);
  ASSERT_TRUE(link);
  EXPECT_EQ(hexOf(*link),
            "f1e21613836f52113fddd2c7493f5b097475cef09552e1aa5e248c7226af1010"
            "d4709a47d2982dfa282ca668b7010cc999ff3b1b86ce61cfe70231b8e7c67c30");
}

/// A recording of 6 s of noisy hands for an attempt of a store, and what somebody makes of it.
class RecordingProofTest : public testing::Test {
 protected:
  static AttemptHeader header() {
    AttemptHeader header;
    header.software = "insonate", header.begun = "2026-01-02T03:04:05Z", header.picture.sliceHalf_mm = 1;
    header.settings = "as it began";
    header.recordedFor = {"an attempt", "a person", "central_line", 2, "first", "a nonce"};
    return header;
  }

  void record(const std::string& name, const AttemptHeader& head, const std::optional<RecordKey>& with,
              AttemptStatus status = AttemptStatus::Completed) {
    auto recorder = AttemptRecorder::start(folder / name, head, nullptr, with);
    ASSERT_TRUE(recorder) << recorder.error().message;
    for (const AttemptSample& sample : test::handMotion(6000)) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      (*recorder)->record(sample);
    }
    (*recorder)->recordFromOtherThread(SettingsChange{3'000'000, "changed"});
    ASSERT_TRUE((*recorder)->finish(status));
  }
  void SetUp() override {
    record("whole", header(), key);
    bytes = test::bytesOf(folder / "whole");
  }

  /// The blocks, their links left out.
  std::vector<Bytes> blocks() const {
    const std::span all(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    std::vector<Bytes> found;
    for (std::size_t at = 0; at < all.size();) {
      const auto head = record::headAt(all.subspan(at));
      const std::size_t size = BlockHead::kBytes + head->packedBytes;
      if (head->kind != BlockKind::Link) found.emplace_back(all.begin() + at, all.begin() + at + size);
      at += size;
    }
    return found;
  }
  static Bytes headerBlock(const std::string& text) {
    return record::packed(BlockKind::Header, 0, 0, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  RecordingProof proofWith(std::string_view changed) const {
    std::ofstream(folder / "changed", std::ios::binary | std::ios::trunc) << changed;
    return proofOf(folder / "changed", key);
  }
  /// With digests that agree, and codes of `with`.
  RecordingProof proofLinked(const std::vector<Bytes>& blocks, const std::optional<RecordKey>& with) const {
    record::ChainWriter chain(with);
    std::string all;
    for (const Bytes& block : blocks) {
      const Bytes linked = chain.linked(block);
      all.append(linked.begin(), linked.end());
    }
    return proofWith(all);
  }

  const test::TemporaryFolder folder;
  const std::optional<RecordKey> key = keyOf(7);
  std::string bytes;
};

TEST_F(RecordingProofTest, WhatTheRecorderWroteIsProven) {
  const RecordingProof proof = proofOf(folder / "whole", key);
  EXPECT_EQ(proof.state, ProofState::Proven) << proof.why;
  EXPECT_EQ(proof.why, "");
  EXPECT_EQ(AttemptRecording::open(folder / "whole")->header().recordedFor, header().recordedFor);
  record("given up", header(), key, AttemptStatus::Abandoned);
  EXPECT_EQ(proofOf(folder / "given up", key).state, ProofState::Proven);
}

/// Fifty places over the file, and each byte of the header, of a link and of the end.
TEST_F(RecordingProofTest, NoWrongByteIsTakenWithoutAWord) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < 50; ++i) places.push_back(i * (bytes.size() - 1) / 49);
  const std::size_t headAndLink = blocks().front().size() + 150, end = bytes.size() - 300;
  for (std::size_t at = 0; at < headAndLink; ++at) places.push_back(at);
  for (std::size_t at = end; at < bytes.size(); ++at) places.push_back(at);
  for (const bool isKnown : {true, false}) {
    for (const std::size_t at : places) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ 4);
      std::ofstream(folder / "changed", std::ios::binary | std::ios::trunc) << changed;
      const auto recording = AttemptRecording::open(folder / "changed");
      if (!recording) {
        EXPECT_THAT(recording.error().message, HasSubstr((folder / "changed").string())) << at;
        continue;
      }
      EXPECT_FALSE(recording->errors().empty()) << "byte " << at;
      EXPECT_NE(recording->proof(isKnown ? key : std::nullopt).state, ProofState::Proven) << "byte " << at;
    }
  }
}

/// With a checksum that fits, as a program makes it.
TEST_F(RecordingProofTest, AChangedBlockIsNamedByItsTime) {
  auto all = blocks();
  const auto recording = AttemptRecording::open(folder / "whole");
  const Bytes other = record::packed(BlockKind::Settings, 3'000'000, 3'000'000, Bytes{'x'});
  std::string changed = bytes;
  const auto settings =
      std::ranges::find_if(all, [](const Bytes& block) { return record::headAt(block)->kind == BlockKind::Settings; });
  ASSERT_NE(settings, all.end());
  const std::size_t at = changed.find(std::string(settings->begin(), settings->end()));
  changed.replace(at, settings->size(), std::string(other.begin(), other.end()));
  const RecordingProof proof = proofWith(changed);
  EXPECT_EQ(proof.state, ProofState::Broken);
  EXPECT_THAT(proof.why, HasSubstr("was changed or damaged after it was recorded, at 3.0 s"));
  const auto opened = AttemptRecording::open(folder / "changed");
  EXPECT_THAT(opened->settingsAt(4'000'000).error().message, HasSubstr("are not known"));
  EXPECT_EQ(opened->metricsUntil(), *recording->metricsUntil());
}

TEST_F(RecordingProofTest, AnotherStretchIsRefused) {
  auto all = blocks();
  const auto second = all.begin() + 2;
  const BlockHead head = *record::headAt(*second);
  const Bytes raw = *record::unpacked(std::span(*second).subspan(BlockHead::kBytes), head.rawBytes, head.checksum);
  Bytes quieter(raw);
  quieter.back() ^= 1;
  const Bytes other = record::packed(BlockKind::RecordingSegment, head.first_us, head.last_us, quieter);
  std::string changed = bytes;
  const std::size_t at = changed.find(std::string(second->begin(), second->end()));
  changed.replace(at, second->size(), std::string(other.begin(), other.end()));
  EXPECT_EQ(proofWith(changed).state, ProofState::Broken);
  const auto recording = AttemptRecording::open(folder / "changed");
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_FALSE(recording->metricsUntil());
  int refused = 0;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) refused += !recording->segment(i);
  EXPECT_EQ(refused, 1) << "the others can be read";
  ASSERT_EQ(recording->errors().size(), 1u);
  EXPECT_THAT(recording->errors()[0], HasSubstr("Metrics are not computed"));
}

/// Another date, another person, no mark of the script; all checksums and digests are computed anew.
TEST_F(RecordingProofTest, ARewrittenHeadIsFoundByTheCodes) {
  std::vector<AttemptHeader> others(4, header());
  others[0].begun = "2026-02-02T03:04:05Z";
  others[1].recordedFor.person = "another person";
  others[2].recordedFor.level = "second";
  others[3].caseHash = "beef";
  for (const AttemptHeader& other : others) {
    auto all = blocks();
    all.front() = headerBlock(record::textOf(other));
    EXPECT_EQ(proofLinked(all, std::nullopt).state, ProofState::Broken) << "without codes";
    const RecordingProof forged = proofLinked(all, keyOf(8));
    EXPECT_EQ(forged.state, ProofState::Broken);
    EXPECT_THAT(forged.why, HasSubstr("its codes are not those of the store"));
    EXPECT_TRUE(AttemptRecording::open(folder / "changed")->errors().empty()) << "the digests agree";
  }
  std::string headOnly = bytes;
  const auto front = blocks().front();
  const Bytes other = headerBlock(record::textOf(others[0]));
  headOnly.replace(0, front.size(), std::string(other.begin(), other.end()));
  EXPECT_THAT(proofWith(headOnly).why, HasSubstr("its header does not agree"));
}

TEST_F(RecordingProofTest, AScriptsHandsStayADemonstration) {
  AttemptHeader scripted = header();
  scripted.isScripted = true;
  record("scripted", scripted, key);
  EXPECT_EQ(proofOf(folder / "scripted", key).state, ProofState::Demonstration);
  bytes = test::bytesOf(folder / "scripted");
  auto all = blocks();
  all.front() = headerBlock(record::textOf(header()));
  EXPECT_EQ(proofLinked(all, std::nullopt).state, ProofState::Broken);
}

/// The harm of the last second is cut out, in the middle or at the end.
TEST_F(RecordingProofTest, ASecondThatIsCutOutIsFound) {
  auto all = blocks();
  all.erase(all.end() - 2);
  EXPECT_EQ(proofLinked(all, std::nullopt).state, ProofState::Broken);
  std::string cut = bytes;
  const Bytes last = *(blocks().end() - 2), end = blocks().back();
  const std::size_t at = cut.find(std::string(last.begin(), last.end()));
  cut.erase(at, cut.find(std::string(end.begin(), end.end())) - at);
  EXPECT_EQ(proofWith(cut).state, ProofState::Broken);
  EXPECT_FALSE(AttemptRecording::open(folder / "changed")->metricsUntil());
}

/// Bytes taken out, put in twice, moved to the end or written over, at any place.
TEST_F(RecordingProofTest, WhateverIsDoneToTheFileItIsNotProven) {
  std::mt19937 random(11);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  for (int i = 0; i < 200; ++i) {
    const std::size_t at = below(bytes.size()), size = 1 + below(std::min<std::size_t>(bytes.size() - at, 3000));
    const std::string piece = bytes.substr(at, size);
    std::string changed = bytes;
    switch (i % 4) {
      case 0:
        changed.erase(at, size);
        break;
      case 1:
        changed.insert(below(bytes.size()), piece);
        break;
      case 2:
        changed += piece;
        break;
      default:
        for (std::size_t k = 0; k < size; ++k) changed[at + k] = static_cast<char>(random());
    }
    if (changed != bytes) {
      EXPECT_NE(proofWith(changed).state, ProofState::Proven) << i << ": " << size << " bytes at " << at;
    }
  }
}

/// A block without its link, a link that comes twice, and whatever follows the end.
TEST_F(RecordingProofTest, EachBlockHasOneLinkAndTheEndIsTheEnd) {
  const std::string mark(record::kMark.begin(), record::kMark.end());
  std::vector<std::size_t> heads;
  for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1)) heads.push_back(at);
  const std::string link = bytes.substr(heads[3], heads[4] - heads[3]), last = bytes.substr(heads.back());
  std::string without = bytes, twice = bytes;
  without.erase(heads[3], link.size());
  twice.insert(heads[4], link);
  for (const std::string& changed : {without, twice, bytes + last, bytes + "x", bytes + mark}) {
    EXPECT_EQ(proofWith(changed).state, ProofState::Broken);
    EXPECT_FALSE(AttemptRecording::open(folder / "changed")->errors().empty());
  }
}

TEST_F(RecordingProofTest, ACutFileProvesNothingOfItsEnd) {
  for (const std::size_t missing : {std::size_t{1}, std::size_t{100}, bytes.size() / 2}) {
    const RecordingProof proof = proofWith(std::string_view(bytes).substr(0, bytes.size() - missing));
    EXPECT_EQ(proof.state, ProofState::Unproven) << missing;
    EXPECT_THAT(proof.why, HasSubstr("stopped early"));
  }
  EXPECT_EQ(AttemptRecording::open(folder / "changed")->status(), AttemptStatus::CutShort);
}

TEST_F(RecordingProofTest, WithoutAStoreThereIsNoProof) {
  AttemptHeader free = header();
  free.recordedFor = {};
  record("free", free, std::nullopt);
  EXPECT_THAT(proofOf(folder / "free", std::nullopt).why, HasSubstr("without a store of attempts"));
  EXPECT_EQ(proofOf(folder / "free", key).state, ProofState::Unproven);
  EXPECT_THAT(proofOf(folder / "whole", std::nullopt).why, HasSubstr("for another store"));
  EXPECT_EQ(proofOf(folder / "none", key).state, ProofState::Broken);
}

TEST_F(RecordingProofTest, FormatThreeIsReadAndProvesNothing) {
  std::string text = record::textOf(header());
  text.replace(text.find("\"format\":5"), 10, "\"format\":3");
  auto all = blocks();
  all.front() = headerBlock(text);
  std::string old;
  for (const Bytes& block : all) old.append(block.begin(), block.end());
  const RecordingProof proof = proofWith(old);
  EXPECT_EQ(proof.state, ProofState::Unproven);
  EXPECT_THAT(proof.why, HasSubstr("by an earlier version of the program"));
  const auto recording = AttemptRecording::open(folder / "changed");
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_TRUE(recording->errors().empty());
  EXPECT_EQ(recording->metricsUntil(), *AttemptRecording::open(folder / "whole")->metricsUntil());
  EXPECT_EQ(recording->settingsAt(4'000'000), "changed");
}

}  // namespace
}  // namespace insonate
