#pragma once

#include <QImage>
#include <QMetaType>
#include <QString>
#include <QStringList>

namespace insonate::ui {

/// One case of the library, as far as it is known.
struct LibraryEntry {
  enum class State {
    Waiting,  ///< nothing but its place and title is known yet
    Known,
    Broken  ///< trouble says why
  };

  QString place;  ///< its folder, or the name of a built-in one
  bool builtIn = false;
  QString title, description;
  int version = 0;  ///< 0 for none
  QString date;     ///< of the version

  State state = State::Waiting;
  QString trouble;
  QString grade;        ///< "easy", "moderate", "hard" or empty
  bool graded = false;  ///< by its author, not estimated
  QString reason;       ///< for the grade, a sentence; what is missing where there is none
  QStringList structures;
  bool fit = false;
  QStringList errors;  ///< what makes it unfit
  int doubts = 0;
  QImage slice, ultrasound;  ///< null where there is none
};

}  // namespace insonate::ui

Q_DECLARE_METATYPE(insonate::ui::LibraryEntry)
