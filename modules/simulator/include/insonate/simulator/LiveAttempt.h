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

/// State of an attempt; all of one moment, some milliseconds ago.
struct AttemptView {
  double time_s = 0;                      ///< on the clock, since it began
  std::vector<ProcedureRun::Step> steps;  ///< of Procedure::steps
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
/// start(). Members but ticked() and show() may be called from any thread.
class LiveAttempt final : public TickListener {
 public:
  /// Facts about a tick that the servo's output does not contain.
  struct Surroundings {
    std::shared_ptr<const TissueGrid> grid;                ///< null: not there yet
    std::shared_ptr<const std::vector<CentreLine>> veins;  ///< null: not there yet
    std::shared_ptr<const SkinSurface> skin;               ///< of the case; null: not there yet
    Transform restFromPatient;                             ///< of LocalModel
    double pictureDepth_mm = 0;
  };

  /// `header` has the names of `vessels`; `key` is as in AttemptRecorder. Fails as AttemptRecorder::start() does.
  static Result<std::shared_ptr<LiveAttempt>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                    Procedure procedure, VesselNames vessels = {},
                                                    const std::optional<RecordKey>& key = std::nullopt);
  /// Abandons an unfinished attempt. A HandsSession may keep the attempt alive until it ends.
  ~LiveAttempt() override;

  /// Called by the servo: neither waits nor allocates.
  void ticked(const ServoSnapshot& tick) noexcept override;
  /// Passes the surroundings; call on one thread, as often as the servo is shown the tissue.
  void show(Surroundings around);
  /// Passes the latest live image, null without one; call as often as show(), on the same thread. The attempt detects
  /// from it when the target vein is found.
  void see(const std::shared_ptr<const LiveFrame>& frame, const Surroundings& around);

  /// Replaced, frozen, released or positioned. While frozen, images stand still and count as none.
  void tell(AttemptEventKind kind, double tilt_deg = 0);
  void setAspirating(bool on);
  /// Sets the settings from now on; those of the header apply before.
  void setSettings(const AttemptSettings& settings);

  const Procedure& procedure() const;
  const std::filesystem::path& file() const;
  AttemptView view() const;
  /// Score at present; of the whole attempt once it is finished.
  AttemptScore score() const;
  /// A sentence once the disk refuses; empty: all is well.
  std::string trouble() const;
  /// Stops recording and writes the rest. Call once. Fails as AttemptRecorder::finish() does.
  Result<MetricValues> finish(AttemptStatus status);

 private:
  struct State;
  explicit LiveAttempt(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
