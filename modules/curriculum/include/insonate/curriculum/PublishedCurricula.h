#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

struct CurriculumEntry {
  std::string name{};  ///< as in the curriculum's text
  int version = 0;
  std::string hash{};  ///< SHA-256 of the curriculum's text, hexadecimal
  std::int64_t published_us = 0;
  std::string publishedBy{};  ///< full name of the publisher

  bool operator==(const CurriculumEntry&) const = default;
};

/// Curricula as JSON texts. A published version is fixed; a change is another version, made from a draft. Everyone
/// reads published versions; instructors and administrators see drafts and publish. On a workstation that belongs to a
/// server, curricula are published on the server.
class PublishedCurricula {
 public:
  explicit PublishedCurricula(SignedIn by) : by_(std::move(by)) {}

  /// Returns all curricula by name, newest version first.
  Result<std::vector<CurriculumEntry>> list() const;
  /// Returns the text of a version. Also fails if the text differs from the published text.
  Result<std::string> text(const std::string& name, int version) const;
  /// Publishes a version. `text` is valid for parseCurriculum(), has this name and version and at most 1 MB; it is
  /// stored byte for byte. Version numbers must rise; publishing the same text again is no error.
  Result<CurriculumEntry> publish(const std::string& name, int version, const std::string& text) const;

  /// Saves the draft of this name. There is one draft for each name, shared by instructors; it may be any text of at
  /// most 1 MB. `before` is the draft as the caller last read it, "" if there was none. Fails if another user has saved
  /// a different draft since, so that it is not overwritten unseen.
  Result<void> saveDraft(const std::string& name, const std::string& text, const std::string& before) const;
  Result<std::vector<std::string>> drafts() const;
  Result<std::string> draft(const std::string& name) const;
  Result<void> discardDraft(const std::string& name, const std::string& before) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
