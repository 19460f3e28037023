#include "AttemptFeature.h"

#include "../layout/LeftColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "AimOverlay.h"
#include "AttemptControl.h"
#include "AttemptPanel.h"
#include "AttemptStrip.h"
#include "AttemptWords.h"
#include "ControlMark.h"

#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QCheckBox>
#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kAttemptGroup = "attempt";
constexpr double kSlip_s = 1;

}  // namespace

AttemptFeature::AttemptFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout), control_(new AttemptControl(model, {}, this)) {
  addCommands();
  panel_ = new AttemptPanel(model.disclosure, model.hands, model.patientCase, model.imaging, model.live, *control_,
                            commands());
  layout.left().setHead(panel_, [this](int maximum_px) { panel_->setMostHeight(maximum_px); });
  layout.image().add(ImageColumn::Line, new AttemptStrip(model.disclosure, model.hands, model.patientCase, *control_,
                                                         commands(), &layout.image()));
  buildAim();
  connect(control_, &AttemptControl::stateChanged, this, [this] {
    showNeedle();
    // Not from within the change itself: the case goes with what belongs to it.
    if (!holdsCase()) QMetaObject::invokeMethod(this, &Feature::caseReleased, Qt::QueuedConnection);
  });
  connect(control_, &AttemptControl::viewChanged, this, [this] { showNeedle(); });
  connect(&model.tray, &NeedleTray::touched, control_, &AttemptControl::replaceNeedle);
  connect(&model.hands, &HapticControl::aspirateButtonChanged, control_, &AttemptControl::setAspirating);
  auto* mark = new ControlMark(layout.workspace());
  connect(panel_, &AttemptPanel::actControlNamed, mark, &ControlMark::pointAt);
  connect(panel_, &AttemptPanel::reviewRequested, &layout.workspace(), &ui::Workspace::attemptRequested);
}

AttemptFeature::~AttemptFeature() {
  // While those that listen to its end exist.
  delete control_;
}

void AttemptFeature::buildAim() {
  aim_ = new AimOverlay(model_.disclosure, model_.live, *control_, layout_.views().image(), this);
  QAction* action = addSwitch("train.attempt.aim", [this] { return aim_->isOn(); });
  auto* box = new QCheckBox(tr("Aim line"));
  box->setObjectName("attemptAim");
  box->setFocusPolicy(Qt::TabFocus);
  box->setToolTip(commands().toolTip("train.attempt.aim"));
  panel_->addGuideOption(box);
  const auto show = [action, box](bool isOn) {
    action->setChecked(isOn);
    box->setChecked(isOn);
  };
  show(aim_->isOn());
  connect(aim_, &AimOverlay::switched, box, show);
  connect(box, &QCheckBox::clicked, aim_, &AimOverlay::setOn);
  connect(&model_.disclosure, &DisclosureModel::changed, action,
          [this, action] { action->setEnabled(model_.disclosure.current().steps); });
}

void AttemptFeature::addCommands() {
  beginSection(KeySection::Attempts);
  addCommand({.id = "train.attempt.startOrFinish",
              .text = {},
              .does = tr("starts or finishes an attempt"),
              .listed = tr("Ctrl+Return"),
              .keys = keys({Qt::Key_Return, Qt::Key_Enter}, Qt::ControlModifier),
              .perform = once([this] { startOrFinish(); })});
  addCommand({.id = "train.attempt.aspirate",
              .text = {},
              .does = tr("starts or stops aspiration with the syringe"),
              .listed = tr("B"),
              .keys = keys({Qt::Key_B}),
              .perform = once([this] { control_->setAspirating(!control_->isAspirating()); })});
  addCommand({.id = "train.attempt.newNeedle",
              .text = {},
              .does = tr("takes a new needle from the tray, after the old needle was withdrawn from the skin"),
              .listed = tr("U"),
              .keys = keys({Qt::Key_U}),
              .perform = once([this] { control_->replaceNeedle(); })});
  addCommand(
      {.id = "train.attempt.aim",
       .text = tr("Aim line"),
       .does = tr("in a guided attempt, shows or hides the line along which the needle would advance, over the image"),
       .listed = tr("Ctrl+G"),
       .keys = keys({Qt::Key_G}, Qt::ControlModifier),
       .perform = once([this] { aim_->setOn(!aim_->isOn()); }),
       .isAvailable = [this] { return isPatientShown() && model_.disclosure.current().steps; }});
  addCommand({.id = "train.attempt.dismiss",
              .text = {},
              .does = tr("dismisses the error message at the top of the attempt panel"),
              .listed = tr("Backspace"),
              .keys = keys({Qt::Key_Backspace}),
              .perform = once([this] { panel_->dismissError(); }),
              .isAvailable = [this] { return isPatientShown() && control_->isRunning(); }});
}

/// The key that starts an attempt also finishes it. A second press right after the start is a slip, which would store a
/// failed attempt.
void AttemptFeature::startOrFinish() {
  if (!control_->isRunning()) return control_->start();
  if (control_->view().time_s < kSlip_s)
    return model_.status.showMessage(tr("The attempt has just begun. Press Ctrl+Return later to finish it."));
  control_->finish();
}

void AttemptFeature::showNeedle() {
  using State = AttemptControl::State;
  const bool isMade = control_->state() != State::Idle && control_->state() != State::Starting;
  const NeedlePlace place = isMade ? control_->view().needle : NeedlePlace::Clean;
  model_.tray.set(control_->isRunning(), disclosed(place, model_.disclosure.current()));
}

QString AttemptFeature::interruptionWarning() const {
  if (!control_->isRunning()) return {};
  return tr("An attempt is in progress in Train. If you continue, the attempt ends and is saved as abandoned.");
}

bool AttemptFeature::holdsCase() const {
  return control_->state() != AttemptControl::State::Idle;
}

bool AttemptFeature::needsImages() const {
  return control_->isRunning();
}

void AttemptFeature::stop() {
  control_->close();
}

void AttemptFeature::save(QSettings& settings) const {
  settings.beginGroup(kAttemptGroup);
  control_->save(settings);
  settings.setValue("aim", aim_->isOn());
  settings.endGroup();
}

void AttemptFeature::restore(QSettings& settings) {
  settings.beginGroup(kAttemptGroup);
  control_->restore(settings);
  aim_->setOn(settings.value("aim", true).toBool());
  settings.endGroup();
}

}  // namespace insonate::train
