// The part of the workspace about an attempt: its panel over the controls, and what it does to the other parts.
#include "TrainParts.h"
#include "attempt/AttemptControl.h"
#include "attempt/AttemptPanel.h"
#include "attempt/AttemptWords.h"
#include "image/CineBar.h"
#include "levels/LevelControl.h"
#include "panel/ControlsPanel.h"
#include "patient3d/PatientViews.h"
#include "probe/ProbeEditor.h"

#include <insonate/ui/Theme.h>

#include <QEvent>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

namespace insonate::train {
namespace {

/// Share of the column's height for the attempt; the controls keep the rest.
constexpr double kShare = 0.62;

/// The column of attempt and controls, which shares its height between them.
class LeftColumn final : public QWidget {
 public:
  LeftColumn(AttemptPanel* attempt, QWidget* controls) : attempt_(attempt) {
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    box->setSpacing(0);
    auto* rule = new QFrame;
    ui::setRole(rule, "rule");
    box->addWidget(attempt);
    box->addWidget(rule);
    box->addWidget(controls, 1);
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    attempt_->setMostHeight(int(kShare * height()));
  }

 private:
  AttemptPanel* attempt_;
};

}  // namespace

QWidget* TrainWorkspace::Parts::buildLeft() {
  left_ = new QStackedWidget;
  panel = new ControlsPanel(model, *library_);
  editor_ = new ProbeEditor(model.status, model.imaging, *library_);
  left_->addWidget(panel);
  left_->addWidget(editor_);
  attemptPanel_ = new AttemptPanel(model.disclosure, model.patientCase, model.imaging, model.live, *attempt, *levels_);
  leftColumn_ = new LeftColumn(attemptPanel_, left_);
  leftColumn_->setObjectName("trainPanel");
  return leftColumn_;
}

void TrainWorkspace::Parts::setCase(std::shared_ptr<const PatientCase> opened) {
  saved_ = nullptr;
  model.patientCase.setCase(std::move(opened), origin);
}

void TrainWorkspace::Parts::takeSaved(std::shared_ptr<const PatientCase> edited) {
  saved_ = std::move(edited);
  takeWaiting();
  if (saved_) model.status.say(tr("The case was saved in Prepare. This attempt continues with the former version."));
}

void TrainWorkspace::Parts::takeWaiting() {
  if (!saved_ || attempt->state() != AttemptControl::State::Idle || (levels_ && levels_->level())) return;
  model.patientCase.setCase(std::exchange(saved_, nullptr), origin);
}

void TrainWorkspace::Parts::connectAttempt() {
  connect(attempt, &AttemptControl::stateChanged, this, [this] {
    showAttempt();
    // Not from within the change itself: the case goes with what belongs to it.
    if (saved_)
      QMetaObject::invokeMethod(
          this, [this] { takeWaiting(); }, Qt::QueuedConnection);
  });
  connect(attempt, &AttemptControl::viewChanged, this, [this] { showAttempt(); });
  connect(&model.disclosure, &DisclosureModel::changed, this, [this] { applyDisclosure(); });
  // A new needle is taken by touching the tray, with the pointer or with the needle itself.
  patient->setTrayTaken([this] { attempt->replaceNeedle(); });
  connect(&model.hands, &HandsControl::needleChanged, this, [this] {
    const auto& held = model.hands.needle();
    const bool used = attempt->isRunning() && attempt->view().needle == NeedlePlace::Used;
    const bool touches = used && held && patient->isOnTray(held->patientFromNeedle.offset);
    // Once a touch: the view hears of the new needle a little later.
    if (!std::exchange(touchesTray_, touches) && touches) attempt->replaceNeedle();
  });
  // Buttons of the device that holds the needle.
  connect(&model.hands, &HandsControl::anatomyTurned, this,
          [this](double across_deg, double up_deg) { patient->turn(across_deg, up_deg); });
  connect(&model.hands, &HandsControl::drawButton, attempt, &AttemptControl::setAspirating);
  connect(attemptPanel_, &AttemptPanel::courseWanted, this, [this] { showCourse(true); });
  connect(attemptPanel_, &AttemptPanel::reviewWanted, &workspace_, &TrainWorkspace::attemptWanted);
}

void TrainWorkspace::Parts::showAttempt() {
  const bool made =
      attempt->state() != AttemptControl::State::Idle && attempt->state() != AttemptControl::State::Starting;
  const NeedlePlace place = made ? attempt->view().needle : NeedlePlace::Clean;
  patient->setNeedleColour(ui::wordsOf(disclosed(place, model.disclosure.current())).colour);
  patient->setTrayVisible(attempt->isRunning());
}

void TrainWorkspace::Parts::applyDisclosure() {
  const bool anatomy = model.disclosure.current().anatomy;
  if (!anatomy && isCtBeside()) setCtBeside(false);
  cine_->setCtBesideOffered(anatomy);
  besideAction_->setEnabled(anatomy);
}

void TrainWorkspace::Parts::endAttempt() {
  attempt->close();
}

}  // namespace insonate::train
