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
  /// Makes the probe's place the case's start pose, if it has none; saved with the case.
  void keepStart();
  /// Tells whether the case has no start pose while the live image has one that could become it.
  bool lacksStart() const;
  /// Adds to `all` an edit that sets other places, if they differ.
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
  std::optional<StartPose> found_;  ///< where the probe began when the case was opened
};

}  // namespace insonate::prepare
