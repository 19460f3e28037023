#include "store/FailureNotes.h"

#include <insonate/curriculum/DatabaseFailures.h>

#include <utility>

namespace insonate {
namespace {

thread_local DatabaseFailures* innermostFailures = nullptr;

}  // namespace

DatabaseFailures::DatabaseFailures() : outer_(std::exchange(innermostFailures, this)) {}

DatabaseFailures::~DatabaseFailures() {
  innermostFailures = outer_;
}

void store::noteDatabaseFailure(const Error& error) {
  if (innermostFailures) innermostFailures->add(error.message);
}

}  // namespace insonate
