#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <vector>

/// Queries about curricula to the store, on the account's thread.
namespace insonate::ui {

/// A curriculum that can be selected.
struct OfferedCurriculum {
  enum class Kind {
    Draft,      ///< is being written; may be unfinished
    Published,  ///< fixed
    Preset,     ///< comes with the program; published by whoever first teaches by it
  };
  std::string name{};
  int version = 0;  ///< of a draft 0: what it will be stands in it
  Kind kind = Kind::Published;

  bool operator==(const OfferedCurriculum&) const = default;
};

/// Published curricula, newest version first, and presets that are not published.
Result<std::vector<OfferedCurriculum>> taughtCurricula(const SignedIn& by);
/// Drafts, then taughtCurricula().
Result<std::vector<OfferedCurriculum>> allCurricula(const SignedIn& by);
Result<std::string> textOf(const SignedIn& by, const OfferedCurriculum& offered);

/// The published version, or preset, becomes that of a class.
Result<void> teachBy(const SignedIn& by, const OfferedCurriculum& taught, const std::string& cohort);

/// A draft as the store has it.
struct KeptDraft {
  std::string name{}, text{};
};
/// A draft of the version after the newest that is published; one that is there already is not touched.
Result<KeptDraft> draftFrom(const SignedIn& by, const OfferedCurriculum& taught);
/// One with a first level that is still to be written. Fails where there is something of this name.
Result<KeptDraft> newDraft(const SignedIn& by, const std::string& name);
/// Saved as it is, published, and no longer a draft. `before` as in PublishedCurricula::saveDraft().
Result<void> publishDraft(const SignedIn& by, const Curriculum& draft, const std::string& before);

}  // namespace insonate::ui
