#pragma once

#include <QDialog>
#include <QString>

namespace insonate::ui {

/// Contents of the question about changes that would be lost; all may be empty.
struct Loss {
  QString job;           ///< what is being done: "Importing neck-ct"
  QString ending;        ///< a sentence on what ends before its time, as an attempt that is being made
  QString title;         ///< of a case that is not on disk as it is in the window
  bool nowhere = false;  ///< that case is not on disk at all

  bool isWork() const { return !job.isEmpty() || !ending.isEmpty(); }
  explicit operator bool() const { return isWork() || !title.isEmpty(); }
};

enum class LostBy { Closing, Opening };

/// Asks before the window closes, or another case takes the place of the one that is open, over something that would be
/// lost. Stops nothing meanwhile.
class LossQuestion : public QDialog {
  Q_OBJECT

 public:
  LossQuestion(const Loss& loss, LostBy by, QWidget* parent);

 Q_SIGNALS:
  void continueChosen();
  void saveChosen();
};

}  // namespace insonate::ui
