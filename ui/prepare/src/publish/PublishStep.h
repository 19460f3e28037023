#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

struct PrepareModel;

/// The last step of a case: publishes the saved, fit case as the version that trainees get until another one is
/// published.
class PublishStep : public QWidget {
 public:
  /// Shows the published version in `mark`.
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
  int published_ = 0;  ///< number of that version; 0 for none
  bool isLatest_ = false;
  bool wasUnsaved_ = false;
};

}  // namespace insonate::prepare
