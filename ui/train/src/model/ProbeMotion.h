#pragma once

#include "ProbeControl.h"

#include <QObject>
#include <optional>

namespace insonate::train {

class CaseModel;
class DisclosureModel;
class HandsControl;
class History;
class ImagingModel;
class LiveModel;
class StatusLine;

/// Moves of the probe in the hand, which can be undone. They are refused while the image is frozen, and while a device
/// holds the probe.
class ProbeMotion : public QObject {
  Q_OBJECT

 public:
  struct Models {
    CaseModel& patientCase;
    ImagingModel& imaging;
    LiveModel& live;
    DisclosureModel& disclosure;
    HandsControl& hands;
    History& history;
    StatusLine& status;
  };
  explicit ProbeMotion(const Models& models, QObject* parent = nullptr);

  bool isReady() const { return control_.ready(); }
  HandNumbers numbers() const { return control_.numbers(); }
  ProbeHandState state() const;
  Transform pose() const;

  /// The moves up to the next call are undone together.
  void beginGesture() { control_.begin(); }
  void move(HandAxis axis, double mmOrDegrees);
  void slide(double lateral_mm, double elevation_mm);
  void typed(HandAxis axis, double value);
  void moveTo(Vec3 patient_mm);
  /// Moves to the skin nearest to a typed place; says how far that is.
  void placed(Vec3 patient_mm);
  /// Refused in a level and while anatomy is not disclosed: a position reveals the place of vessels.
  void goTo(const StartPose& pose);
  /// Moves to CaseModel::start(), or to the start of the attempt.
  void home();

  /// Puts the probe at the start of an attempt at a level; until releaseStart(), home() returns there, undo ends
  /// there, and goTo() refuses. A device's probe stays in place.
  void beginAt(const ProbeHandState& state);
  void releaseStart() { levelStart_.reset(); }
  /// The target of an attempt is the vein nearest to here: the probe, or in a level the case's own start, since beside
  /// the vein another may be nearer.
  Vec3 targetNear_mm() const;
  /// The probe as home() would put it at the case's own start.
  std::optional<ProbeHand> handAtStart() const;

  /// The case has no start pose and none was found: the probe waits for placeOnSkin().
  bool isUnplaced() const { return unplaced_.has_value(); }
  /// Moves to the skin nearest to the front; further moves start there.
  void placeOnSkin();

 Q_SIGNALS:
  void handMoved();       ///< also when it is there for the first time
  void placingChanged();  ///< isUnplaced()

 private:
  void connectCase();
  void connectHands();
  std::optional<QString> stateInWords() const;
  void moved(HandMove result);
  bool mayMove();
  void giveHands();
  void giveProbe();
  void rememberMove(const ProbeHandState& before);

  Models models_;
  ProbeControl control_;
  std::optional<ProbeHandState> levelStart_;
  std::optional<ProbeHand> unplaced_;
};

}  // namespace insonate::train
