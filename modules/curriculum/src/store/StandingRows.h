#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/Standings.h>

#include <cstdint>
#include <string>

namespace insonate::store {

/// Columns of standings that standingFrom() reads.
#define INSONATE_STANDING_COLUMNS                                                             \
  "standings.curriculum, standings.curriculum_version, standings.level, standings.mastered, " \
  "standings.concern, standings.sentence, standings.changes, standings.from_us, standings.until_us, standings.rules"

/// Converts INSONATE_STANDING_COLUMNS, which begin at `column`.
Standing standingFrom(const Row& row, std::size_t column);
/// Tells whether computing the standing now would give the same; `changes` is the person's present number of changes.
bool isCurrent(const Row& row, std::size_t column, std::int64_t changes, std::int64_t now_us);

/// As it was kept where that is current; otherwise worked out from all attempts, and kept.
Standing currentStanding(Transaction& transaction, const std::string& person, const Curriculum& curriculum,
                         std::int64_t now_us);

/// After a change of someone's attempts: how far they are in each cohort where they learn. A curriculum that cannot be
/// read is passed over; who looks at the cohort is told.
void renewStandings(Transaction& transaction, const std::string& person, std::int64_t now_us);

}  // namespace insonate::store
