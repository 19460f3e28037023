#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

struct PrepareModel;

/// The last step of preparing a case: publishes the saved case, if it is fit for training. Trainees get this version
/// until another is published.
class PublishStep : public QWidget {
 public:
  /// `mark` shows the published version.
  PublishStep(PrepareModel& shared, ui::TaskBar& tasks, QLabel& mark, QWidget* parent = nullptr);

 private:
  QString obstacle() const;
  void publish();
  void refresh();
  void readVersions();

  PrepareModel& shared_;
  ui::TaskBar& tasks_;
  QLabel& mark_;
  QPushButton* publish_;
  int published_ = 0;  ///< number of the published version; 0: none
  bool isLatest_ = false;
  bool wasUnsaved_ = false;
};

}  // namespace insonate::prepare
