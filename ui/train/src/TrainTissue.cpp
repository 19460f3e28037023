// The part of the session that is about tissue and blood.
#include "TrainSession.h"

#include <insonate/tissue/NeedleTable.h>

#include <utility>

namespace insonate::train {

bool TrainSession::pulsates() const {
  return watched_ && (tissue_.pulse || tissue_.breathing);
}

LiveOptions TrainSession::liveOptions() const {
  LiveOptions options;
  options.physiology = physiologyOf(tissue_);
  options.pulsating = pulsates();
  options.resting = !awake_;
  return options;
}

void TrainSession::setTissue(const TissueChoice& choice) {
  if (choice == tissue_) return;
  if (auto ok = checkPhysiology(choice.body); !ok) {
    say(QString::fromStdString(ok.error().message));
    Q_EMIT tissueChanged();  // Numbers that cannot be go back.
    return;
  }
  const auto exchange = [this, other = tissue_]() mutable {
    const TissueChoice now = tissue_;
    useTissue(std::exchange(other, now));
    return true;
  };
  history_.add(tr("setting of the tissue").toStdString(), exchange, "tissue");
  useTissue(choice);
}

void TrainSession::useTissue(const TissueChoice& choice) {
  const bool otherModel = choice.model != tissue_.model;
  tissue_ = choice;
  updateTissueRequest();
  if (otherModel) sendSetup();
  Q_EMIT tissueChanged();
}

AttemptSettings TrainSession::attemptSettings() const {
  AttemptSettings all;
  all.setup = setup();
  all.setup.engine = shown_->engine;
  all.physiology = physiologyOf(tissue_);
  all.pulsating = pulsates();
  all.bloodTime_s = shown_->time_s;
  all.needle = needlePresetNames().front();
  return all;
}

void TrainSession::setMeshWanted(bool wanted) {
  if (std::exchange(meshWanted_, wanted) != wanted) updateTissueRequest();
}

void TrainSession::setWatched(bool watched) {
  hands_.setWatched(watched);
  if (std::exchange(watched_, watched) != watched) updateTissueRequest();
}

void TrainSession::setAwake(bool awake) {
  awake_ = awake;
  if (feed_.live()) feed_.live()->setResting(!awake);
}

void TrainSession::updateTissueRequest() {
  LiveImaging* live = feed_.live();
  if (!live) return;
  live->setKeepMesh(meshWanted_ && watched_);
  live->setPulsating(pulsates());
  // Also where it is the same: a probe at rest then makes an image with its mesh.
  if (auto ok = live->setPhysiology(physiologyOf(tissue_)); !ok) say(QString::fromStdString(ok.error().message));
}

}  // namespace insonate::train
