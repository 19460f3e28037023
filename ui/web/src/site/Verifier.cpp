#include "site/Verifier.h"

#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/teaching/SiteVerification.h>

#include <chrono>

namespace insonate::web {

using namespace std::chrono_literals;

Verifier::Verifier(const CurriculumStore& store) : store_(store), thread_([this] { run(); }) {}

Verifier::~Verifier() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Verifier::run() {
  const VerificationQueue queue(store_);
  for (;;) {
    // A database that fails is tried again; what waits is kept there.
    const bool isBusy = verifyNextAttempt(queue).value_or(false);
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, isBusy ? 0ms : 1000ms, [this] { return isEnding_; })) return;
  }
}

}  // namespace insonate::web
