// The part of the session about what an author says of a case beside its voxels.
#include "../PrepareSession.h"
#include "../edit/Edits.h"

#include <insonate/simulator/ProbePose.h>

namespace insonate::prepare {

bool PrepareSession::lacksStart() const {
  return patient_ && places_.startPoses.empty() && live_.pose();
}

void PrepareSession::keepStart() {
  if (!lacksStart()) return;
  CasePlaces places = places_;
  places.startPoses.push_back(poseOf(*live_.standing()));
  places.startPoses.back().name = tr("start").toStdString();
  setPlaces(std::move(places), tr("start of the case"));
  say(tr("The case begins here; Ctrl+S saves it."));
}

void PrepareSession::setPlaces(CasePlaces places, const QString& what) {
  if (!patient_ || samePlaces(places, places_)) return Q_EMIT placesChanged();  // What was typed goes back.
  undo_.push(new PlacesEdit(*this, std::move(places), what));
}

void PrepareSession::applyPlaces(const CasePlaces& places) {
  places_ = places;
  live_.setStart(places_.startPoses.empty() ? found_ : places_.startPoses.front());
  recheck_.start();
  Q_EMIT placesChanged();
  tellEdits();
}

}  // namespace insonate::prepare
