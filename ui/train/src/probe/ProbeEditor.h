#pragma once

#include "../layout/ScrollingColumn.h"

#include <insonate/ultrasound/Probe.h>

#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace insonate::ui {
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

class ProbeLibrary;
class ImagingModel;
class StatusLine;

/// Editor of all numbers of a probe, with the live image as preview. Valid values apply at once; errors are shown
/// beside the control. Changes are undone by History.
class ProbeEditor : public ScrollingColumn {
  Q_OBJECT

 public:
  ProbeEditor(StatusLine& status, ImagingModel& imaging, ProbeLibrary& library, QWidget* parent = nullptr);

  /// The edited probe, which may be invalid.
  const Probe& draft() const { return draft_; }
  /// Replaces the whole edited probe, for example by a fitted probe. The image gets the new probe's default depth.
  void take(const Probe& probe);
  /// Returns an error message about the edited probe; empty if the probe is in use.
  QString problem() const;

  bool save();
  bool rename();
  bool remove();
  /// Restores the saved probe of this name, else the built-in probe of this name, else the built-in probe of this
  /// shape.
  void reset();

 Q_SIGNALS:
  void done();
  void fitRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Row {
    const ProbeField* field;
    ui::ValueSlider* slider;
  };
  void buildHead(QVBoxLayout& box);
  void buildNumbers(QVBoxLayout& box);
  QWidget* buildFoot();
  void changed(const ProbeField& field, double value);
  void changeShape(int shape);
  void changeName();
  void use(const std::string& what, QWidget* beside);
  void show(const Probe& probe);
  void showButtons();
  void complain(const QString& sentence, QWidget* beside);
  bool report(const Result<void>& result, const QString& done);

  StatusLine& status_;
  ImagingModel& imaging_;
  ProbeLibrary& library_;
  Probe draft_;
  std::string savedName_;  ///< name of the user's probe that is being edited; empty: none
  QLineEdit* name_ = nullptr;
  QComboBox *shape_ = nullptr, *apodization_ = nullptr;
  std::vector<Row> rows_;
  QVBoxLayout* numbers_ = nullptr;
  QLabel *problem_ = nullptr, *hint_ = nullptr;
  QPushButton *save_ = nullptr, *rename_ = nullptr, *remove_ = nullptr, *reset_ = nullptr;
  bool refreshing_ = false;
};

}  // namespace insonate::train
