#pragma once

#include <QImage>
#include <QMetaType>
#include <QString>
#include <QStringList>

namespace insonate::ui {

/// One case of the library, with the facts read so far.
struct LibraryEntry {
  enum class State {
    Waiting,  ///< only folder and title are known so far
    Known,
    Broken  ///< the case cannot be read; `error` says why
  };

  QString place;  ///< the case's folder, or the name of a built-in case
  bool builtIn = false;
  QString title, description;
  int version = 0;  ///< number of the version; 0: no version
  QString date;     ///< date of the version

  State state = State::Waiting;
  QString error;
  QString grade;        ///< grade: "easy", "moderate", "hard" or empty
  bool graded = false;  ///< true: the case's author has set the grade; false: the grade is estimated
  QString reason;       ///< sentence about the reason for the grade or, without a grade, about what is missing
  QStringList structures;
  bool fit = false;
  QStringList errors;        ///< reasons why the case is not fit for training
  QStringList warnings;      ///< what may mislead a trainee
  QImage slice, ultrasound;  ///< null if not available
};

}  // namespace insonate::ui

Q_DECLARE_METATYPE(insonate::ui::LibraryEntry)
