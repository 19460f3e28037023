#pragma once

#include "CasePlaces.h"

#include <QObject>
#include <QString>
#include <optional>

class QUndoCommand;

namespace insonate::prepare {

class LivePatient;
class Notice;
class OpenCase;

/// Kinds of places besides landmarks; the kind of a landmark is its code.
inline const QString kTargetKind = QStringLiteral("target"), kStartPoseKind = QStringLiteral("start pose"),
                     kVesselKind = QStringLiteral("vessel");

/// Edits targets, landmarks, start poses and the grade of the open case.
class PlacesEditor : public QObject {
  Q_OBJECT

 public:
  PlacesEditor(OpenCase& openCase, LivePatient& live, Notice& notice, QObject* parent);

  const CasePlaces& value() const { return places_; }
  void set(CasePlaces places, const QString& what);
  /// If the case has no start pose, makes the probe's pose the start pose, which is saved with the case.
  void keepStart();
  /// Tells whether the case has no start pose although the live image has a pose that could become one.
  bool lacksStart() const;
  /// Adds to `all` an edit that sets these places, if they differ from the present ones.
  void restore(const CasePlaces& places, QUndoCommand& all);
  /// Requests the controls that mark a place of this kind.
  void requestMark(const QString& kind) { Q_EMIT markRequested(kind); }
  /// Announces that the user has chosen what to mark, and that the next click sets its position.
  void beginMarking() { Q_EMIT markingBegun(); }

 Q_SIGNALS:
  void edited();
  void changed();
  void markRequested(const QString& kind);
  void markingBegun();

 private:
  QUndoCommand* edit(CasePlaces places, const QString& what, QUndoCommand* parent);
  void apply(const CasePlaces& places);

  OpenCase& openCase_;
  LivePatient& live_;
  Notice& notice_;
  CasePlaces places_;
  std::optional<StartPose> found_;  ///< initial pose of the probe when the case was opened
};

}  // namespace insonate::prepare
