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

/// Receives the samples and events that an AttemptRecorder has written, quantized and in the order in which a replay
/// reads them. If a recorder has a listener, the listener computes the metrics, and the recorder does not. All
/// functions are called on the recorder's thread.
class AttemptListener {
 public:
  virtual ~AttemptListener() = default;
  virtual void add(const AttemptSample& sample) = 0;
  virtual void add(const AttemptEvent& event) = 0;
  /// Returns the metrics of the samples and events so far, as AttemptMetrics computes them.
  virtual MetricValues metrics() const = 0;
};

/// Records an attempt in progress to a file. A thread of the recorder writes the samples, and computes the metrics from
/// the written samples, so that a replay gives the same metrics. Each second a block is appended to a file with a
/// temporary name (partialFile()); finish() gives the file its final name. If the program ends before finish(), the
/// temporary file remains, and AttemptRecording can read it.
class AttemptRecorder {
 public:
  /// Starts a recording. Fails if `file` exists, if the temporary file of an earlier recording with this name exists,
  /// or if `file` cannot be written. `follower` receives the written samples and events; null: none. It is not used
  /// after finish() has returned. `key` authenticates the recording: the key that the curriculum store issued with the
  /// nonce in the header. Empty: no store issued a nonce, and the recording can only be checked for damage.
  static Result<std::unique_ptr<AttemptRecorder>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                        std::shared_ptr<AttemptListener> follower = nullptr,
                                                        const std::optional<RecordKey>& key = std::nullopt);
  /// Finishes an unfinished attempt as abandoned.
  ~AttemptRecorder();
  AttemptRecorder(const AttemptRecorder&) = delete;
  AttemptRecorder& operator=(const AttemptRecorder&) = delete;

  /// Records a sample. Call this function on the force loop's thread only; it neither waits, allocates nor throws. If
  /// the queue is full, which happens when the recorder's thread has not run for 4 s, the sample is dropped and counted
  /// as lost. A sample whose time is earlier than the time of the last sample is also dropped.
  void record(const AttemptSample& sample) noexcept;
  /// Records an event. Call it on the force loop's thread only; it neither waits, allocates nor throws.
  void record(const AttemptEvent& event) noexcept;
  /// Returns the number of samples that record() can accept now, for callers that run faster than real time and can
  /// wait. Call it on the thread that calls record().
  std::size_t freeSlots() const noexcept;
  /// Records an event. Call it on any thread except the force loop's. The event is stored after the samples that
  /// record() has accepted before this call.
  void recordFromOtherThread(const AttemptEvent& event);
  /// Records the settings that apply from `change.time_us` on; this time must not be earlier than the time of the
  /// previous change. Call this function on any thread except the force loop's. If the settings equal the previous
  /// settings, nothing is stored.
  void recordFromOtherThread(const SettingsChange& change);

  /// Returns the metrics of the samples that have been written; they lag behind record() by some milliseconds. May be
  /// called from any thread.
  MetricValues metrics() const;
  /// Returns a sentence about a disk error; empty: no error. The attempt and its metrics continue in spite of the
  /// error. May be called from any thread.
  std::string error() const;

  /// Writes the remaining data, gives the file its final name, and returns the metrics. Fails on a disk error; the
  /// sentence then names the temporary file, which contains the part that was written. Call it once, on the thread that
  /// started the recording, after the last record() and recordFromOtherThread().
  Result<MetricValues> finish(AttemptStatus status);

  /// Returns the temporary name under which `file` is written until finish().
  static std::filesystem::path partialFile(const std::filesystem::path& file);
  /// Gives a recording whose program ended before finish() its final name, and returns this name. Fails if the name
  /// `partial` is not from partialFile(), if a program is still writing the recording, or if the final name is taken.
  static Result<std::filesystem::path> recover(const std::filesystem::path& partial);

 private:
  struct State;
  explicit AttemptRecorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
