#include "store/CommentRows.h"

namespace insonate::store {

std::vector<Row> commentRows(Transaction& transaction, const std::string& attempt) {
  return transaction.rows("SELECT " INSONATE_COMMENT_COLUMNS " FROM comments WHERE attempt = ? ORDER BY id", attempt);
}

bool mergeComment(Transaction& here, const Row& row) {
  const auto own = here.row("SELECT read_us, removed_us FROM comments WHERE id = ?", row.text(0));
  const auto removedBy = row.isNull(8) ? std::nullopt : std::optional(row.text(8));
  if (!own) {
    here.run("INSERT INTO comments VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", row.text(0), row.text(1), row.number(2),
             row.text(3), row.number(4), row.text(5), row.time(6), row.time(7), removedBy);
    return true;
  }
  if (!own->isNull(1)) return false;
  const bool isRead = own->isNull(0) && !row.isNull(6), isRemoved = !row.isNull(7);
  if (isRead) here.run("UPDATE comments SET read_us = ? WHERE id = ?", row.time(6), row.text(0));
  if (isRemoved)
    here.run("UPDATE comments SET text = '', removed_us = ?, removed_by = ? WHERE id = ?", row.time(7), removedBy,
             row.text(0));
  return isRead || isRemoved;
}

}  // namespace insonate::store
