#pragma once

#include "http/Messages.h"
#include "page/Markup.h"

#include <insonate/curriculum/Form.h>

#include <vector>

namespace insonate::web {

/// Returns the questions of a form as fields, which show `answers` and, beside each question concerned, its trouble.
Markup formFields(const Form& form, const FormAnswers& answers, const std::vector<AnswerError>& troubles);
/// Reads the answers from the fields that formFields() makes. Empty fields are no answers. A number that cannot be read
/// stays a text, which checkAnswers() refuses.
FormAnswers answersIn(const Form& form, const Fields& fields);
/// Returns the answers of a filled form as a table.
Markup answersTable(const Form& form, const FormAnswers& answers);

}  // namespace insonate::web
