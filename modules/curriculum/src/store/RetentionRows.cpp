#include "store/RetentionRows.h"

#include <QtCore/QDateTime>

namespace insonate::store {

std::int64_t monthsBefore(std::int64_t now_us, int months) {
  return QDateTime::fromMSecsSinceEpoch(now_us / 1000, Qt::UTC).addMonths(-months).toMSecsSinceEpoch() * 1000;
}

std::vector<std::string> attemptsBefore(Transaction& transaction, std::int64_t time_us) {
  std::vector<std::string> attempts;
  for (const Row& row :
       transaction.rows("SELECT id FROM attempts WHERE begun_us < ? AND state <> 'open' ORDER BY arrival", time_us))
    attempts.push_back(row.text(0));
  return attempts;
}

std::vector<std::string> attemptsWithWorkBefore(Transaction& transaction, std::int64_t time_us) {
  std::vector<std::string> attempts;
  for (const Row& row : transaction.rows(
           "SELECT id FROM attempts JOIN verifications ON attempt = id WHERE ended_us IS NULL AND begun_us < ? AND "
           "state "
           "<> 'open' UNION SELECT id FROM attempts JOIN videos ON attempt = id WHERE attempts.begun_us < ? AND "
           "attempts.state <> 'open'",
           time_us, time_us))
    attempts.push_back(row.text(0));
  return attempts;
}

std::optional<std::int64_t> recordingsDeletedBefore_us(Transaction& transaction) {
  const auto row = transaction.row(
      "SELECT applied_us, recording_months FROM retention WHERE applied_us > 0 AND recording_months IS NOT NULL");
  return row ? std::optional(monthsBefore(row->number(0), row->count(1))) : std::nullopt;
}

}  // namespace insonate::store
