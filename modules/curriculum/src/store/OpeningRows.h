#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/OpeningStore.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate::store {

/// Returns the name of a sitting in the table `attempts`.
std::string_view nameOf(TestConditions testConditions);
TestConditions sittingNamed(std::string_view name);

/// Decides whether a test was open for the person of an attempt that began at `at_us`; None if the level is no test.
TestConditions sittingAt(Transaction& transaction, const AttemptFacts& facts, std::int64_t at_us);
/// Decides the sitting of an attempt whose beginning has just arrived at the store. If the beginning arrived late, or
/// after the end of the opening during which the attempt claims to have begun, the sitting is Undecided until the
/// attempt ends.
TestConditions sittingOnArrival(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us);

TestAdmission admissionAt(Transaction& transaction, const std::string& person, const std::string& curriculum,
                          const std::string& level, std::int64_t now_us);

/// An opening that applies to a person and has a code, with the hash of the code.
struct CodedOpening {
  std::string id{}, hashed{};
};
std::vector<CodedOpening> codedOpenings(Transaction& transaction, const std::string& person,
                                        const std::string& curriculum, const std::string& level, std::int64_t now_us);

/// Columns of the table `openings`, as mergeOpening() reads them.
#define INSONATE_OPENING_COLUMNS \
  "id, cohort, curriculum, level, start_us, end_us, code, opened_by, opened_us, closed_by, closed_us"
/// Adds an opening from the server's database, or closes the opening if the server has closed it.
void mergeOpening(Transaction& here, const Row& row);

}  // namespace insonate::store
