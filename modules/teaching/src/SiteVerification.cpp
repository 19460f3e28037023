#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>
#include <insonate/teaching/RecomputedAttempts.h>
#include <insonate/teaching/SiteVerification.h>

#include <exception>
#include <fstream>
#include <optional>
#include <tuple>
#include <utility>

namespace insonate {
namespace {

/// The code in the nonce proves the header, and the header must be that of this attempt.
std::string whyOfAnother(const AttemptFacts& facts, const std::filesystem::path& file) {
  const auto recording = AttemptRecording::open(file);
  if (!recording) return recording.error().message;
  const AttemptFacts recorded = factsFromHeader(recording->header());
  const auto key = [](const AttemptFacts& of) {
    return std::tie(of.id, of.curriculum, of.curriculumVersion, of.level);
  };
  return key(recorded) == key(facts) ? "" : "The recording is of another attempt or level.";
}

std::string whyDifferent(const AttemptFacts& facts, const std::filesystem::path& file) {
  RecomputedAttempts result;
  if (const auto compared = compareWithRecording(facts, file, result); !compared) return compared.error().message;
  // By this hash a recording counts once; the comparison leaves it out where it is not stored.
  if (facts.handsHash.empty())
    if (const auto fresh = factsOfRecording(file, Hands::PersonOrScript); !fresh || !fresh->handsHash.empty())
      return "The workstation does not state the hash of the hands' motion.";
  if (!result.differences.empty()) {
    const StoreDifference& first = result.differences.front();
    return "The recording gives another " + first.field + ": " + first.expected + " instead of " + first.stored + ".";
  }
  if (!result.notCompared.empty())
    return "The workstation has another version of Insonate than the server: " + result.notCompared.begin()->first +
           ".";
  return {};
}

Result<std::string> whyRefused(const VerificationQueue& queue, const WaitingAttempt& attempt) {
  const AttemptFacts& facts = attempt.facts;
  std::optional<Error> failure;
  const auto originOf = [&](const AttemptFacts& claimed, const std::string& nonce) {
    auto origin = queue.originOf(facts.workstation, claimed, nonce);
    if (!origin) failure = origin.error();
    return origin;
  };
  const auto proof = proofOfAttempt(originOf, facts, attempt.recording);
  if (failure) return tl::unexpected(*failure);
  if (!proof) return proof.error().message;
  if (proof->proof != AttemptProof::Proven) return proof->why;
  if (std::string why = whyOfAnother(facts, attempt.recording); !why.empty()) return why;
  return whyDifferent(facts, attempt.recording);
}

}  // namespace

Result<std::string> whyNotVerified(const VerificationQueue& queue, const WaitingAttempt& attempt) {
  if (!std::ifstream(attempt.recording))
    return fail(attempt.recording.string() + " cannot be read. Check the server's folder of recordings.");
  auto why = whyRefused(queue, attempt);
  if (!why) return why;
  // Sentences about a file begin with its path, which only the server knows.
  const std::string path = attempt.recording.string();
  if (why->starts_with(path)) why->replace(0, path.size(), "The recording");
  return why;
}

Result<bool> verifyNextAttempt(const VerificationQueue& queue) {
  const auto attempt = queue.takeNext();
  if (!attempt) return tl::unexpected(attempt.error());
  if (!*attempt) return false;
  std::string why;
  try {
    auto found = whyNotVerified(queue, **attempt);
    if (!found) return tl::unexpected(found.error());
    why = std::move(*found);
  } catch (const std::exception& error) {
    why = std::string("The recording cannot be computed again: ") + error.what() + ".";
  }
  const auto concluded = queue.storeResult((*attempt)->facts.id, why.empty(), why);
  return concluded ? Result<bool>(true) : tl::unexpected(concluded.error());
}

}  // namespace insonate
