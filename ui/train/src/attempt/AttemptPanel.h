#pragma once

#include "StandingError.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class AttemptControl;
class StepList;
class CaseModel;
class DisclosureModel;
class HapticControl;
class ImagingModel;
class LiveModel;

/// The panel above the controls. Before an attempt it shows the choice of procedure, during the attempt the steps with
/// instructions and errors, after the attempt the result. In test mode the panel discloses nothing before the end of
/// the attempt.
class AttemptPanel final : public QWidget {
  Q_OBJECT

 public:
  AttemptPanel(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase, ImagingModel& imaging,
               LiveModel& live, AttemptControl& attempt, const ui::Commands& commands, QWidget* parent = nullptr);

  /// Adds a card above the choice of the procedure.
  void addCard(QWidget* card);
  /// Adds a verdict below the errors in the result, and a button beside the buttons of the result.
  void addToResult(QWidget* verdict, QWidget* button);
  /// Adds a switch that concerns guided attempts only.
  void addGuideOption(QWidget* option);
  /// Dismisses the error that stays on the screen (StandingError), if there is one.
  void dismissError();
  /// Hides the choice of procedure and assistance while a level determines both.
  void setProcedureFixed(bool isFixed);

  /// Sets the maximum height. If its text needs less, the panel is only as high as the text.
  void setMostHeight(int max_px);

 Q_SIGNALS:
  /// Emitted when the user wants to see the recording of a finished attempt.
  void reviewRequested(const QString& file);
  /// Emitted repeatedly while an attempt runs. `object`: object name of the control for the trainee's next action;
  /// empty: there is no control, or the action is not disclosed.
  void actControlNamed(const QString& object);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildBegin();
  QWidget* buildRunning();
  QWidget* buildHands();
  QWidget* buildStanding();
  QWidget* buildResult();
  QPushButton* button(const char* object, const QString& text, const QString& says);
  void refresh();
  void refreshBegin();
  void refreshRunning();
  void refreshNumbers();
  bool refreshStanding();
  void refreshResult();
  void fit();
  int besideMessages_px(int width_px) const;
  void scrollToDueStep();

  DisclosureModel& disclosure_;
  HapticControl& hands_;
  CaseModel& patientCase_;
  ImagingModel& imaging_;
  LiveModel& live_;
  AttemptControl& attempt_;
  const ui::Commands& commands_;
  bool isProcedureFixed_ = false;
  int max_px_ = 400;
  QWidget *begin_ = nullptr, *running_ = nullptr, *result_ = nullptr;
  QComboBox *procedure_ = nullptr, *assistance_ = nullptr, *position_ = nullptr;
  QPushButton *start_ = nullptr, *draw_ = nullptr, *review_ = nullptr;
  QLabel *unfit_ = nullptr, *head_ = nullptr, *numbers_ = nullptr, *headline_ = nullptr, *advice_ = nullptr,
         *errors_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  StandingError standing_;
  QWidget *standingBox_ = nullptr, *guideOptions_ = nullptr;
  QLabel* standingText_ = nullptr;
  StepList* steps_ = nullptr;
  QVBoxLayout *beginBox_ = nullptr, *resultBox_ = nullptr;
  QHBoxLayout* resultButtons_ = nullptr;
};

}  // namespace insonate::train
