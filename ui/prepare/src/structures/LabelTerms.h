#pragma once

#include <insonate/cases/PatientCase.h>

#include <QIcon>
#include <QString>

namespace insonate::prepare {

/// The author's terms of labels: meaning of own labels, and progress on each. Edited and undone as a whole.
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
/// The state as a word, and as a glyph that shows it without color.
QString stateWord(LabelState state);
QIcon stateIcon(LabelState state);

/// "SNOMED CT 29092000, Vein", of a structure of the label table.
QString termOf(std::uint8_t tissue);

}  // namespace insonate::prepare
