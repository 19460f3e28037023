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
    Draft,      ///< a curriculum that is being written; may be incomplete
    Published,  ///< a published version, which cannot be changed
    Preset,     ///< supplied with the program; published when an instructor first assigns it to a class
  };
  std::string name{};
  int version = 0;  ///< version; 0 for a draft, whose text contains its future version
  Kind kind = Kind::Published;

  bool operator==(const OfferedCurriculum&) const = default;
};

/// Returns the published curricula, newest version first, and the presets that are not published.
Result<std::vector<OfferedCurriculum>> taughtCurricula(const SignedIn& by);
/// Returns the drafts and then taughtCurricula().
Result<std::vector<OfferedCurriculum>> allCurricula(const SignedIn& by);
Result<std::string> textOf(const SignedIn& by, const OfferedCurriculum& offered);

/// Assigns a published version or a preset to a class.
Result<void> teachBy(const SignedIn& by, const OfferedCurriculum& taught, const std::string& cohort);

/// A draft in its stored state.
struct KeptDraft {
  std::string name{}, text{};
};
/// Returns the draft for the next version after the newest published one. Creates this draft if there is none; an
/// existing draft is returned unchanged.
Result<KeptDraft> draftFrom(const SignedIn& by, const OfferedCurriculum& taught);
/// Creates a draft with one empty level. Fails if a curriculum of this name exists.
Result<KeptDraft> newDraft(const SignedIn& by, const std::string& name);
/// Saves the draft, publishes it and deletes the draft. `before` as in PublishedCurricula::saveDraft().
Result<void> publishDraft(const SignedIn& by, const Curriculum& draft, const std::string& before);

}  // namespace insonate::ui
