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

/// Receives the samples and events that a recorder has written, rounded as a replay reads them and in the same order,
/// and computes the metrics instead of the recorder. All functions are called on the recorder's thread.
class AttemptFollower {
 public:
  virtual ~AttemptFollower() = default;
  virtual void take(const AttemptSample& sample) = 0;
  virtual void take(const AttemptEvent& event) = 0;
  /// Metrics of the samples and events so far, as AttemptMetrics computes them.
  virtual MetricValues metrics() const = 0;
};

/// Writes an attempt as it happens, on its own thread, and computes the metrics from the written samples, so that a
/// replay gives the same metrics. The file grows under a temporary name (`partOf()`); each second a block is written to
/// disk. finish() gives the file its final name. If the program ends before finish(), the temporary file remains, and
/// AttemptRecording can read it.
class AttemptRecorder {
 public:
  /// Starts a recording. Fails if the file exists, if a temporary file of an earlier attempt lies beside it, or if it
  /// cannot be written. `follower` may be null; it is not used any more once finish() has returned. `key` belongs to
  /// the nonce of the header; empty if no store issued a nonce: then the recording can be checked for damage, but
  /// proves nothing.
  static Result<std::unique_ptr<AttemptRecorder>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                        std::shared_ptr<AttemptFollower> follower = nullptr,
                                                        const std::optional<RecordKey>& key = std::nullopt);
  /// Finishes an unfinished attempt as abandoned.
  ~AttemptRecorder();
  AttemptRecorder(const AttemptRecorder&) = delete;
  AttemptRecorder& operator=(const AttemptRecorder&) = delete;

  /// Adds a sample. Call it on one thread, the servo's; it neither waits, allocates nor throws. If the queue is full,
  /// since the recorder's thread did not run for 4 s, the sample is counted as lost and left out. A sample older than
  /// the last sample is left out, too.
  void put(const AttemptSample& sample) noexcept;
  void put(const AttemptEvent& event) noexcept;
  /// Number of further samples that put() accepts now, for callers that run faster than real time and can wait. Call it
  /// on the thread that calls put().
  std::size_t room() const noexcept;
  /// Adds an event. Call it on any thread except the servo's. The event is stored after the samples that the servo has
  /// added until then.
  void note(const AttemptEvent& event);
  /// Stores the settings that apply from a time on; the time must not lie before that of another change. Call it on any
  /// thread except the servo's. A change to equal settings is not stored.
  void note(const SettingsChange& change);

  /// Metrics as they were some milliseconds ago. Any thread may call.
  MetricValues metrics() const;
  /// Sentence about a disk error; the attempt and its metrics continue. Empty: no error. Any thread may call.
  std::string trouble() const;

  /// Writes the remaining data. If the disk did not accept all of it, fails and names the temporary file with the part
  /// that was written. Call it once, on the thread that started the recording, after the last put() and note().
  Result<MetricValues> finish(AttemptStatus status);

  static std::filesystem::path partOf(const std::filesystem::path& file);

 private:
  struct State;
  explicit AttemptRecorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
