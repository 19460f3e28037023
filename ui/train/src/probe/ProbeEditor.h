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

/// Every number of a probe, with the live image as its preview: valid values apply at once, errors are stated beside
/// the control. Undo is the history's.
class ProbeEditor : public ScrollingColumn {
  Q_OBJECT

 public:
  ProbeEditor(StatusLine& status, ImagingModel& imaging, ProbeLibrary& library, QWidget* parent = nullptr);

  /// The probe as edited, valid or not.
  const Probe& draft() const { return draft_; }
  /// Replaces the whole draft, for example by a fitted probe; the image's depth becomes the probe's own.
  void take(const Probe& probe);
  /// Error in the draft, a sentence; empty while the draft is in use.
  QString problem() const;

  bool save();
  bool rename();
  bool remove();
  /// The built-in probe of the draft's shape, or the saved one of its name.
  void reset();

 Q_SIGNALS:
  void done();
  void fitWanted();

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
  std::string savedName_;  ///< of the user's probe that is being edited; empty for none
  QLineEdit* name_ = nullptr;
  QComboBox *shape_ = nullptr, *apodization_ = nullptr;
  std::vector<Row> rows_;
  QVBoxLayout* numbers_ = nullptr;
  QLabel *problem_ = nullptr, *hint_ = nullptr;
  QPushButton *save_ = nullptr, *rename_ = nullptr, *remove_ = nullptr, *reset_ = nullptr;
  bool refreshing_ = false;
};

}  // namespace insonate::train
