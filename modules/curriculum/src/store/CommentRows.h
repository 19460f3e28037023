#pragma once

#include "store/sql/Transaction.h"

#include <string>
#include <vector>

namespace insonate::store {

/// Columns of the table `comments`, as mergeComment() reads them.
#define INSONATE_COMMENT_COLUMNS \
  "comments.id, attempt, at_us, author, written_us, text, read_us, removed_us, removed_by"

/// Rows of INSONATE_COMMENT_COLUMNS, also of removed comments.
std::vector<Row> commentRows(Transaction& transaction, const std::string& attempt);
/// Adds a comment of another database, or what was done with it there. The result does not depend on the order or the
/// number of repetitions. `row`: INSONATE_COMMENT_COLUMNS. Returns whether anything changed.
bool mergeComment(Transaction& here, const Row& row);

}  // namespace insonate::store
