#pragma once

#include "ProbeControl.h"

#include <QObject>
#include <optional>

namespace insonate::train {

class CaseModel;
class DisclosureModel;
class HapticControl;
class History;
class ImagingModel;
class LiveModel;
class StatusLine;

/// Undoable moves of the probe. Moves are refused while the image is frozen, or while a device moves the probe.
class ProbeMotion : public QObject {
  Q_OBJECT

 public:
  static constexpr double kDrag_degPerPx = 0.25;  ///< rotation per pixel of a mouse drag

  struct Models {
    CaseModel& patientCase;
    ImagingModel& imaging;
    LiveModel& live;
    DisclosureModel& disclosure;
    HapticControl& hands;
    History& history;
    StatusLine& status;
  };
  explicit ProbeMotion(const Models& models, QObject* parent = nullptr);

  bool isReady() const { return control_.ready(); }
  HandNumbers numbers() const { return control_.numbers(); }
  ProbePlacementState state() const;
  Transform pose() const;

  /// Begins a gesture. All moves until the next call are undone together.
  void beginGesture() { control_.begin(); }
  void move(HandAxis axis, double mmOrDegrees);
  void slide(double lateral_mm, double elevation_mm);
  void typed(HandAxis axis, double value);
  void moveTo(Vec3 patient_mm);
  /// Moves the probe to the skin nearest to a typed point, and shows the distance between point and skin.
  void placed(Vec3 patient_mm);
  /// Moves to a saved position. Refused in a level and while anatomy is not disclosed, since a position reveals where
  /// vessels are.
  void goTo(const StartPose& pose);
  /// Moves to CaseModel::start() or, in a level, to the start of the attempt.
  void home();

  /// Moves the probe to the start of an attempt at a level. Until releaseStart(), home() returns to this start, undo
  /// cannot go back before it, and goTo() is refused. A probe that a device moves stays where it is.
  void beginAt(const ProbePlacementState& state);
  void releaseStart();
  bool isStartHeld() const { return levelStart_.has_value(); }
  /// Returns the position that determines the target of an attempt: the target is the vein nearest to this position.
  /// The position is that of the probe or, in a level, that of the case's start pose, since another vein may be nearer
  /// to the level's start.
  Vec3 targetNear_mm() const;
  /// Returns the ProbePlacement with the probe at the case's start pose; empty if there is no ProbePlacement.
  std::optional<ProbePlacement> handAtStart() const;

  /// Tells whether the case has no start pose and none was found; the probe then waits for placeOnSkin().
  bool isUnplaced() const { return unplaced_.has_value(); }
  /// Places the probe on the skin nearest to the front, from where it can be moved.
  void placeOnSkin();

 Q_SIGNALS:
  void handMoved();         ///< emitted when the probe has moved, or was placed for the first time
  void startHeldChanged();  ///< emitted when isStartHeld() has changed
  void placingChanged();    ///< emitted when isUnplaced() has changed

 private:
  void connectCase();
  void connectHands();
  std::optional<QString> stateInWords() const;
  void moved(MoveResult result);
  bool mayMove();
  void giveHands();
  void giveProbe();
  void rememberMove(const ProbePlacementState& before);

  Models models_;
  ProbeControl control_;
  std::optional<ProbePlacementState> levelStart_;
  std::optional<ProbePlacement> unplaced_;
};

}  // namespace insonate::train
