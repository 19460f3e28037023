#pragma once

#include <QDialog>
#include <QString>

namespace insonate::ui {

/// What would be lost; job or title may be empty.
struct Loss {
  QString job;           ///< what is being done: "Importing neck-ct"
  QString title;         ///< of a case that is not on disk as it is in the window
  bool nowhere = false;  ///< that case is not on disk at all

  explicit operator bool() const { return !job.isEmpty() || !title.isEmpty(); }
};

enum class LostBy { Closing, Opening };

/// Asks before the window closes, or another case takes the place of the one that is open, over something that would be
/// lost. Stops nothing meanwhile.
class LossQuestion : public QDialog {
  Q_OBJECT

 public:
  LossQuestion(const Loss& loss, LostBy by, QWidget* parent);

 Q_SIGNALS:
  void goOnChosen();
  void saveChosen();
};

}  // namespace insonate::ui
