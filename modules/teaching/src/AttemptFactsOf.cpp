#include "HandsHash.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>

#include <sodium/crypto_hash_sha256.h>
#include <sodium/utils.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <limits>

namespace insonate {
namespace {

/// Parses AttemptHeader::begun; 0 if it is not a time.
std::int64_t timeOf(const std::string& iso8601) {
  std::tm utc{};
  const char* end = ::strptime(iso8601.c_str(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return end && *end == '\0' ? std::int64_t{1'000'000} * ::timegm(&utc) : 0;
}

}  // namespace

Result<std::string> recordingHash(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  std::array<char, 65536> part;
  do {
    stream.read(part.data(), part.size());
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(part.data()),
                              static_cast<unsigned long long>(stream.gcount()));
  } while (stream);
  if (!stream.eof()) return fail(file.string() + " cannot be read; check its permissions.");
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash;
  crypto_hash_sha256_final(&state, hash.data());
  std::array<char, 2 * crypto_hash_sha256_BYTES + 1> digits;
  return std::string(sodium_bin2hex(digits.data(), digits.size(), hash.data(), hash.size()));
}

namespace {

/// Shortens the title of a case, which may be any text, to the store's limit, so that no attempt is refused for its
/// title.
std::string keptName(std::string title) {
  constexpr std::size_t kMost = 1000;
  std::ranges::replace(title, '\0', ' ');
  if (title.size() <= kMost) return title;
  std::size_t end = kMost;
  const auto isWithinLetter = [&](std::size_t at) { return (static_cast<unsigned char>(title[at]) & 0xc0) == 0x80; };
  while (end > 0 && isWithinLetter(end)) --end;
  title.resize(end);
  return title;
}

Result<Procedure> rulesOf(const std::filesystem::path& file, const AttemptHeader& header) {
  auto procedure = builtInProcedure(header.procedure);
  if (!procedure)
    return fail(file.string() +
                " cannot be scored, since this program does not know its procedure: " + procedure.error().message);
  if (procedure->version < header.procedureVersion)
    return fail(file.string() + " was made by version " + std::to_string(header.procedureVersion) +
                " of the procedure '" + header.procedure + "', which is at version " +
                std::to_string(procedure->version) + " here; score it with the program that made it, " +
                header.software + ", or a newer one.");
  return procedure;
}

}  // namespace

AttemptFacts factsFromHeader(const AttemptHeader& header) {
  AttemptFacts facts;
  facts.procedure = header.procedure, facts.procedureVersion = header.procedureVersion;
  facts.caseName = keptName(header.caseName), facts.caseHash = header.caseHash;
  facts.begun_us = timeOf(header.begun);
  const RecordedFor& whose = header.recordedFor;
  facts.id = whose.attempt, facts.person = whose.person;
  facts.curriculum = whose.curriculum, facts.curriculumVersion = whose.curriculumVersion, facts.level = whose.level;
  return facts;
}

void addEnding(AttemptFacts& facts, AttemptStatus status, std::int64_t length_us, const AttemptScore& score) {
  facts.state = status == AttemptStatus::Completed ? AttemptState::Completed : AttemptState::Abandoned;
  facts.length_us = length_us;
  facts.succeeded = score.succeeded;
  facts.criticalErrors = static_cast<int>(score.criticalErrors.size());
  facts.points = score.points;
  facts.metrics.clear();
  for (const MetricScore& metric : score.metrics) {
    const MetricDefinition& definition = metricTable()[static_cast<std::size_t>(metric.metric)];
    facts.metrics.push_back({std::string(definition.id), definition.version, metric.value});
  }
}

Result<void> addRecording(AttemptFacts& facts, const std::filesystem::path& file) {
  auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  facts.recording = file.filename().string();
  facts.recordingHash = std::move(*hash);
  const auto recording = AttemptRecording::open(file);
  const auto hands = recording ? handsHash(*recording) : Result<std::string>(tl::unexpected(recording.error()));
  facts.handsHash = hands.value_or("");  // a damaged recording is still stored, with the hash of its file
  return {};
}

Result<AttemptFacts> factsOfRecording(const std::filesystem::path& file, Hands hands) {
  const auto recording = AttemptRecording::open(file);
  if (!recording) return tl::unexpected(recording.error());
  if (recording->header().isScripted && hands == Hands::Person)
    return fail(
        file.string() +
        " was recorded from a script ('session --script'): it is a demonstration and does not count for any person. "
        "Replay it with 'replay', or choose the recording of an attempt that a person made.");
  auto procedure = rulesOf(file, recording->header());
  if (!procedure) return tl::unexpected(procedure.error());
  const int version = procedure->version;
  ProcedureRun run(std::move(*procedure), recording->header().picture, recording->header().vessels);
  const auto played = recording->play(
      std::numeric_limits<std::int64_t>::max(),
      [&](const RecordingSegment::Entry& entry) { std::visit([&](const auto& what) { run.add(what); }, entry); });
  if (!played) return tl::unexpected(played.error());
  AttemptFacts facts = factsFromHeader(recording->header());
  facts.procedureVersion = version;
  addEnding(facts, recording->status(), recording->end_us(), computeScore(run, recording->status()));
  if (auto added = addRecording(facts, file); !added) return tl::unexpected(added.error());
  return facts;
}

Result<void> takeRecording(AttemptFacts& facts, const std::filesystem::path& file) {
  auto recorded = factsOfRecording(file);
  if (!recorded) return tl::unexpected(recorded.error());
  const auto recording = AttemptRecording::open(file);
  if (!recording) return tl::unexpected(recording.error());
  recorded->procedureVersion = recording->header().procedureVersion;
  recorded->id = facts.id, recorded->person = facts.person, recorded->workstation = facts.workstation;
  recorded->curriculum = facts.curriculum, recorded->curriculumVersion = facts.curriculumVersion;
  recorded->level = facts.level;
  facts = std::move(*recorded);
  return {};
}

}  // namespace insonate
