#include "PlacesEditor.h"

#include "LivePatient.h"
#include "Notice.h"
#include "OpenCase.h"
#include "ValueEdit.h"

#include <insonate/simulator/ProbePose.h>

#include <utility>

namespace insonate::prepare {

PlacesEditor::PlacesEditor(OpenCase& openCase, LivePatient& live, Notice& notice, QObject* parent)
    : QObject(parent), openCase_(openCase), live_(live), notice_(notice) {
  connect(&openCase_, &OpenCase::opened, this, [this] {
    places_ = openCase_.patient() ? placesOf(openCase_.patient()->manifest) : CasePlaces{};
    found_.reset();
  });
  connect(&openCase_, &OpenCase::saved, this, &PlacesEditor::changed);
  connect(&live_, &LivePatient::started, this, [this] { found_ = live_.start(); });
}

void PlacesEditor::set(CasePlaces places, const QString& what) {
  if (!openCase_.patient() || samePlaces(places, places_)) return Q_EMIT changed();  // Restores the field.
  openCase_.undoStack().push(edit(std::move(places), what, nullptr));
}

void PlacesEditor::restore(const CasePlaces& places, QUndoCommand& all) {
  if (!samePlaces(places, places_)) edit(places, {}, &all);
}

bool PlacesEditor::lacksStart() const {
  return openCase_.patient() && places_.startPoses.empty() && live_.pose();
}

void PlacesEditor::keepStart() {
  if (!lacksStart()) return;
  CasePlaces places = places_;
  places.startPoses.push_back(toStartPose(*live_.standing()));
  places.startPoses.back().name = tr("start").toStdString();
  set(std::move(places), tr("start pose"));
  notice_.showMessage(tr("The probe's pose is now the start pose; Ctrl+S saves the start pose."));
}

QUndoCommand* PlacesEditor::edit(CasePlaces places, const QString& what, QUndoCommand* parent) {
  return new ValueEdit<CasePlaces>(
      places_, std::move(places), [this](const CasePlaces& value) { apply(value); }, what, parent);
}

void PlacesEditor::apply(const CasePlaces& places) {
  places_ = places;
  live_.setStart(places_.startPoses.empty() ? found_ : places_.startPoses.front());
  Q_EMIT edited();
  Q_EMIT changed();
}

}  // namespace insonate::prepare
