#include "StructureList.h"

#include "../labels/LabelSession.h"
#include "CaseMeasuring.h"
#include "Notice.h"
#include "OpenCase.h"
#include "TermsEditor.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <utility>

namespace insonate::prepare {

StructureList::StructureList(OpenCase& openCase, const CaseMeasuring& measuring, LabelSession& labeling,
                             TermsEditor& terms, Notice& notice, QObject* parent)
    : QObject(parent), openCase_(openCase), measuring_(measuring), labeling_(labeling), terms_(terms), notice_(notice) {
  connect(&openCase_, &OpenCase::opened, this, [this] {
    labels_.clear();
    added_.reset();
    selected_ = 0;
  });
  connect(&measuring_, &CaseMeasuring::changed, this, [this] { refresh(); });
  connect(&terms_, &TermsEditor::ownLabelsEdited, this, [this] { refresh(); });
  connect(&labeling_, &LabelSession::changed, this, [this](const LabelChange& change) {
    const LabelSet before = added_;
    added_ |= change.labels;
    added_.reset(kBackground);
    if (added_ != before) refresh();
  });
}

bool StructureList::isListed(std::uint8_t label) const {
  return std::ranges::find(labels_, label) != labels_.end();
}

void StructureList::refresh() {
  std::vector<std::uint8_t> found;
  for (int number = 1; number < 256; ++number) {
    const auto label = std::uint8_t(number);
    if (added_.test(label) || measuring_.hasVoxels(label) || terms_.value().own.contains(label)) found.push_back(label);
  }
  if (found == labels_) return;
  labels_ = std::move(found);
  const bool gone = !isListed(selected_);
  if (!labels_.empty() && (selected_ == 0 || (gone && isOwnLabel(selected_)))) selected_ = labels_.front();
  Q_EMIT changed();
  Q_EMIT selectedChanged();
}

void StructureList::select(std::uint8_t label) {
  if (label == selected_) return;
  selected_ = label;
  Q_EMIT selectedChanged();
}

void StructureList::selectNext(int step) {
  if (labels_.empty()) return;
  const auto here = std::ranges::find(labels_, selected_);
  const int last = int(labels_.size()) - 1;
  const int index = here == labels_.end() ? 0 : int(here - labels_.begin()) + step;
  select(labels_[std::size_t(std::clamp(index, 0, last))]);
}

void StructureList::add(std::uint8_t label) {
  if (!openCase_.patient() || label == kBackground) return;
  if (isOwnLabel(label)) {
    LabelTerms terms = terms_.value();
    terms.own.try_emplace(label);
    terms_.set(std::move(terms), tr("add a structure"));
  } else {
    added_.set(label);
    refresh();
  }
  select(label);
}

void StructureList::removeVoxels(std::uint8_t label) {
  if (isOwnLabel(label) && !measuring_.hasVoxels(label) && !labeling_.isBusy()) {
    LabelTerms terms = terms_.value();
    terms.own.erase(label), terms.states.erase(label);
    added_.reset(label);
    return terms_.set(std::move(terms), tr("remove %1").arg(terms_.nameOf(label)));
  }
  LabelStep step;
  step.label = label;
  step.tool = step::Logical{LogicalOperation::kSubtract, label};
  if (label == step.rest) step.rest = kBackground;
  labeling_.run(std::move(step), tr("remove %1").arg(terms_.nameOf(label)));
}

void StructureList::toNextState(std::uint8_t label) {
  if (!isListed(label)) return;
  const auto next = (std::size_t(terms_.stateOf(label)) + 1) % std::size(kLabelStates);
  terms_.setState(label, kLabelStates[next]);
  notice_.showMessage(tr("%1: %2").arg(terms_.nameOf(label), stateWord(terms_.stateOf(label))));
}

}  // namespace insonate::prepare
