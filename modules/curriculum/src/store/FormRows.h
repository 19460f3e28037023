#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/FormStore.h>

#include <string>
#include <vector>

namespace insonate::store {

/// Columns of forms that filledOf() reads.
#define INSONATE_FORM_COLUMNS                                                                                 \
  "forms.id, forms.form, forms.form_version, forms.person, forms.attempt, forms.filled_by, forms.filled_us, " \
  "forms.answers"

/// Columns that allKept() reads. The query must join the authors as `people AS raters`.
#define INSONATE_KEPT_FORM_COLUMNS INSONATE_FORM_COLUMNS ", raters.full_name, raters.name"

FilledForm filledOf(const Row& row);
/// Converts a row of INSONATE_KEPT_FORM_COLUMNS; withholds nothing.
KeptForm keptFormOf(const Row& row);
/// Converts rows to forms as `reader` may read them. The rows must contain, for an attempt and a kind of form, either
/// all forms or none.
std::vector<KeptForm> allKept(const std::vector<Row>& rows, const std::string& reader);
/// Stores a form. Storing the same form again is no error; storing a different form with this id is.
Result<std::string> keepForm(Transaction& transaction, const FilledForm& filled);

}  // namespace insonate::store
