#pragma once

#include <QWidget>

class QComboBox;
class QPushButton;

namespace insonate::train {

class ProbeLibrary;
class ImagingModel;

/// List of the built-in and the user's own probes, which selects the probe in use, and the button that edits it.
class ProbeChooser : public QWidget {
  Q_OBJECT

 public:
  ProbeChooser(ImagingModel& imaging, ProbeLibrary& library, QWidget* parent = nullptr);

  QComboBox& list() { return *list_; }
  /// Returns the selected probe's argument for loadProbe(), to be saved in settings.
  QString key() const;

 Q_SIGNALS:
  void editWanted();

 private:
  void fill();
  void showCurrent();

  ImagingModel& imaging_;
  ProbeLibrary& library_;
  QComboBox* list_;
  QPushButton* edit_;
};

}  // namespace insonate::train
