#pragma once

#include <QDialog>
#include <QString>

namespace insonate::ui {

/// Data and activities that would be lost, about which the user is asked before closing the window or opening another
/// case. All members may be empty.
struct Loss {
  QString job;           ///< title of the running job: "Importing neck-ct"
  QString ending;        ///< sentence about an activity that would end, for example an attempt in progress
  QString title;         ///< title of a case with unsaved changes
  bool nowhere = false;  ///< true: the case in `title` has never been saved to disk

  bool isWork() const { return !job.isEmpty() || !ending.isEmpty(); }
  explicit operator bool() const { return isWork() || !title.isEmpty(); }
};

enum class LostBy { Closing, Opening, Cropping };

/// Asks the user before something is lost because the window closes or another case opens. The work continues
/// meanwhile.
class DiscardPrompt : public QDialog {
  Q_OBJECT

 public:
  DiscardPrompt(const Loss& loss, LostBy by, QWidget* parent);

 Q_SIGNALS:
  void continueChosen();
  void saveChosen();
};

}  // namespace insonate::ui
