#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A published version of a curriculum, without its text.
struct CurriculumEntry {
  std::string name{};  ///< name of the curriculum (Curriculum::name)
  int version = 0;
  std::string hash{};  ///< SHA-256 of the curriculum's text, hexadecimal
  std::int64_t published_us = 0;
  std::string publishedBy{};  ///< full name of the publisher

  bool operator==(const CurriculumEntry&) const = default;
};

/// Access to curricula (JSON texts) in the database, with the permissions of a signed-in user. A published version
/// never changes; a changed curriculum is published as the next version. All users may read published versions;
/// instructors and administrators may also read drafts and publish. If the workstation belongs to a server, curricula
/// can be published on the server only.
class PublishedCurricula {
 public:
  explicit PublishedCurricula(SignedIn by) : by_(std::move(by)) {}

  /// Returns all published versions, sorted by name, newest version first.
  Result<std::vector<CurriculumEntry>> list() const;
  /// Returns the JSON text of a published version. Fails if there is none, or if its hash shows that the stored text
  /// was changed.
  Result<std::string> text(const std::string& name, int version) const;
  /// Publishes a version of a curriculum. `text` must be accepted by parseCurriculum(), contain this name and version
  /// and have at most 1 MB; it is stored byte for byte. Version numbers must rise; publishing the same text again is no
  /// error.
  Result<CurriculumEntry> publish(const std::string& name, int version, const std::string& text) const;

  /// Saves the draft of a curriculum: any text of at most 1 MB. For each name there is one draft, which all instructors
  /// share. `before`: the text of the draft as the caller last read it; "": there was no draft. Fails if another user
  /// has saved a different draft since then.
  Result<void> saveDraft(const std::string& name, const std::string& text, const std::string& before) const;
  /// Returns the names of all drafts.
  Result<std::vector<std::string>> drafts() const;
  /// Returns the text of the draft with this name; fails if there is none.
  Result<std::string> draft(const std::string& name) const;
  /// Deletes a draft. `before`: as for saveDraft(); fails if another user has changed the draft since then.
  Result<void> discardDraft(const std::string& name, const std::string& before) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
