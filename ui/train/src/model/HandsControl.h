#pragma once

#include "DeviceChoice.h"

#include <insonate/simulator/HandsSession.h>
#include <insonate/simulator/LiveAttempt.h>
#include <insonate/simulator/NeedleHand.h>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

class QSettings;

namespace insonate::train {

/// Directions in which a hand can move the needle. Lateral and Elevation slide its entry over the skin, along the
/// probe's directions.
enum class NeedleAxis { Lateral, Elevation, Heading, Angle, Bevel, Advance };

/// The needle as it is held and as it lies.
struct NeedleShown {
  Transform patientFromNeedle;  ///< tip at the origin, z the way it goes in, bevel along -y; not drawn into bone
  NeedleState state;
};

/// Both hands of this workspace: the needle held by mouse and keys, devices and their hands, a pedal. Forces and
/// punctures come from the servo for every kind of hand. For the window's thread.
class HandsControl : public QObject {
  Q_OBJECT

 public:
  static constexpr double kAdvance_mmPerS = 25;  ///< by keys and numbers

  explicit HandsControl(QObject* parent = nullptr);
  ~HandsControl() override;

  HandsSession& session() { return *session_; }

  /// A patient's tissues and the names of the vessels, once there is a hand on the skin; null for none. Lays the needle
  /// down.
  void setCase(std::shared_ptr<const LabelMap> labels, const ProbeHand* hand, VesselNames vessels = {});
  /// Hears of each tick of the hands; meanwhile the probe is in one, also without a needle. Null for none.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);
  /// In a test, messages about the needle's contacts are suppressed.
  void setSilent(bool silent);
  /// Hands are empty while the workspace is not watched.
  void setWatched(bool watched);
  /// Reports the pose at which mouse and keys hold the probe, and the half width of its face.
  void probeMoved(const ProbeHand& hand, double halfWidth_mm);

  // The probe
  /// A device moves the probe: by itself, or, where followsMouse(), as mouse and keys want it.
  bool drivesProbe() const;
  bool probeFollowsMouse() const;
  const Transform& drivenPose() const { return driven_; }

  // The needle
  /// The needle held by mouse and keys; null without one, and in a real device.
  const NeedleHand* needleHand() const { return wish_ ? &*wish_ : nullptr; }
  /// Insertion that mouse and keys aim at; the needle is moving there.
  double wantedAdvance_mm() const { return advance_mm_; }
  /// The needle in a hand, of mouse and keys or of a device; none without one.
  const std::optional<NeedleShown>& needle() const { return needle_; }
  /// Beside the probe, ready to go in.
  void takeNeedle(NeedlePlane plane);
  /// The last one.
  NeedlePlane needlePlane() const { return plane_; }
  void layNeedleDown();
  void moveNeedle(NeedleAxis axis, double mmOrDegrees);
  /// Moves to a typed number: Heading, Angle, Bevel, Advance.
  void setNeedle(NeedleAxis axis, double mmOrDegrees);
  /// The entry to the skin nearest to a point; while the needle is out.
  void needleTo(Vec3 patient_mm);

  /// Freezes the needle with the image: it stays in place in any hand until it is released.
  void setHeld(bool held);

  // Devices
  const DeviceChoice& choice() const { return choice_; }
  /// Assigns a device by DeviceInfo::id; empty for mouse and keys.
  void assign(Hand hand, const QString& device);
  void assignPedal(const QString& device);
  void setMapping(const QString& device, const HandMapping& mapping);
  /// The device in this hand, as it is held now, holds the tool at its start.
  void beginHere(Hand hand);
  /// A connected device; null if it is not.
  std::shared_ptr<HapticDevice> deviceOf(const QString& id);

  /// News of devices, which come by themselves while one is in a hand.
  void checkDevices();

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void needleChanged();
  void probeDriven();   ///< drivenPose() is another
  void handsChanged();  ///< what is in which hand
  void said(const QString& sentence);
  void pedalPressed(int button);
  /// Emitted while the first button of the needle's device is held: rotation of the stylus, in degrees, by which the
  /// view turns about the patient, to the right and up.
  void anatomyTurned(double across_deg, double up_deg);
  void drawButton(bool down);  ///< its second button
  void deviceEvent(const insonate::DeviceEvent& event);

 private:
  void look();
  void apply();
  void put(Hand hand);
  void follow(const ServoSnapshot& now);
  void checkButtons(const DeviceState& now);
  void advanceTowardTarget(const ServoSnapshot& now, double step_s);
  void tell(HandMove move);
  void targetChanged();
  Transform startOf(Hand hand) const;
  void leave(Hand hand);

  std::unique_ptr<HandsSession> session_;
  DeviceChoice choice_;
  std::array<std::shared_ptr<HapticDevice>, 2> put_;
  std::shared_ptr<HapticDevice> pedalDevice_;
  std::shared_ptr<const LabelMap> labels_;
  std::optional<ProbeHand> probe_;
  double halfWidth_mm_ = 19;
  bool watched_ = true, attempted_ = false, silent_ = false;
  std::optional<NeedleHand> wish_;
  double advance_mm_ = 0;
  NeedlePlane plane_ = NeedlePlane::Along;
  std::optional<NeedleShown> needle_;
  Transform driven_;
  DeviceState stylus_;  ///< of the needle's device, as seen last
  QTimer timer_, slow_;
  QElapsedTimer clock_;
};

}  // namespace insonate::train
