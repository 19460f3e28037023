#include "site/Verifier.h"

#include "monitoring/FailureLog.h"

#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/teaching/SiteVerification.h>

#include <chrono>
#include <utility>

namespace insonate::web {

using namespace std::chrono_literals;

Verifier::Verifier(const CurriculumStore& store, std::filesystem::path cases, Log log)
    : store_(store), cases_(std::move(cases)), log_(std::move(log)), thread_([this] { run(); }) {}

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
    const auto verified = verifyNextAttempt(queue, cases_);
    if (!verified) logFailure(log_, "verification failed", verified.error().message);
    // A database that fails is tried again; what waits is kept there.
    const auto pause = !verified ? 30s : *verified ? 0s : 1s;
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, pause, [this] { return isEnding_; })) return;
  }
}

}  // namespace insonate::web
