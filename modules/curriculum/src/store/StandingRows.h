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

/// Converts INSONATE_STANDING_COLUMNS, of which the first is at `column`.
Standing standingFrom(const Row& row, std::size_t column);
/// Tells whether computing the standing now would give the same. `changes` is the person's present Member::changes.
bool isCurrent(const Row& row, std::size_t column, std::int64_t changes, std::int64_t now_us);

/// Returns the stored standing if it is current; otherwise computes it from all attempts and stores it.
Standing currentStanding(Transaction& transaction, const std::string& person, const Curriculum& curriculum,
                         std::int64_t now_us);

/// Computes a person's standing in each cohort again after a change of attempts. A curriculum that cannot be read is
/// skipped here; users who open the cohort see the error.
void renewStandings(Transaction& transaction, const std::string& person, std::int64_t now_us);

}  // namespace insonate::store
