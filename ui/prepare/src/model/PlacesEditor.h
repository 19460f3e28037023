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

/// Edits targets, landmarks, start poses and the grade of the open case.
class PlacesEditor : public QObject {
  Q_OBJECT

 public:
  PlacesEditor(OpenCase& openCase, LivePatient& live, Notice& notice, QObject* parent);

  const CasePlaces& value() const { return places_; }
  void set(CasePlaces places, const QString& what);
  /// If the case has no start pose, makes the probe's pose its start pose, to be saved with the case.
  void keepStart();
  /// Tells whether the case has no start pose although the live image has a pose that could become one.
  bool lacksStart() const;
  /// Adds to `all` an edit that sets these places, if they differ from the present ones.
  void restore(const CasePlaces& places, QUndoCommand& all);

 Q_SIGNALS:
  void edited();
  void changed();

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
