#include "AttemptFeature.h"

#include "../layout/LeftColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "AttemptControl.h"
#include "AttemptPanel.h"
#include "AttemptStrip.h"
#include "AttemptWords.h"
#include "ControlMark.h"

#include <insonate/ui/Workspace.h>

#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kAttemptGroup = "attempt";

}  // namespace

AttemptFeature::AttemptFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout), control_(new AttemptControl(model, {}, this)) {
  addCommands();
  panel_ = new AttemptPanel(model.disclosure, model.hands, model.patientCase, model.imaging, model.live, *control_,
                            commands());
  layout.left().setHead(panel_, [this](int maximum_px) { panel_->setMostHeight(maximum_px); });
  layout.image().add(ImageColumn::Line, new AttemptStrip(model.disclosure, model.hands, model.patientCase, *control_,
                                                         commands(), &layout.image()));
  connect(control_, &AttemptControl::stateChanged, this, [this] {
    showNeedle();
    // Not from within the change itself: the case goes with what belongs to it.
    if (!holdsCase()) QMetaObject::invokeMethod(this, &Feature::caseReleased, Qt::QueuedConnection);
  });
  connect(control_, &AttemptControl::viewChanged, this, [this] { showNeedle(); });
  connect(&model.tray, &NeedleTray::touched, control_, &AttemptControl::replaceNeedle);
  connect(&model.hands, &HandsControl::aspirateButtonChanged, control_, &AttemptControl::setAspirating);
  auto* mark = new ControlMark(layout.workspace());
  connect(panel_, &AttemptPanel::actControlNamed, mark, &ControlMark::pointAt);
  connect(panel_, &AttemptPanel::reviewWanted, &layout.workspace(), &ui::Workspace::attemptWanted);
}

AttemptFeature::~AttemptFeature() {
  // While those that listen to its end exist.
  delete control_;
}

void AttemptFeature::addCommands() {
  beginSection(KeySection::Attempts);
  addCommand({.id = "train.attempt.startOrFinish",
              .text = {},
              .does = tr("starts an attempt, or finishes it"),
              .listed = tr("Ctrl+Return"),
              .keys = keys({Qt::Key_Return, Qt::Key_Enter}, Qt::ControlModifier),
              .perform = once([this] { control_->isRunning() ? control_->finish() : control_->start(); })});
  addCommand({.id = "train.attempt.aspirate",
              .text = {},
              .does = tr("aspirates with the syringe, or stops"),
              .listed = tr("B"),
              .keys = keys({Qt::Key_B}),
              .perform = once([this] { control_->setAspirating(!control_->isAspirating()); })});
  addCommand({.id = "train.attempt.newNeedle",
              .text = {},
              .does = tr("takes a new needle from the tray once the old one is out of the skin"),
              .listed = tr("U"),
              .keys = keys({Qt::Key_U}),
              .perform = once([this] { control_->replaceNeedle(); })});
}

void AttemptFeature::showNeedle() {
  using State = AttemptControl::State;
  const bool isMade = control_->state() != State::Idle && control_->state() != State::Starting;
  const NeedlePlace place = isMade ? control_->view().needle : NeedlePlace::Clean;
  model_.tray.set(control_->isRunning(), disclosed(place, model_.disclosure.current()));
}

QString AttemptFeature::endsWithTheCase() const {
  if (!control_->isRunning()) return {};
  return tr("An attempt is in progress in Train. Continuing ends it and saves it as abandoned.");
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
  settings.endGroup();
}

void AttemptFeature::restore(QSettings& settings) {
  settings.beginGroup(kAttemptGroup);
  control_->restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
