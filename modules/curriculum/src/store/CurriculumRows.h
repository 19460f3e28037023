#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <optional>
#include <string>
#include <vector>

namespace insonate::store {

struct StoredCurriculum {
  CurriculumEntry entry{};
  std::string text{};
};

/// Returns all published curricula, sorted by name, newest version first.
std::vector<CurriculumEntry> listCurricula(Transaction& transaction);
std::optional<StoredCurriculum> findCurriculum(Transaction& transaction, const std::string& name, int version);
void insertCurriculum(Transaction& transaction, const StoredCurriculum& curriculum);
/// Fails if the hash shows that the stored text of a curriculum was changed after publication.
Result<void> checkHash(const StoredCurriculum& curriculum);
/// Finds a published curriculum, checks its hash and parses it.
Result<Curriculum> publishedCurriculum(Transaction& transaction, const std::string& name, int version);
Result<std::string> publishedText(Transaction& transaction, const std::string& name, int version);

}  // namespace insonate::store
