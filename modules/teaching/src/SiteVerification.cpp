#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>
#include <insonate/teaching/RecomputedAttempts.h>
#include <insonate/teaching/SiteVerification.h>

#include <exception>
#include <fstream>
#include <optional>
#include <system_error>
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

std::string whyDifferent(const AttemptFacts& facts, const std::filesystem::path& file, const CompareEvents& events) {
  RecomputedAttempts result;
  if (const auto compared = compareWithRecording(facts, file, result, events); !compared)
    return compared.error().message;
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

/// Tells whether the server has published cases with this title, but no version with these voxels. Of a case that the
/// server does not have, each version counts. Fails if the folder of cases cannot be read.
Result<bool> isOtherVersion(const std::filesystem::path& cases, const std::string& title,
                            const std::string& voxelHash) {
  bool isPublished = false;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(cases, error), end; !error && entry != end; entry.increment(error)) {
    if (publishedVersion(entry->path()) == 0) continue;
    const auto manifest = readCaseManifest(caseForTraining(entry->path()));
    if (!manifest || manifest->title != title) continue;
    if (findPublishedVersion(entry->path(), voxelHash)) return false;
    isPublished = true;
  }
  if (error)
    return fail("The server's folder of cases, " + cases.string() + ", cannot be read: " + error.message() + ".");
  return isPublished;
}

/// Title of a case as facts about attempts state it.
std::string storedTitle(std::string title) {
  AttemptHeader header;
  header.caseName = std::move(title);
  return factsFromHeader(header).caseName;
}

/// A pass on an easier case would not be a pass of the level. Built-in cases are known by their title alone, since
/// their voxels can differ in the last digit between processors.
Result<std::string> whyOnAnotherCase(const VerificationQueue& queue, const AttemptFacts& facts,
                                     const std::filesystem::path& cases) {
  const auto level = queue.levelOf(facts);
  if (!level) return tl::unexpected(level.error());
  if (!*level) return std::string();
  const PhantomVariant* builtIn = phantomVariant((*level)->caseName);
  const std::string title = storedTitle(builtIn ? std::string(builtIn->title) : (*level)->caseName);
  if (facts.caseName != title)
    return "The attempt was made on the case '" + facts.caseName + "', but the case of the level is '" + title + "'.";
  if (builtIn || cases.empty()) return std::string();
  const auto isOther = isOtherVersion(cases, (*level)->caseName, facts.caseHash);
  if (!isOther) return tl::unexpected(isOther.error());
  return *isOther ? "The attempt was made on a version of the case '" + title + "' that the server has not published."
                  : std::string();
}

Result<std::string> whyRefused(const VerificationQueue& queue, const WaitingAttempt& attempt,
                               const std::filesystem::path& cases, const CompareEvents& events) {
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
  if (std::string why = whyDifferent(facts, attempt.recording, events); !why.empty()) return why;
  return whyOnAnotherCase(queue, facts, cases);
}

}  // namespace

Result<std::string> whyNotVerified(const VerificationQueue& queue, const WaitingAttempt& attempt,
                                   const std::filesystem::path& cases, const CompareEvents& events) {
  if (!std::ifstream(attempt.recording))
    return fail(attempt.recording.string() + " cannot be read. Check the server's folder of recordings.");
  auto why = whyRefused(queue, attempt, cases, events);
  if (!why) return why;
  // Sentences about a file begin with its path, which only the server knows.
  const std::string path = attempt.recording.string();
  if (why->starts_with(path)) why->replace(0, path.size(), "The recording");
  return why;
}

Result<bool> verifyNextAttempt(const VerificationQueue& queue, const std::filesystem::path& cases,
                               const CompareEvents& events) {
  const auto attempt = queue.takeNext();
  if (!attempt) return tl::unexpected(attempt.error());
  if (!*attempt) return false;
  std::string why;
  try {
    auto found = whyNotVerified(queue, **attempt, cases, events);
    if (!found) return tl::unexpected(found.error());
    why = std::move(*found);
  } catch (const std::exception& error) {
    why = std::string("The recording cannot be computed again: ") + error.what() + ".";
  }
  if (why == kCancelled) return fail(std::move(why));  // the server ends; the attempt waits for the next one
  const auto concluded = queue.storeResult((*attempt)->facts.id, why.empty(), why);
  return concluded ? Result<bool>(true) : tl::unexpected(concluded.error());
}

}  // namespace insonate
