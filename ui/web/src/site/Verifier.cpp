#include "site/Verifier.h"

#include "background/Pause.h"
#include "monitoring/FailureLog.h"

#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/simulator/EventCheck.h>
#include <insonate/teaching/SiteVerification.h>

#include <chrono>
#include <string_view>
#include <utility>

namespace insonate::web {

using namespace std::chrono_literals;

Verifier::Verifier(const CurriculumStore& store, std::filesystem::path cases, Log log)
    : store_(store),
      cases_(std::move(cases)),
      log_(std::move(log)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void Verifier::run(const std::stop_token& stop) {
  const VerificationQueue queue(store_);
  EventCheck check({cases_});
  const CompareEvents events = [&](const AttemptRecording& recording, const Progress&) {
    return check.compare(recording, [&](std::string_view, double) { return !stop.stop_requested(); });
  };
  for (;;) {
    const auto verified = verifyNextAttempt(queue, cases_, events);
    if (!verified && !stop.stop_requested()) logFailure(log_, "verification failed", verified.error().message);
    // A database that fails is tried again; what waits is kept there.
    if (!pauseUnlessStopped(stop, !verified ? 30s : *verified ? 0s : 1s)) return;
  }
}

}  // namespace insonate::web
