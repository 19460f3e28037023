#pragma once

#include "store/sql/Transaction.h"

#include <string>
#include <vector>

namespace insonate::store {

/// Columns of the table `comments`, as mergeComment() reads them.
#define INSONATE_COMMENT_COLUMNS \
  "comments.id, attempt, at_us, author, written_us, text, read_us, removed_us, removed_by"

/// Returns the comments on an attempt, including removed ones, as rows of INSONATE_COMMENT_COLUMNS.
std::vector<Row> commentRows(Transaction& transaction, const std::string& attempt);
/// Adds a comment from another database, or applies what happened to the comment in that database. The result does not
/// depend on the order of such calls or on their number. `row`: INSONATE_COMMENT_COLUMNS. Returns whether anything
/// changed.
bool mergeComment(Transaction& here, const Row& row);

}  // namespace insonate::store
