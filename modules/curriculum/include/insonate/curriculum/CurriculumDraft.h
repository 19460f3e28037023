#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Reads what curriculumText() wrote of a curriculum that is not finished: texts may be missing, there may be no level,
/// levels may need each other in a circle, and come back in the order in which they are written.
Result<Curriculum> parseDraft(std::string_view json);

/// A reason why a draft cannot be published.
struct DraftTrouble {
  std::string level{};  ///< Level::name; "": the curriculum as a whole
  std::string sentence{};

  bool operator==(const DraftTrouble&) const = default;
};
/// One for each level at most, then those of the whole; none: parseCurriculum() and checkNames() take it.
std::vector<DraftTrouble> problemsOf(const Curriculum& draft, const TeachingNames& known);

}  // namespace insonate
