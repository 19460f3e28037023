#include "LevelOrder.h"
#include "PlainName.h"

#include <insonate/curriculum/CurriculumDraft.h>

#include <optional>

namespace insonate {
namespace {

Curriculum around(std::vector<Level> levels) {
  return {.name = "draft", .title = "draft", .levels = std::move(levels)};
}

/// A complete level.
Level anyLevel() {
  return {.name = "any", .title = "any", .about = "any", .caseName = "any", .procedure = "any"};
}

std::optional<std::string> problemOf(Level level, const TeachingNames& known) {
  level.prerequisites.clear();
  const auto alone = parseCurriculum(curriculumText(around({std::move(level)})));
  if (!alone) return alone.error().message;
  if (const auto named = checkNames(*alone, known); !named) return named.error().message;
  return std::nullopt;
}

std::optional<std::string> errorOfHead(const Curriculum& draft) {
  Curriculum head = draft;
  head.levels = {anyLevel()};
  const auto read = parseCurriculum(curriculumText(head));
  return read ? std::nullopt : std::optional(read.error().message);
}

}  // namespace

std::vector<DraftError> findDraftErrors(const Curriculum& draft, const TeachingNames& known) {
  std::vector<DraftError> errors;
  for (const Level& level : draft.levels)
    if (const auto error = problemOf(level, known)) errors.push_back({level.name, *error});
  if (const auto head = errorOfHead(draft)) errors.push_back({"", *head});
  if (draft.levels.empty()) errors.push_back({"", "The curriculum has no levels; add the first one."});
  if (const auto ordered = inOrderOfLearning(draft.levels); !ordered)
    errors.push_back({"", "The curriculum cannot be used: " + ordered.error().message});
  // Errors between levels, such as two levels with the same name.
  if (const auto all = parseCurriculum(curriculumText(draft)); !all && errors.empty())
    errors.push_back({"", all.error().message});
  return errors;
}

}  // namespace insonate
