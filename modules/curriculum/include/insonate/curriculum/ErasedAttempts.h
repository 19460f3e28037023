#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/FilesToDelete.h>

#include <cstdint>
#include <utility>

namespace insonate {

/// Attempts of erased people (PersonData::erase()), for a server that has files about them. A person may have been
/// erased by another program, which has no access to these files. Owned by one thread.
class ErasedAttempts {
 public:
  explicit ErasedAttempts(CurriculumStore store) : store_(std::move(store)) {}

  /// Deletes the recordings of the attempts of erased people from the database's folder of recordings. Returns the ids
  /// of these attempts, so that the caller can delete their other files, such as videos. Returns no attempts if no
  /// person was erased since the last call that deleted all recordings. Fails only if the database cannot be read.
  Result<FilesToDelete> removeRecordings();

 private:
  CurriculumStore store_;
  std::int64_t erasures_ = 0;  ///< number of erased people at the last call that deleted all
};

}  // namespace insonate
