#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace insonate::train {

class AttemptControl;
class LevelControl;
class StepList;
class CaseModel;
class DisclosureModel;
class ImagingModel;
class LiveModel;
class VerdictView;

/// The panel above the controls: choice of the procedure, then steps with instructions and errors, then the result. In
/// a test it discloses nothing before the end.
class AttemptPanel final : public QWidget {
  Q_OBJECT

 public:
  AttemptPanel(DisclosureModel& disclosure, CaseModel& patientCase, ImagingModel& imaging, LiveModel& live,
               AttemptControl& attempt, LevelControl& levels, QWidget* parent = nullptr);

  /// Beside the result.
  VerdictView& verdict() { return *verdict_; }

  /// Maximum height; the panel takes as much as its text needs.
  void setMostHeight(int most_px);

 Q_SIGNALS:
  /// A finished attempt's file is to be shown.
  void reviewWanted(const QString& file);
  /// Levels are to be seen.
  void courseWanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildBegin();
  QWidget* buildRunning();
  QWidget* buildHands();
  QWidget* buildResult();
  QPushButton* button(const char* object, const QString& text, const QString& says);
  void refresh();
  void refreshBegin();
  void refreshRunning();
  void refreshNumbers();
  void refreshResult();
  void fit();

  DisclosureModel& disclosure_;
  CaseModel& patientCase_;
  ImagingModel& imaging_;
  LiveModel& live_;
  AttemptControl& attempt_;
  LevelControl& levels_;
  int most_px_ = 400;
  QWidget *begin_ = nullptr, *running_ = nullptr, *result_ = nullptr;
  QComboBox *procedure_ = nullptr, *assistance_ = nullptr, *position_ = nullptr;
  QPushButton *start_ = nullptr, *draw_ = nullptr, *review_ = nullptr;
  QLabel *unfit_ = nullptr, *head_ = nullptr, *numbers_ = nullptr, *headline_ = nullptr, *advice_ = nullptr,
         *errors_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  StepList* steps_ = nullptr;
  VerdictView* verdict_ = nullptr;
};

}  // namespace insonate::train
