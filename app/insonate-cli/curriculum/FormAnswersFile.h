#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Form.h>

#include <string>

namespace insonate::cli {

/// Answers to a form, all of them checked: a JSON object, or where the name ends in .csv a table with the columns item,
/// answer and, where there are notes, note. Fails with a sentence on each that cannot be kept.
Result<FormAnswers> answersFromFile(const Form& form, const std::string& file);

}  // namespace insonate::cli
