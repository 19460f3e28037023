#pragma once

#include <insonate/cases/PatientCase.h>

#include <QIcon>
#include <QString>

namespace insonate::prepare {

/// The author's data about labels: the meanings of the author's own labels, and the progress on each label. All these
/// data are edited and undone together.
struct LabelTerms {
  OwnLabels own;
  LabelStates states;
  bool operator==(const LabelTerms&) const = default;
};

inline LabelTerms termsOf(const CaseManifest& manifest) {
  return {manifest.ownLabels, manifest.states};
}
inline void putTerms(const LabelTerms& terms, CaseManifest& manifest) {
  manifest.ownLabels = terms.own, manifest.states = terms.states;
}

inline constexpr LabelState kLabelStates[] = {LabelState::NotStarted, LabelState::InProgress, LabelState::Completed,
                                              LabelState::Flagged};
/// stateWord() returns the state as a word, stateIcon() as a symbol that does not depend on color.
QString stateWord(LabelState state);
QIcon stateIcon(LabelState state);

/// Returns the coded term of a structure in the label table: "SNOMED CT 29092000, Vein".
QString termOf(std::uint8_t tissue);

}  // namespace insonate::prepare
