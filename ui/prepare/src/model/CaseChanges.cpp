#include "CaseChanges.h"

#include "../labels/LabelSession.h"
#include "OpenCase.h"
#include "PlacesEditor.h"
#include "StructureAppearance.h"
#include "StructureList.h"
#include "TermsEditor.h"

#include <utility>

namespace insonate::prepare {

CaseChanges::CaseChanges(const Sources& sources, QObject* parent) : QObject(parent), from_(sources) {
  const auto check = [this] { refresh(); };
  connect(&from_.openCase, &OpenCase::shown, this, check);
  connect(&from_.openCase, &OpenCase::saved, this, check);
  connect(&from_.openCase, &OpenCase::titleChanged, this, check);
  connect(&from_.appearance, &StructureAppearance::lookChanged, this, check);
  connect(&from_.terms, &TermsEditor::changed, this, check);
  connect(&from_.places, &PlacesEditor::changed, this, check);
  connect(&from_.labeling, &LabelSession::changed, this, check);
}

bool CaseChanges::isUnsaved() const {
  const auto& patient = from_.openCase.patient();
  if (!patient) return false;
  return from_.openCase.title().toStdString() != patient->manifest.title ||
         !samePlaces(from_.places.value(), placesOf(patient->manifest)) ||
         from_.terms.value() != termsOf(patient->manifest) || from_.labeling.isChanged() ||
         colorsDiffer(from_.appearance.looks(), from_.structures.labels(), patient->colors);
}

ui::CaseEdit CaseChanges::unsavedEdit() const {
  if (!isUnsaved()) return {};
  return [title = from_.openCase.title().toStdString(), looks = from_.appearance.looks(),
          structures = from_.structures.labels(), places = from_.places.value(), terms = from_.terms.value(),
          labels = from_.labeling.isChanged() ? from_.labeling.snapshot() : nullptr](PatientCase& copy) {
    if (labels) copy.labels = *labels;
    putPlaces(places, copy.manifest);
    putTerms(terms, copy.manifest);
    copy.manifest.title = title;
    putColors(looks, structures, copy.colors);
  };
}

ui::CaseEdit CaseChanges::unpromptedEdit() const {
  const auto& structures = from_.structures.labels();
  const StructureLooks& looks = from_.appearance.looks();
  if (!from_.openCase.patient() || !shownDiffers(looks, from_.appearance.savedLooks(), structures)) return {};
  return [looks, structures](PatientCase& copy) { putShown(looks, structures, copy.manifest.shown); };
}

void CaseChanges::refresh() {
  const std::array<bool, 2> has{isUnsaved(), unpromptedEdit() != nullptr};
  if (has != std::exchange(has_, has)) Q_EMIT changed();
}

}  // namespace insonate::prepare
