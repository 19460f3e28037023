#pragma once

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Unlocking.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Someone's progress as a class list shows it: the first level in the curriculum's order that is open or lapsed.
/// `changes` is Member::changes, asked before the history that the progress was worked out from.
Standing standingOf(const Curriculum& curriculum, std::span<const LevelProgress> progress, std::int64_t changes);

}  // namespace insonate
