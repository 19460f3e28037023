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

/// Columns that allKept() reads; the raters are people AS raters.
#define INSONATE_KEPT_FORM_COLUMNS INSONATE_FORM_COLUMNS ", raters.full_name, raters.name"

FilledForm filledOf(const Row& row);
/// Converts a row of INSONATE_KEPT_FORM_COLUMNS; nothing is withheld.
KeptForm keptFormOf(const Row& row);
/// As `reader` may read them: all forms about an attempt of one kind are among the rows, or none.
std::vector<KeptForm> allKept(const std::vector<Row>& rows, const std::string& reader);
/// Kept once: the same form once more is no error, another one of this id is.
Result<std::string> keepForm(Transaction& transaction, const FilledForm& filled);

}  // namespace insonate::store
