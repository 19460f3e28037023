#pragma once

#include "DeviceChoice.h"

#include <insonate/simulator/HapticSession.h>
#include <insonate/simulator/LiveAttempt.h>
#include <insonate/simulator/NeedlePlacement.h>

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <string>

class QSettings;

namespace insonate::train {

/// Directions in which the user can move the needle. Lateral and Elevation move the entry point over the skin, along
/// the probe's directions.
enum class NeedleAxis { Lateral, Elevation, Heading, Angle, Bevel, Advance };

/// The needle's displayed pose and its state.
struct NeedleShown {
  Transform patientFromNeedle;  ///< pose: tip at the origin, z along the insertion, bevel along -y; the tip is never
                                ///< drawn inside bone
  NeedleState state;
};

/// Bit of the button of the needle's device that aspirates; while an instrument is in the hand, it grips the
/// instrument.
inline constexpr std::uint32_t kGripButton = 2;

/// Controls what moves probe and needle: mouse and keys, haptic devices and their assignment, and a pedal. Forces and
/// punctures always come from the servo. May be used only on the window's thread.
class HapticControl : public QObject {
  Q_OBJECT

 public:
  static constexpr double kAdvance_mmPerS = 25;  ///< speed of an insertion by keys or typed numbers

  explicit HapticControl(QObject* parent = nullptr);
  ~HapticControl() override;

  HapticSession& session() { return *session_; }

  /// Sets a patient, the map of the patient's tissues and a ProbePlacement on the skin; null: no patient. Puts the
  /// needle away.
  void setCase(std::shared_ptr<const PatientCase> patient, std::shared_ptr<const LabelMap> labels,
               const ProbePlacement* hand);
  /// Sets the attempt that receives each servo tick; null: no attempt. During an attempt the servo includes the probe,
  /// even without a needle.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);
  /// Suppresses messages about the needle's contacts, for attempts in test mode.
  void setSilent(bool silent);
  /// Assigns no device to probe and needle while the workspace is not visible (`watched` false).
  void setWatched(bool watched);
  /// Sets the pose that mouse and keys give the probe, and half the width of the probe's face.
  void probeMoved(const ProbePlacement& hand, double halfWidth_mm);

  // The probe
  /// Tells whether a device moves the probe. If probeFollowsMouse(), the device itself moves as mouse and keys command.
  bool drivesProbe() const;
  bool probeFollowsMouse() const;
  const Transform& drivenPose() const { return driven_; }

  // The needle
  /// The needle that mouse and keys move; null if there is none or a real device moves it.
  const NeedlePlacement* needleHand() const { return wish_ ? &*wish_ : nullptr; }
  /// Insertion depth that mouse and keys have requested; the needle moves toward it.
  double wantedAdvance_mm() const { return advance_mm_; }
  /// The needle in use, moved by mouse and keys or by a device; empty if there is none.
  const std::optional<NeedleShown>& needle() const { return needle_; }
  /// Takes a needle and puts it beside the probe, ready for insertion.
  void takeNeedle(NeedlePlane plane);
  /// Plane in which the needle was last taken.
  NeedlePlane needlePlane() const { return plane_; }
  void removeNeedle();
  void moveNeedle(NeedleAxis axis, double mmOrDegrees);
  /// Moves the needle to a typed number; `axis` is Heading, Angle, Bevel or Advance.
  void setNeedle(NeedleAxis axis, double mmOrDegrees);
  /// Moves the entry point to the skin nearest to a point. Has an effect only while the needle is outside the skin.
  void needleTo(Vec3 patient_mm);

  /// true: freezes the needle together with the image, so that the needle stays in place, whatever moves it; false:
  /// releases the needle.
  void setHeld(bool held);
  /// true: the device of the needle moves an instrument of the line, such as the wire; the needle stays in its place,
  /// and the device's buttons neither aspirate nor turn the view.
  void setInstrumentInHand(bool isInHand);
  bool isInstrumentInHand() const { return isInstrumentInHand_; }

  // Devices
  const DeviceChoice& choice() const { return choice_; }
  /// Assigns a device by DeviceInfo::id; empty: mouse and keys.
  void assign(HapticTool hand, const QString& device);
  /// Says that the devices of this kind measure in the frame of a registered desk, or no longer. The printed outline is
  /// then the place at which the probe was when the case was opened.
  void setOnDesk(DeviceKind kind, bool isOnDesk);
  void assignPedal(const QString& device);
  void setMapping(const QString& device, const HandMapping& mapping);
  /// Returns the kind of the hand that moves a tool, for HandKinds.
  std::string kindOfHand(HapticTool hand);
  /// Makes the present pose of the device that moves this tool the start pose of the tool.
  void beginHere(HapticTool hand);
  /// Returns a connected device; null if it is not connected.
  std::shared_ptr<HapticDevice> deviceOf(const QString& id);

  /// Processes events of devices. While a device is assigned to a tool, the object calls this function itself.
  void checkDevices();

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void needleChanged();
  void probeDriven();   ///< emitted when drivenPose() has changed
  void handsChanged();  ///< emitted when the tools, or the devices that move them, have changed
  void messageReported(const QString& sentence);
  void pedalPressed(int button);
  /// Emitted while the first button of the needle's device is held. The view turns about the patient by these rotations
  /// of the stylus, in degrees, to the right and up.
  void anatomyTurned(double across_deg, double up_deg);
  void aspirateButtonChanged(bool down);  ///< emitted when the second button of the needle's device is pressed or
                                          ///< released
  void deviceEvent(const insonate::DeviceEvent& event);
  void needleMet(const insonate::NeedleEvent& event);  ///< emitted at each puncture and each contact with bone

 private:
  void look();
  void tellAdvice();
  bool isOnDesk(const HapticDevice& device) const;
  ToolSetup setupFor(HapticTool hand, const HapticDevice& device, const HandMapping& mapping) const;
  void apply();
  void put(HapticTool hand);
  void follow(const ServoSnapshot& now);
  void checkButtons(const DeviceState& now);
  void advanceTowardTarget(const ServoSnapshot& now, double step_s);
  void tell(MoveResult move);
  void targetChanged();
  Transform startOf(HapticTool hand) const;
  NeedlePlacement newNeedle() const;
  void leave(HapticTool hand);

  std::unique_ptr<HapticSession> session_;
  DeviceChoice choice_;
  std::array<std::shared_ptr<HapticDevice>, 2> put_;
  std::shared_ptr<HapticDevice> pedalDevice_;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;
  std::optional<ProbePlacement> probe_;
  Transform onOutline_;               ///< pose of the probe in the patient when it is held on the printed outline
  QSet<int> onDesk_;                  ///< kinds of devices that measure in the frame of a desk
  std::array<bool, 2> beginsHere_{};  ///< true: the first pose of the device becomes the tool's start pose
  std::array<QString, 2> advice_;     ///< last sentence about each hand's device
  double halfWidth_mm_ = 19;
  bool watched_ = true, attempted_ = false, silent_ = false, isHeld_ = false, isInstrumentInHand_ = false;
  std::optional<NeedlePlacement> wish_;
  double advance_mm_ = 0;
  NeedlePlane plane_ = NeedlePlane::InPlane;
  std::optional<NeedleShown> needle_;
  Transform driven_;
  DeviceState stylus_;  ///< last state of the needle's device
  QTimer timer_, slow_;
  QElapsedTimer clock_;
};

}  // namespace insonate::train
