#include "Disclosure.h"

#include "StatusLine.h"

#include <utility>

namespace insonate::train {

Disclosure disclosureOf(Assistance assistance, bool inAttempt) {
  if (!inAttempt) return {};
  return {.steps = assistance == Assistance::Guided,
          .findings = assistance != Assistance::Test,
          .anatomy = assistance != Assistance::Test};
}

DisclosureModel::DisclosureModel(StatusLine& status, QObject* parent) : QObject(parent), status_(status) {}

void DisclosureModel::set(const Disclosure& disclosure) {
  if (std::exchange(current_, disclosure) != disclosure) Q_EMIT changed();
}

bool DisclosureModel::mayShowAnatomy() {
  if (!current_.anatomy) status_.showMessage(tr("During a test, CT and anatomy are hidden."));
  return current_.anatomy;
}

}  // namespace insonate::train
