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

/// Receives the samples and events that an AttemptRecorder has written, quantized and ordered as a replay reads them,
/// and computes the metrics instead of the recorder. All functions are called on the recorder's thread.
class AttemptFollower {
 public:
  virtual ~AttemptFollower() = default;
  virtual void take(const AttemptSample& sample) = 0;
  virtual void take(const AttemptEvent& event) = 0;
  /// Returns the metrics of the samples and events so far, as AttemptMetrics computes them.
  virtual MetricValues metrics() const = 0;
};

/// Records an attempt to a file while it happens, on its own thread, and computes the metrics from the written samples,
/// so that a replay gives the same metrics. Each second a block is written to a file with a temporary name
/// (`partOf()`); finish() gives the file its final name. If the program ends before finish(), the temporary file
/// remains, and AttemptRecording can read it.
class AttemptRecorder {
 public:
  /// Starts a recording. Fails if `file` exists, if its temporary file of an earlier attempt exists, or if it cannot be
  /// written. `follower` may be null; it is not used after finish() has returned. `key`: key that the store issued with
  /// the header's nonce, so that the recording proves its origin; empty: no store issued a nonce, and the recording can
  /// only be checked for damage.
  static Result<std::unique_ptr<AttemptRecorder>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                        std::shared_ptr<AttemptFollower> follower = nullptr,
                                                        const std::optional<RecordKey>& key = std::nullopt);
  /// Finishes an unfinished attempt as abandoned.
  ~AttemptRecorder();
  AttemptRecorder(const AttemptRecorder&) = delete;
  AttemptRecorder& operator=(const AttemptRecorder&) = delete;

  /// Records a sample. Call it on the force loop's thread only; it neither waits, allocates nor throws. If the queue is
  /// full, since the recorder's thread did not run for 4 s, the sample is dropped and counted as lost. A sample older
  /// than the last sample is dropped, too.
  void put(const AttemptSample& sample) noexcept;
  void put(const AttemptEvent& event) noexcept;
  /// Returns the number of samples that put() can accept now, for callers that run faster than real time and can wait.
  /// Call it on the thread that calls put().
  std::size_t room() const noexcept;
  /// Records an event. Call it on any thread except the force loop's. The event is stored after the samples that put()
  /// has accepted until then.
  void note(const AttemptEvent& event);
  /// Records the settings that apply from `change.time_us` on; the time must not lie before that of the previous
  /// change. Call it on any thread except the force loop's. A change to equal settings is not stored.
  void note(const SettingsChange& change);

  /// Returns the metrics as they were some milliseconds ago. May be called from any thread.
  MetricValues metrics() const;
  /// Returns a sentence about a disk error, in spite of which attempt and metrics continue; empty: no error. May be
  /// called from any thread.
  std::string trouble() const;

  /// Writes the remaining data and gives the file its final name. On a disk error it fails and names the temporary file
  /// with the part that was written. Call it once, on the thread that started the recording, after the last put() and
  /// note().
  Result<MetricValues> finish(AttemptStatus status);

  /// Returns the temporary name under which `file` is written until finish().
  static std::filesystem::path partOf(const std::filesystem::path& file);

 private:
  struct State;
  explicit AttemptRecorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
