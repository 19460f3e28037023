#include "store/FormRows.h"

#include <optional>
#include <set>
#include <utility>

namespace insonate::store {

FilledForm filledOf(const Row& row) {
  return {row.text(0), row.text(1), row.count(2), row.text(3), row.text(4), row.text(5), row.number(6), row.text(7)};
}

StoredForm storedFormOf(const Row& row) {
  return {.filled = filledOf(row), .rater = row.text(8).empty() ? row.text(9) : row.text(8)};
}

std::vector<StoredForm> allStored(const std::vector<Row>& rows, const std::string& reader) {
  std::vector<StoredForm> forms;
  std::set<std::pair<std::string, std::string>> judged;  // forms of the reader: attempt and form
  forms.reserve(rows.size());
  for (const Row& row : rows) {
    forms.push_back(storedFormOf(row));
    const FilledForm& filled = forms.back().filled;
    if (filled.by == reader) judged.emplace(filled.attempt, filled.form);
  }
  for (StoredForm& one : forms) {
    FilledForm& filled = one.filled;
    if (filled.attempt.empty() || filled.by == filled.person || filled.by == reader || filled.person == reader)
      continue;
    one.withheld = !judged.contains({filled.attempt, filled.form});
    if (one.withheld) filled.answers.clear();
  }
  return forms;
}

Result<std::string> storeForm(Transaction& transaction, const FilledForm& filled) {
  if (const auto row = transaction.row("SELECT " INSONATE_FORM_COLUMNS " FROM forms WHERE id = ?", filled.id)) {
    FilledForm kept = filledOf(*row);
    kept.filled_us = filled.filled_us;
    if (kept == filled) return filled.id;
    return fail("The form " + filled.id +
                " was already handed in with other answers, which cannot be changed. Fill in another form.");
  }
  const auto attempt = filled.attempt.empty() ? std::nullopt : std::optional(filled.attempt);
  transaction.run("INSERT INTO forms SELECT COALESCE(MAX(arrival), 0) + 1, ?, ?, ?, ?, ?, ?, ?, ? FROM forms",
                  filled.id, filled.form, filled.formVersion, filled.person, attempt, filled.by, filled.filled_us,
                  filled.answers);
  return filled.id;
}

}  // namespace insonate::store
