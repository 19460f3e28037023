#include "AttemptFeature.h"

#include "../layout/LeftColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "AttemptControl.h"
#include "AttemptPanel.h"
#include "AttemptStrip.h"
#include "AttemptWords.h"

#include <insonate/ui/Workspace.h>

#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kAttemptGroup = "attempt";

}  // namespace

AttemptFeature::AttemptFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout, {Command::Attempt, Command::Draw, Command::NewNeedle}),
      control_(new AttemptControl(model, {}, this)),
      panel_(new AttemptPanel(model.disclosure, model.patientCase, model.imaging, model.live, *control_)) {
  layout.left().setHead(panel_, [this](int maximum_px) { panel_->setMostHeight(maximum_px); });
  layout.image().add(ImageColumn::Line,
                     new AttemptStrip(model.disclosure, model.hands, model.patientCase, *control_, &layout.image()));
  connect(control_, &AttemptControl::stateChanged, this, [this] {
    showNeedle();
    // Not from within the change itself: the case goes with what belongs to it.
    if (!holdsCase()) QMetaObject::invokeMethod(this, &Feature::caseReleased, Qt::QueuedConnection);
  });
  connect(control_, &AttemptControl::viewChanged, this, [this] { showNeedle(); });
  connect(&model.tray, &NeedleTray::touched, control_, &AttemptControl::replaceNeedle);
  connect(&model.hands, &HandsControl::drawButton, control_, &AttemptControl::setAspirating);
  connect(panel_, &AttemptPanel::reviewWanted, &layout.workspace(), &ui::Workspace::attemptWanted);
}

AttemptFeature::~AttemptFeature() {
  // While those that listen to its end exist.
  delete control_;
}

void AttemptFeature::act(const KeyRow& row, KeyPress press) {
  if (press.repeated) return;
  if (row.command == Command::Attempt) return control_->isRunning() ? control_->finish() : control_->start();
  if (row.command == Command::Draw) return control_->setAspirating(!control_->isAspirating());
  control_->replaceNeedle();
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
