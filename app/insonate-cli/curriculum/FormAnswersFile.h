#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Form.h>

#include <string>

namespace insonate::cli {

/// Reads and checks answers to a form: a JSON object or, if the name ends in .csv, a table with the columns item,
/// answer and, optionally, note. Fails with one sentence for each answer that the form does not accept.
Result<FormAnswers> answersFromFile(const Form& form, const std::string& file);

}  // namespace insonate::cli
