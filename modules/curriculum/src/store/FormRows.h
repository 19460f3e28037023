#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/FormStore.h>

#include <string>
#include <vector>

namespace insonate::store {

/// Columns of the table `forms` that filledOf() reads.
#define INSONATE_FORM_COLUMNS                                                                                 \
  "forms.id, forms.form, forms.form_version, forms.person, forms.attempt, forms.filled_by, forms.filled_us, " \
  "forms.answers"

/// Columns of filled forms and their authors that allStored() reads. The query must join the authors as `people AS
/// raters`.
#define INSONATE_KEPT_FORM_COLUMNS INSONATE_FORM_COLUMNS ", raters.full_name, raters.name"

FilledForm filledOf(const Row& row);
/// Converts a row of INSONATE_KEPT_FORM_COLUMNS, with all answers (StoredForm::withheld is false).
StoredForm storedFormOf(const Row& row);
/// Converts rows to filled forms, without the answers that `reader` (a person's id) may not see yet. For each attempt
/// and kind of form the rows must contain all forms or none.
std::vector<StoredForm> allStored(const std::vector<Row>& rows, const std::string& reader);
/// Stores a filled form. Storing the same form again is no error; storing a different form with the same id is an
/// error.
Result<std::string> storeForm(Transaction& transaction, const FilledForm& filled);

}  // namespace insonate::store
