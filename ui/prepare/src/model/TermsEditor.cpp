#include "TermsEditor.h"

#include "CaseMeasuring.h"
#include "Notice.h"
#include "OpenCase.h"
#include "Structures.h"
#include "ValueEdit.h"

#include <insonate/tissue/Labels.h>

#include <utility>

namespace insonate::prepare {

TermsEditor::TermsEditor(OpenCase& openCase, const CaseMeasuring& measuring, Notice& notice, QObject* parent)
    : QObject(parent), openCase_(openCase), measuring_(measuring), notice_(notice) {
  connect(&openCase_, &OpenCase::opened, this,
          [this] { terms_ = openCase_.patient() ? termsOf(openCase_.patient()->manifest) : LabelTerms{}; });
}

void TermsEditor::set(LabelTerms terms, const QString& what) {
  if (!openCase_.patient() || terms == terms_) return Q_EMIT changed();  // Restores the field.
  openCase_.undoStack().push(edit(std::move(terms), what, nullptr));
}

void TermsEditor::restore(const LabelTerms& terms, QUndoCommand& all) {
  if (terms != terms_) edit(terms, {}, &all);
}

QUndoCommand* TermsEditor::edit(LabelTerms terms, const QString& what, QUndoCommand* parent) {
  return new ValueEdit<LabelTerms>(
      terms_, std::move(terms), [this](const LabelTerms& value) { apply(value); }, what, parent);
}

void TermsEditor::apply(const LabelTerms& terms) {
  const bool otherTissues = terms.own != terms_.own;
  terms_ = terms;
  if (otherTissues) Q_EMIT ownLabelsEdited();
  Q_EMIT changed();
}

QString TermsEditor::nameOf(std::uint8_t label) const {
  return isOwnLabel(label) ? QString::fromStdString(labelName(terms_.own, label)) : structureName(label);
}

LabelState TermsEditor::stateOf(std::uint8_t label) const {
  return insonate::stateOf(terms_.states, label, measuring_.hasVoxels(label));
}

void TermsEditor::setName(std::uint8_t label, const QString& name) {
  if (!isOwnLabel(label)) return;
  const std::string tidy = tidyLabelName(name.toStdString());
  for (int other = 1; other < 256; ++other)
    if (other != label && !tidy.empty() && nameOf(std::uint8_t(other)) == QString::fromStdString(tidy)) {
      notice_.showMessage(
          tr("A structure named %1 already exists; choose another name.").arg(QString::fromStdString(tidy)));
      return Q_EMIT changed();
    }
  LabelTerms terms = terms_;
  terms.own[label].name = tidy;
  set(std::move(terms), tr("name of %1").arg(nameOf(label)));
}

void TermsEditor::setTissue(std::uint8_t label, std::uint8_t tissue) {
  if (!isOwnLabel(label) || tissue == kBackground) return;
  LabelTerms terms = terms_;
  terms.own[label].tissue = knownLabel(tissue);
  set(std::move(terms), tr("tissue of %1").arg(nameOf(label)));
}

void TermsEditor::setState(std::uint8_t label, LabelState state) {
  LabelTerms terms = terms_;
  terms.states[label] = state;
  set(std::move(terms), tr("state of %1").arg(nameOf(label)));
}

}  // namespace insonate::prepare
