#pragma once

#include <QWidget>

class QComboBox;
class QPushButton;

namespace insonate::train {

class ProbeLibrary;
class ImagingModel;

/// List of the built-in and the user's own probes, from which the user selects the probe in use, and a button for
/// editing the probe.
class ProbeChooser : public QWidget {
  Q_OBJECT

 public:
  ProbeChooser(ImagingModel& imaging, ProbeLibrary& library, QWidget* parent = nullptr);

  QComboBox& list() { return *list_; }
  /// Returns the argument with which loadProbe() loads the selected probe, for saving it in settings.
  QString key() const;

 Q_SIGNALS:
  void editRequested();

 private:
  void fill();
  void showCurrent();

  ImagingModel& imaging_;
  ProbeLibrary& library_;
  QComboBox* list_;
  QPushButton* edit_;
};

}  // namespace insonate::train
