#include "Edits.h"

#include "../PrepareSession.h"

#include <utility>

namespace insonate::prepare {
namespace {

/// Steps of a drag come faster than this, separate wishes slower.
constexpr std::chrono::milliseconds kOneDrag{700};

}  // namespace

LookEdit::LookEdit(PrepareSession& session, std::uint8_t label, const StructureLook& after, const QString& what,
                   QUndoCommand* parent)
    : QUndoCommand(what, parent), session_(session), label_(label), before_(session.look(label)), after_(after) {}

void LookEdit::undo() {
  session_.applyLook(label_, before_);
}

void LookEdit::redo() {
  session_.applyLook(label_, after_);
}

bool LookEdit::mergeWith(const QUndoCommand* other) {
  const auto& next = static_cast<const LookEdit&>(*other);
  StructureLook onlyOpacity = before_;
  onlyOpacity.opacity = next.after_.opacity, onlyOpacity.onSlices = next.after_.onSlices;
  if (next.label_ != label_ || onlyOpacity != next.after_ || next.when_ - when_ > kOneDrag) return false;
  after_ = next.after_, when_ = next.when_;
  setObsolete(before_ == after_);
  return true;
}

TitleEdit::TitleEdit(PrepareSession& session, const QString& after, QUndoCommand* parent)
    : QUndoCommand(PrepareSession::tr("title"), parent), session_(session), before_(session.title()), after_(after) {}

void TitleEdit::undo() {
  session_.applyTitle(before_);
}

void TitleEdit::redo() {
  session_.applyTitle(after_);
}

PlacesEdit::PlacesEdit(PrepareSession& session, CasePlaces after, const QString& what, QUndoCommand* parent)
    : QUndoCommand(what, parent), session_(session), before_(session.places()), after_(std::move(after)) {}

void PlacesEdit::undo() {
  session_.applyPlaces(before_);
}

void PlacesEdit::redo() {
  session_.applyPlaces(after_);
}

TermsEdit::TermsEdit(PrepareSession& session, LabelTerms after, const QString& what, QUndoCommand* parent)
    : QUndoCommand(what, parent), session_(session), before_(session.terms()), after_(std::move(after)) {}

void TermsEdit::undo() {
  session_.applyTerms(before_);
}

void TermsEdit::redo() {
  session_.applyTerms(after_);
}

}  // namespace insonate::prepare
