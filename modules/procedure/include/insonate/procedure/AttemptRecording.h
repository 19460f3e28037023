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

/// A part of a recording: the samples and events of about one second, stored in one block of the file.
struct RecordingSegment {
  using Entry = std::variant<AttemptSample, AttemptEvent>;
  struct PlacedEvent {
    std::uint32_t afterSamples = 0;  ///< number of samples of this segment that precede the event
    AttemptEvent event;
  };
  std::vector<QuantizedSample> samples;
  std::vector<PlacedEvent> events;
  /// Number of samples that were lost in this segment or just before it because the recorder's queue was full.
  std::uint32_t samplesLost = 0;

  /// Calls `take` with each sample and event up to the time `until_us`, in their order.
  void play(std::int64_t until_us, const std::function<void(const Entry&)>& take) const;
};

/// Tells whether a file begins with the signature of a recording; the rest of the file is not checked. Returns false if
/// the file cannot be read.
bool hasRecordingSignature(const std::filesystem::path& file);

/// Reads the recording of an attempt, complete or truncated. Blocks that do not match the digests in the file (format
/// 4) are reported and not read. An object is constant after open(); any number of threads may use it.
class AttemptRecording {
 public:
  /// Opens a recording and finds its blocks, without decompressing them; takes milliseconds for an attempt of ten
  /// minutes. Fails if the file is not a recording, if its header cannot be read or was changed, if its settings are
  /// too large (4 MB at one time, 256 MB together), or if a newer version of the program wrote the file.
  static Result<AttemptRecording> open(const std::filesystem::path& file);

  const AttemptHeader& header() const { return header_; }
  AttemptStatus status() const { return status_; }
  /// Returns one sentence about each defect: a truncated file, damaged blocks.
  const std::vector<std::string>& errors() const { return errors_; }
  /// Tells whether all blocks of the recording were found. The contents of a block are checked only when it is
  /// decompressed.
  bool isWhole() const { return !damaged_; }

  /// Checks whether the recording is unchanged. `key`: key that the curriculum store issued with the recording's nonce;
  /// empty: the key is unknown, or the recording has no nonce.
  RecordingProof proof(const std::optional<RecordKey>& key) const;

  /// Returns the settings in use at a time, in the form of AttemptHeader::settings; "" if the recording has none. Fails
  /// if a change of settings before that time is damaged or may be lost.
  Result<std::string> settingsAt(std::int64_t time_us) const;
  /// Returns all readable changes of settings, in the order of their times.
  const std::vector<SettingsChange>& settingsChanges() const { return changes_; }

  std::int64_t end_us() const;  ///< time of the last sample or event; 0 if there is none
  std::size_t segmentCount() const { return blocks_.size(); }
  /// Returns the index of the last segment that begins at or before this time; 0 if no segment does. segmentCount()
  /// must be above 0.
  std::size_t segmentAt(std::int64_t time_us) const;
  /// Decompresses and returns a segment (about one second) of the recording; fails if its block is damaged.
  Result<RecordingSegment> segment(std::size_t index) const;

  /// Calls `take` with each sample and event up to the time `until_us`, in the order in which AttemptMetrics and
  /// ProcedureRun received them live. Fails if a part before `until_us` is damaged, since results without that part
  /// would be wrong.
  Result<void> play(std::int64_t until_us, const std::function<void(const RecordingSegment::Entry&)>& take) const;
  /// Computes the metrics of all samples and events up to this time. They are exactly equal to the live metrics at that
  /// time. Fails as play() does.
  Result<MetricValues> metricsUntil(std::int64_t time_us = std::numeric_limits<std::int64_t>::max()) const;

 private:
  struct Block {
    std::int64_t first_us = 0, last_us = 0;
    std::size_t payload = 0, packedBytes = 0, rawBytes = 0;
    std::uint32_t checksum = 0;
    bool agrees = true;  ///< true: the block agrees with the file's digests
  };
  struct Link {
    std::array<std::uint8_t, 32> digest{};
    std::optional<std::array<std::uint8_t, 32>> code{};
  };
  std::vector<record::PlacedBlock> findBlocks();
  Result<void> readHeader(const std::vector<record::PlacedBlock>& blocks);
  /// Checks the blocks against the digests in links_; removes blocks that were not written completely.
  Result<void> checkLinks(std::vector<record::PlacedBlock>& blocks);
  void readBlock(const record::PlacedBlock& block);
  void readChange(const record::BlockHead& head, std::size_t payload, bool agrees);
  void checkEnd(const record::BlockHead& head, std::size_t payload);
  void reportProblems();

  std::string name_;
  std::vector<std::uint8_t> bytes_;
  bool isChained_ = false, damaged_ = false;
  bool missing_ = false;     ///< true: according to the digests, a block may be missing
  std::string fault_;        ///< sentence about the first block that does not match its digest; "": all blocks match
  std::vector<Link> links_;  ///< digests of the blocks, in the order of the blocks
  AttemptHeader header_;
  AttemptStatus status_ = AttemptStatus::CutShort;
  std::vector<std::string> errors_;
  std::vector<Block> blocks_;
  std::vector<SettingsChange> changes_;
  /// Time from which the settings are unknown, since a damaged part may contain a change of settings; empty: always
  /// known.
  std::optional<std::int64_t> unknownFrom_us_;
};

}  // namespace insonate
