#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/Standings.h>

#include <cstdint>
#include <string>

namespace insonate::store {

/// Columns of the table `standings` (progress of trainees) that standingFrom() reads.
#define INSONATE_STANDING_COLUMNS                                                             \
  "standings.curriculum, standings.curriculum_version, standings.level, standings.mastered, " \
  "standings.concern, standings.sentence, standings.changes, standings.from_us, standings.until_us, standings.rules"

/// Converts a row with INSONATE_STANDING_COLUMNS, the first of which is at `column`, to a Standing.
Standing standingFrom(const Row& row, std::size_t column);
/// Tells whether the standing that is stored in `row` is current: computing the standing now would give the same
/// result. `changes`: the person's present Member::changes.
bool isCurrent(const Row& row, std::size_t column, std::int64_t changes, std::int64_t now_us);

/// Returns a person's progress in a curriculum: the stored standing if it is current; otherwise a standing that is
/// computed from all attempts and stored.
Standing currentStanding(Transaction& transaction, const std::string& person, const Curriculum& curriculum,
                         std::int64_t now_us);

/// Computes and stores a person's standing (progress) in each of the person's cohorts, after a change of attempts. A
/// curriculum that cannot be read is skipped; users who open the cohort see the error.
void renewStandings(Transaction& transaction, const std::string& person, std::int64_t now_us);

}  // namespace insonate::store
