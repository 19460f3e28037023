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

FilledForm filledOf(const Row& row);
std::vector<FilledForm> allFilled(const std::vector<Row>& rows);
/// Kept once: the same form once more is no error, another one of this id is.
Result<std::string> keepForm(Transaction& transaction, const FilledForm& filled);

}  // namespace insonate::store
