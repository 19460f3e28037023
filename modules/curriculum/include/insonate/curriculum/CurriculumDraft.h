#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Reads an unfinished curriculum that curriculumText() wrote. Texts and levels may be missing, and prerequisites may
/// be circular; levels are returned in the order in which they are written.
Result<Curriculum> parseDraft(std::string_view json);

/// Reason why an unfinished curriculum cannot be published.
struct DraftError {
  std::string level{};  ///< level concerned (Level::name); "": the curriculum as a whole
  std::string sentence{};

  bool operator==(const DraftError&) const = default;
};
/// Returns the reasons why a draft cannot be published: at most one reason for each level, then the reasons that
/// concern the whole curriculum. Empty if parseCurriculum() and checkNames() accept the draft.
std::vector<DraftError> findDraftErrors(const Curriculum& draft, const TeachingNames& known);

}  // namespace insonate
