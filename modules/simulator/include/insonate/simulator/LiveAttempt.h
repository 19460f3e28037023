#pragma once

#include <insonate/haptics/ServoThread.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/VesselNames.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

class SkinSurface;

/// State of an attempt; all values are of the same moment, some milliseconds ago.
struct AttemptView {
  double time_s = 0;                      ///< wall-clock time since the attempt began
  std::vector<ProcedureRun::Step> steps;  ///< steps of Procedure::steps
  std::optional<std::size_t> due;
  std::vector<ProcedureRun::Finding> findings;
  std::vector<AttemptEvent> events;
  MetricValues metrics;
  NeedlePlace needle = NeedlePlace::Clean;
  std::string vessel;  ///< ProcedureRun::vesselIn()
  bool succeeded = false;
};

/// Records an attempt made by two hands (HandsSession::setAttempt): each tick of their servo is recorded, and a
/// ProcedureRun processes the recorded samples, so that a replay gives the same to the last bit. Times count from
/// start(). Members other than ticked(), show() and see() may be called from any thread.
class LiveAttempt final : public TickListener {
 public:
  /// State of patient and vessels around a tick, which the servo's output does not contain.
  struct Surroundings {
    std::shared_ptr<const TissueGrid> grid;                ///< null: not computed yet
    std::shared_ptr<const std::vector<CentreLine>> veins;  ///< null: not computed yet
    std::shared_ptr<const SkinSurface> skin;               ///< skin of the case; null: not computed yet
    Transform restFromPatient;                             ///< LocalModel::restFromPatient
    double pictureDepth_mm = 0;
  };

  /// Starts an attempt. `header` has the names of `vessels`; `key` is as in AttemptRecorder. Fails as
  /// AttemptRecorder::start() does.
  static Result<std::shared_ptr<LiveAttempt>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                    Procedure procedure, VesselNames vessels = {},
                                                    const std::optional<RecordKey>& key = std::nullopt);
  /// Abandons an unfinished attempt. A HandsSession may keep the attempt alive until it ends.
  ~LiveAttempt() override;

  /// Called by the servo: neither waits nor allocates.
  void ticked(const ServoSnapshot& tick) noexcept override;
  /// Passes the surroundings. Call it on one thread, whenever the servo receives new tissue.
  void show(Surroundings around);
  /// Passes the latest live image; null: no live image. Call it as often as show(), on the same thread. From the images
  /// the attempt detects that the target vein is found.
  void see(const std::shared_ptr<const LiveFrame>& frame, const Surroundings& around);

  /// Records an event that the program reports: needle replaced, image frozen or released, patient positioned. While
  /// the image is frozen, no image is counted.
  void tell(AttemptEventKind kind, double tilt_deg = 0);
  void setAspirating(bool on);
  /// Sets the settings that apply from now on; until the first call the settings of the header apply.
  void setSettings(const AttemptSettings& settings);

  const Procedure& procedure() const;
  const std::filesystem::path& file() const;
  AttemptView view() const;
  /// Returns the score so far; after finish(), that of the whole attempt.
  AttemptScore score() const;
  /// A sentence if the recording can no longer be written to disk; else empty.
  std::string trouble() const;
  /// Stops recording and writes the remaining samples. Call it once. Fails as AttemptRecorder::finish() does.
  Result<MetricValues> finish(AttemptStatus status);

 private:
  struct State;
  explicit LiveAttempt(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
