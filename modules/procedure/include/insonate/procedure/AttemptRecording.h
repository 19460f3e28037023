#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/procedure/RecordingProof.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace insonate {
namespace record {
struct BlockHead;
struct PlacedBlock;
}  // namespace record

/// Samples and events of about a second of an attempt.
struct Stretch {
  using Entry = std::variant<AttemptSample, AttemptEvent>;
  struct Happened {
    std::uint32_t afterSamples = 0;  ///< of this stretch
    AttemptEvent event;
  };
  std::vector<QuantisedSample> samples;
  std::vector<Happened> events;
  std::uint32_t samplesLost = 0;  ///< that the recorder had no room for, within this stretch or just before

  /// Passes on samples and events up to this time, in their order.
  void play(std::int64_t until_us, const std::function<void(const Entry&)>& take) const;
};

/// Tells whether a file begins like a recording, whatever follows. False if the file cannot be read.
bool beginsAsRecording(const std::filesystem::path& file);

/// A recorded attempt, complete or truncated. Parts that do not match the file's digests (format 4) are reported and
/// not read. Constant once it is open: any number of threads may read.
class AttemptRecording {
 public:
  /// Opens a file and finds its blocks, without unpacking them: milliseconds for an attempt of ten minutes. Fails if
  /// it is no recording, if its header cannot be read or was changed, or if a newer program wrote it.
  static Result<AttemptRecording> open(const std::filesystem::path& file);

  const AttemptHeader& header() const { return header_; }
  AttemptStatus status() const { return status_; }
  /// Sentences about missing parts: a truncated file, damaged blocks.
  const std::vector<std::string>& troubles() const { return troubles_; }
  /// Tells whether all blocks were found. Their contents are checked when they are unpacked.
  bool isWhole() const { return !damaged_; }

  /// Proof of the recording by the key of its nonce; without a key where that is not known or there is no nonce.
  RecordingProof proof(const std::optional<RecordKey>& key) const;

  /// The settings that held at a time, as in AttemptHeader::settings; "" where the recording has none. Fails where a
  /// change before is damaged, or cannot be ruled out.
  Result<std::string> settingsAt(std::int64_t time_us) const;
  /// The changes that can be read, in the order of their times.
  const std::vector<SettingsChange>& settingsChanges() const { return changes_; }

  std::int64_t end_us() const;  ///< time of the last sample or event; 0: there is none
  std::size_t stretches() const { return blocks_.size(); }
  /// The last stretch that begins at this time or before; the first, when none does. Of stretches() above 0.
  std::size_t stretchAt(std::int64_t time_us) const;
  /// Fails where the block is damaged.
  Result<Stretch> stretch(std::size_t index) const;

  /// Passes on everything up to this time, in order, as AttemptMetrics and ProcedureRun received it live. Fails if an
  /// earlier part is damaged, since results without it would be wrong.
  Result<void> play(std::int64_t until_us, const std::function<void(const Stretch::Entry&)>& take) const;
  /// Metrics as they stood after all that happened up to this time; the same as live, to the last bit. Fails as
  /// play() does.
  Result<MetricValues> metricsUntil(std::int64_t time_us = std::numeric_limits<std::int64_t>::max()) const;

 private:
  struct Block {
    std::int64_t first_us = 0, last_us = 0;
    std::size_t payload = 0, packedBytes = 0, rawBytes = 0;
    std::uint32_t checksum = 0;
    bool agrees = true;  ///< with the file's digests
  };
  struct Link {
    std::array<std::uint8_t, 32> digest{};
    std::optional<std::array<std::uint8_t, 32>> code{};
  };
  std::vector<record::PlacedBlock> findBlocks();
  Result<void> readHeader(const std::vector<record::PlacedBlock>& blocks);
  /// Checks the blocks against the links; removes blocks that were not written to their end.
  Result<void> checkLinks(std::vector<record::PlacedBlock>& blocks);
  void readBlock(const record::PlacedBlock& block);
  void readChange(const record::BlockHead& head, std::size_t payload, bool agrees);
  void checkEnd(const record::BlockHead& head, std::size_t payload);
  void reportProblems();

  std::string name_;
  std::vector<std::uint8_t> bytes_;
  bool isChained_ = false, damaged_ = false;
  bool missing_ = false;     ///< by the links a block may be gone
  std::string fault_;        ///< where links and blocks disagree, a sentence; "": nowhere
  std::vector<Link> links_;  ///< in the order of their blocks
  AttemptHeader header_;
  AttemptStatus status_ = AttemptStatus::CutShort;
  std::vector<std::string> troubles_;
  std::vector<Block> blocks_;
  std::vector<SettingsChange> changes_;
  std::optional<std::int64_t> unknownFrom_us_;  ///< settings that may have changed in what is damaged
};

}  // namespace insonate
