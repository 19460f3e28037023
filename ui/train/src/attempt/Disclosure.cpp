#include "Disclosure.h"

namespace insonate::train {

Disclosure disclosureOf(Assistance assistance, bool inAttempt) {
  if (!inAttempt) return {};
  return {.steps = assistance == Assistance::Guided,
          .findings = assistance != Assistance::Test,
          .anatomy = assistance != Assistance::Test};
}

}  // namespace insonate::train
