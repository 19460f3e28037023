#include "RecordingOrigin.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/teaching/AttemptFactsOf.h>

#include <filesystem>
#include <utility>

namespace insonate::review {

Result<RecordingOrigin> readOrigin(const SignedIn& by, const std::string& file, const std::string& expected) {
  const auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  const AttemptStore attempts(by);
  const auto id = expected.empty() ? attempts.ofRecording(std::filesystem::path(file).filename().string(), *hash)
                                   : Result<std::string>(expected);
  if (!id) return tl::unexpected(id.error());
  RecordingOrigin origin;
  if (id->empty()) return origin;
  auto kept = attempts.attempt(*id);
  if (!kept) return tl::unexpected(kept.error());
  origin.attempt = std::move(kept->facts);
  origin.same = origin.attempt->recordingHash == *hash;
  auto person = PeopleStore(by).person(origin.attempt->person);
  if (!person) return tl::unexpected(person.error());
  origin.person = std::move(*person);
  auto forms = FormStore(by).ofAttempt(*id);
  if (!forms) return tl::unexpected(forms.error());
  origin.forms = std::move(*forms);
  return origin;
}

}  // namespace insonate::review
