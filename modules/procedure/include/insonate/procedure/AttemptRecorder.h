#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/procedure/RecordingProof.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace insonate {

/// Receives the samples and events that a recorder has written, rounded as a replay reads them and in its order, and
/// computes their metrics in the recorder's place. All functions are called on the recorder's thread.
class AttemptFollower {
 public:
  virtual ~AttemptFollower() = default;
  virtual void take(const AttemptSample& sample) = 0;
  virtual void take(const AttemptEvent& event) = 0;
  /// Metrics of the stream so far, as AttemptMetrics computes them.
  virtual MetricValues metrics() const = 0;
};

/// Writes an attempt as it happens, on a thread of its own, and computes its metrics from the written samples, so that
/// a replay gives the same. The file grows under a temporary name (`partOf()`), a block each second, each on the disk
/// at once; finish() gives it its final name. A program that ends before leaves the part, which AttemptRecording
/// reads.
class AttemptRecorder {
 public:
  /// Fails where the file exists, where a part of an earlier attempt lies beside it, or where it cannot be written.
  /// `follower`, if there is one, is asked no more once finish() has returned. `key` belongs to the nonce of the
  /// header; none where no store gave one: then the recording can be checked for damage, and proves nothing.
  static Result<std::unique_ptr<AttemptRecorder>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                        std::shared_ptr<AttemptFollower> follower = nullptr,
                                                        const std::optional<RecordKey>& key = std::nullopt);
  /// An attempt that was not finished is finished as abandoned.
  ~AttemptRecorder();
  AttemptRecorder(const AttemptRecorder&) = delete;
  AttemptRecorder& operator=(const AttemptRecorder&) = delete;

  /// Adds a sample; call on one thread, the servo's: neither waits, allocates nor throws. A sample without room, since
  /// the recorder's thread had no processor for 4 s, is counted and left out. A sample older than the last one is left
  /// out, too.
  void put(const AttemptSample& sample) noexcept;
  void put(const AttemptEvent& event) noexcept;
  /// Number of further entries that put() accepts now, for callers that run ahead of time and can wait. Call from the
  /// thread that calls put().
  std::size_t room() const noexcept;
  /// Adds an event; call on any other thread. It is stored after the samples that the servo had added by then.
  void note(const AttemptEvent& event);
  /// Settings from a time on, which must not lie before that of another change. By any thread but the servo's. What
  /// changes nothing is not kept.
  void note(const SettingsChange& change);

  /// Metrics of some milliseconds ago. Any thread.
  MetricValues metrics() const;
  /// Sentence about a disk error; the attempt and its metrics continue. Empty: no error. Any thread.
  std::string trouble() const;

  /// Writes the rest. Fails if the disk did not take all of it, and names the part that it took. Call once, on the
  /// thread that started it, after the last put() and note().
  Result<MetricValues> finish(AttemptStatus status);

  static std::filesystem::path partOf(const std::filesystem::path& file);

 private:
  struct State;
  explicit AttemptRecorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
