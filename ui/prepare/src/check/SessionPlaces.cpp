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
  if (!patient_ || samePlaces(places, places_)) return Q_EMIT placesChanged();  // Restores the field.
  undo_.push(new PlacesEdit(*this, std::move(places), what));
}

void PrepareSession::restoreSaid(const Said& said) {
  auto all = std::make_unique<QUndoCommand>(tr("colors, title and places as before"));
  for (int label = 1; label < 256; ++label)
    if (said.looks[std::size_t(label)] != looks_[std::size_t(label)])
      new LookEdit(*this, std::uint8_t(label), said.looks[std::size_t(label)], {}, all.get());
  if (said.title != title_) new TitleEdit(*this, said.title, all.get());
  if (!samePlaces(said.places, places_)) new PlacesEdit(*this, said.places, {}, all.get());
  if (said.terms != terms_) new TermsEdit(*this, said.terms, {}, all.get());
  if (all->childCount() > 0) undo_.push(all.release());
}

void PrepareSession::applyPlaces(const CasePlaces& places) {
  places_ = places;
  live_.setStart(places_.startPoses.empty() ? found_ : places_.startPoses.front());
  recheck_.start();
  Q_EMIT placesChanged();
  notifyEdits();
}

}  // namespace insonate::prepare
