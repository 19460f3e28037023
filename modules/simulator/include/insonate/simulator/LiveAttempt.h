#pragma once

#include <insonate/haptics/ServoThread.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/VesselLocator.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

class SkinSurface;

/// Vessel that the needle would puncture first if it were advanced along its axis by its whole length.
enum class NeedleAim {
  Unknown,  ///< no needle, or no live image
  Vein,     ///< the target vein; any vein in a case without a target
  Artery,
  Beside,  ///< neither the target vein nor an artery
};

/// State of an attempt in progress. All values belong to the same moment, which is some milliseconds ago.
struct AttemptView {
  double time_s = 0;                      ///< wall-clock time since the attempt began
  std::vector<ProcedureRun::Step> steps;  ///< states of Procedure::steps, in the same order
  std::optional<std::size_t> nextStep;    ///< index of the step to do next; empty if all steps are done
  std::vector<ProcedureRun::Finding> findings;
  std::vector<AttemptEvent> events;
  MetricValues metrics;
  NeedlePlace needle = NeedlePlace::Clean;
  std::string vessel;  ///< vessel in which the needle's tip is: ProcedureRun::vesselAtTip()
  bool succeeded = false;
  /// true: the target vein is in the middle of the live image now, or it was there and the probe has since then only
  /// compressed the tissue further
  bool isVeinCentered = false;
  bool isVeinCompressed = false;  ///< the probe compressed the target vein, and has not released it yet
  NeedleAim aim = NeedleAim::Unknown;
  LineState line{};  ///< state of wire, dilator and catheter
};

/// Result of moving an instrument of the line.
struct InstrumentMove {
  double moved_mm = 0;    ///< distance that it has gone; negative out of the body
  std::string refusal{};  ///< sentence that says why it has not gone the whole distance; empty if it has
};

/// Records an attempt. HapticSession passes each tick of the force loop to onTick(). A ProcedureRun evaluates the
/// recorded samples, so that a replay gives exactly the same results. Times count from start(). All members except
/// onTick(), setSurroundings() and addFrame() may be called from any thread.
class LiveAttempt final : public TickListener {
 public:
  /// Tissue and vessels around the needle. The recorded samples contain distances to them, which the force loop does
  /// not compute.
  struct Surroundings {
    std::shared_ptr<const TissueGrid> grid;                ///< tissue grid of the needle; null: not computed yet
    std::shared_ptr<const std::vector<CenterLine>> veins;  ///< center lines of the case's veins; null: not computed yet
    std::shared_ptr<const SkinSurface> skin;               ///< undeformed skin of the case; null: not computed yet
    /// affine map from the present to the undeformed position of tissue near the needle's tip, as
    /// LocalModel::restFromPatient
    Transform restFromPatient;
    double imageDepth_mm = 0;
    std::shared_ptr<const LabelMap> labels{};  ///< label map of the case; null: no case
    NeedleState needle{};                      ///< state of the needle in the last tick
    Transform patientFromNeedle{};             ///< pose of the needle in the last tick
  };

  /// Starts recording an attempt into `file`. `header.vessels` must equal vessels.names(). `key`: as for
  /// AttemptRecorder::start(). Fails as AttemptRecorder::start() does.
  static Result<std::shared_ptr<LiveAttempt>> start(const std::filesystem::path& file, const AttemptHeader& header,
                                                    Procedure procedure, VesselLocator vessels = {},
                                                    const std::optional<RecordKey>& key = std::nullopt);
  /// Finishes an unfinished attempt as abandoned. A HapticSession may keep the object alive until the session ends.
  ~LiveAttempt() override;

  /// Records one tick; called on the force loop's thread. Neither waits nor allocates.
  void onTick(const ServoSnapshot& tick) noexcept override;
  /// Sets the tissue and vessels for the following ticks. Call it, always on the same thread, whenever the force loop
  /// receives new tissue.
  void setSurroundings(Surroundings around);
  /// Passes the latest live image, in which the attempt detects whether the target vein is centered or compressed, and
  /// where the needle aims; null: there is no live image. Call this function as often as setSurroundings(), on the same
  /// thread.
  void addFrame(const std::shared_ptr<const LiveFrame>& frame, const Surroundings& around);

  /// Prepares the instruments that follow the needle: wire, dilator and catheter. Call it before the first tick. Fails
  /// if the case names no vessels; the attempt then has no line.
  Result<void> prepareLine(std::span<const NamedVessel> vessels);
  /// Returns the instruments of the line in the body, for LiveImaging::setRods(); null before the first.
  SharedRods rods() const;
  /// Returns the last flush for bubbles, for LiveImaging::setFlush(); empty before the first.
  std::optional<SalineFlush> flush() const;
  /// Tells which lungs the needle has punctured, right and left, for LiveImaging::setPneumothorax().
  std::array<bool, 2> pneumothorax() const;
  /// Performs an act of the line. Returns AttemptEvent::amount of the act, e.g. the pressure (see LineAct). Fails with
  /// a sentence for the trainee if the act is not possible. `lumen`: number of the catheter's lumen, 1 to 3.
  Result<double> perform(LineAct act, int lumen = 1);
  /// Moves wire, dilator or catheter into the body, or out of it if `by_mm` is negative; takes some milliseconds for
  /// each millimeter.
  InstrumentMove moveInstrument(Instrument instrument, double by_mm);
  /// Returns the force of the wire on the hand that inserts it, against the insertion; 0 without a wire.
  double wireResistance_N() const;

  /// Records an event that the user interface reports: needle replaced, image frozen or released, patient positioned.
  /// While the image is frozen, samples are recorded as if there were no live image.
  void recordEvent(AttemptEventKind kind, double tilt_deg = 0);
  /// Sets whether the syringe aspirates from now on.
  void setAspirating(bool on);
  /// Records the imaging settings that apply from now on. Until the first call, the settings of the header apply.
  void setSettings(const AttemptSettings& settings);

  const Procedure& procedure() const;
  /// Returns the file of the recording.
  const std::filesystem::path& file() const;
  /// Returns the present state of the attempt.
  AttemptView view() const;
  /// Returns the score so far; after finish(), the score of the whole attempt.
  AttemptScore score() const;
  /// Returns a sentence if the recording can no longer be written to the disk; else an empty text.
  std::string error() const;
  /// Stops recording, writes the remaining samples and returns the metrics. Call it once. Fails as
  /// AttemptRecorder::finish() does.
  Result<MetricValues> finish(AttemptStatus status);

 private:
  struct State;
  explicit LiveAttempt(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace insonate
