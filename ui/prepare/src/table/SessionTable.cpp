// The part of the session about the table of structures: which there are, and what the author says of them.
#include "../PrepareSession.h"
#include "../edit/Edits.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>

namespace insonate::prepare {

QString PrepareSession::nameOf(std::uint8_t label) const {
  return isOwnLabel(label) ? QString::fromStdString(labelName(terms_.own, label)) : structureName(label);
}

LabelState PrepareSession::stateOf(std::uint8_t label) const {
  return insonate::stateOf(terms_.states, label, hasVoxels(label));
}

bool PrepareSession::hasVoxels(std::uint8_t label) const {
  const auto& measures = measuring_.measures();
  return measures && measures->statistics.voxels[label] > 0;
}

void PrepareSession::setTerms(LabelTerms terms, const QString& what) {
  if (!patient_ || terms == terms_) return Q_EMIT termsChanged();  // Restores the field.
  undo_.push(new TermsEdit(*this, std::move(terms), what));
}

void PrepareSession::applyTerms(const LabelTerms& terms) {
  const bool otherTissues = terms.own != terms_.own;
  terms_ = terms;
  if (otherTissues) {
    live_.setOwnLabels(terms_.own);
    recheck_.start();
    listStructures();
  }
  Q_EMIT termsChanged();
  Q_EMIT messageChanged();
  notifyEdits();
}

void PrepareSession::setName(std::uint8_t label, const QString& name) {
  if (!isOwnLabel(label)) return;
  const std::string tidy = tidyLabelName(name.toStdString());
  for (int other = 1; other < 256; ++other)
    if (other != label && !tidy.empty() && nameOf(std::uint8_t(other)) == QString::fromStdString(tidy)) {
      say(tr("There is a structure with the name %1 already; choose another one.").arg(QString::fromStdString(tidy)));
      return Q_EMIT termsChanged();
    }
  LabelTerms terms = terms_;
  terms.own[label].name = tidy;
  setTerms(std::move(terms), tr("name of %1").arg(nameOf(label)));
}

void PrepareSession::setTissue(std::uint8_t label, std::uint8_t tissue) {
  if (!isOwnLabel(label) || tissue == kBackground) return;
  LabelTerms terms = terms_;
  terms.own[label].tissue = knownLabel(tissue);
  setTerms(std::move(terms), tr("tissue of %1").arg(nameOf(label)));
}

void PrepareSession::setState(std::uint8_t label, LabelState state) {
  LabelTerms terms = terms_;
  terms.states[label] = state;
  setTerms(std::move(terms), tr("state of %1").arg(nameOf(label)));
}

void PrepareSession::toNextState(std::uint8_t label) {
  if (std::ranges::find(structures_, label) == structures_.end()) return;
  const auto next = (std::size_t(stateOf(label)) + 1) % std::size(kLabelStates);
  setState(label, kLabelStates[next]);
  say(tr("%1: %2").arg(nameOf(label), stateWord(stateOf(label))));
}

void PrepareSession::addStructure(std::uint8_t label) {
  if (!patient_ || label == kBackground) return;
  if (isOwnLabel(label)) {
    LabelTerms terms = terms_;
    terms.own.try_emplace(label);
    setTerms(std::move(terms), tr("another structure"));
  } else {
    added_.set(label);
    listStructures();
  }
  select(label);
}

void PrepareSession::setLocked(std::uint8_t label, bool locked) {
  LabelRules rules = labelling_.rules();
  rules.locked.set(label, locked);
  labelling_.setRules(rules);
}

void PrepareSession::removeVoxels(std::uint8_t label) {
  if (isOwnLabel(label) && !hasVoxels(label) && !labelling_.isBusy()) {
    LabelTerms terms = terms_;
    terms.own.erase(label), terms.states.erase(label);
    added_.reset(label);
    return setTerms(std::move(terms), tr("remove %1").arg(nameOf(label)));
  }
  LabelStep step;
  step.label = label;
  step.tool = step::Logical{LogicalOperation::kSubtract, label};
  if (label == step.rest) step.rest = kBackground;
  labelling_.run(std::move(step), tr("remove %1").arg(nameOf(label)));
}

void PrepareSession::listStructures() {
  std::vector<std::uint8_t> found;
  for (int number = 1; number < 256; ++number) {
    const auto label = std::uint8_t(number);
    if (added_.test(label) || hasVoxels(label) || terms_.own.contains(label)) found.push_back(label);
  }
  if (found == structures_) return;
  structures_ = std::move(found);
  const bool gone = std::ranges::find(structures_, selected_) == structures_.end();
  if (!structures_.empty() && (selected_ == 0 || (gone && isOwnLabel(selected_)))) selected_ = structures_.front();
  Q_EMIT structuresChanged();
  Q_EMIT selectedChanged();
}

void PrepareSession::select(std::uint8_t label) {
  if (label == selected_) return;
  selected_ = label;
  Q_EMIT selectedChanged();
}

void PrepareSession::selectNext(int step) {
  if (structures_.empty()) return;
  const auto here = std::ranges::find(structures_, selected_);
  const int last = int(structures_.size()) - 1;
  const int index = here == structures_.end() ? 0 : int(here - structures_.begin()) + step;
  select(structures_[std::size_t(std::clamp(index, 0, last))]);
}

}  // namespace insonate::prepare
