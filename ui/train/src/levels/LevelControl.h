#pragma once

#include "AttemptSaver.h"

#include <insonate/curriculum/Curriculum.h>

#include <QObject>
#include <QString>
#include <optional>
#include <random>
#include <string>

namespace insonate {
struct PatientCase;
}

namespace insonate::train {

class AttemptControl;
class Course;
class CaseModel;
class ImagingModel;
class ProbeMotion;
class StatusLine;

/// Stores the level that the user practices, or no level in free practice. A level sets case, procedure, position and
/// assistance. Opening another case ends the practice of the level. Uses no widgets. May be used only on the window's
/// thread.
class LevelControl final : public QObject {
  Q_OBJECT

 public:
  LevelControl(StatusLine& status, CaseModel& patientCase, ImagingModel& imaging, ProbeMotion& motion,
               AttemptControl& attempt, Course& course, QObject* parent = nullptr);

  /// The level; null in free practice.
  const Level* level() const { return level_ ? &*level_ : nullptr; }
  /// Tells whether the level's case differs from the open case.
  bool waitsForCase() const { return level_ && !fits(); }
  /// Curriculum and level of the next attempt.
  AttemptAim aim() const;

  /// Chooses a level. If the level is locked or an attempt is running, nothing changes and the status line says why.
  void choose(const std::string& level);
  void leave();
  /// Requests the level's case from the window.
  void openCase();

 Q_SIGNALS:
  void changed();
  void caseRequested(const QString& place);

 private:
  bool fits() const;
  void openArrivedCase();
  void caseChanged();
  void courseChanged();
  void arrange();
  void beginWithoutStore();

  StatusLine& status_;
  CaseModel& patientCase_;
  ImagingModel& imaging_;
  ProbeMotion& motion_;
  AttemptControl& attempt_;
  Course& course_;
  std::optional<Level> level_;
  std::mt19937 random_{std::random_device{}()};
  int place_ = -1;  ///< index of the last attempt's start position; the next attempt gets another one
};

}  // namespace insonate::train
