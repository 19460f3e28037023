#include "CaseChanges.h"

#include "../labels/LabelSession.h"
#include "OpenCase.h"
#include "PlacesEditor.h"
#include "StructureAppearance.h"
#include "StructureList.h"
#include "TermsEditor.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace insonate::prepare {
namespace {

/// All labels: colors and display settings can change before the voxels are counted, for example when unsaved work is
/// restored.
const std::vector<std::uint8_t>& allLabels() {
  static const std::vector<std::uint8_t> all = [] {
    std::vector<std::uint8_t> labels(255);
    std::iota(labels.begin(), labels.end(), std::uint8_t{1});
    return labels;
  }();
  return all;
}

/// The listed structures, and others whose display settings differ from the saved ones.
std::vector<std::uint8_t> shownLabels(const StructureLooks& looks, const StructureLooks& saved,
                                      std::vector<std::uint8_t> listed) {
  for (const std::uint8_t label : allLabels())
    if (std::ranges::find(listed, label) == listed.end() && shownDiffers(looks, saved, {label}))
      listed.push_back(label);
  return listed;
}

}  // namespace

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
         colorsDiffer(from_.appearance.looks(), allLabels(), patient->colors);
}

ui::CaseEdit CaseChanges::unsavedEdit() const {
  if (!isUnsaved()) return {};
  return [title = from_.openCase.title().toStdString(), looks = from_.appearance.looks(), places = from_.places.value(),
          terms = from_.terms.value(),
          labels = from_.labeling.isChanged() ? from_.labeling.snapshot() : nullptr](PatientCase& copy) {
    if (labels) copy.labels = *labels;
    putPlaces(places, copy.manifest);
    putTerms(terms, copy.manifest);
    copy.manifest.title = title;
    putColors(looks, allLabels(), copy.colors);
  };
}

ui::CaseEdit CaseChanges::unpromptedEdit() const {
  const StructureLooks &looks = from_.appearance.looks(), &saved = from_.appearance.savedLooks();
  if (!from_.openCase.patient() || !shownDiffers(looks, saved, allLabels())) return {};
  return [looks, structures = shownLabels(looks, saved, from_.structures.labels())](PatientCase& copy) {
    putShown(looks, structures, copy.manifest.shown);
  };
}

void CaseChanges::putValues(CaseManifest& manifest, LabelColors& colors) const {
  putPlaces(from_.places.value(), manifest);
  putTerms(from_.terms.value(), manifest);
  manifest.title = from_.openCase.title().toStdString();
  const StructureLooks &looks = from_.appearance.looks(), &saved = from_.appearance.savedLooks();
  putColors(looks, allLabels(), colors);
  if (shownDiffers(looks, saved, allLabels()))
    putShown(looks, shownLabels(looks, saved, from_.structures.labels()), manifest.shown);
}

void CaseChanges::refresh() {
  const std::array<bool, 2> has{isUnsaved(), unpromptedEdit() != nullptr};
  if (has != std::exchange(has_, has)) Q_EMIT changed();
  Q_EMIT edited();
}

}  // namespace insonate::prepare
