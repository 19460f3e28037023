#pragma once

#include "page/Page.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <functional>
#include <string>

namespace insonate::web {

/// Returns the section of an attempt's page with the filled forms about the attempt, and with links to the forms that
/// the user may fill in. `query`: part of the address that leads back to the class.
Result<Markup> formSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query);
/// Returns the section of a portfolio with all checklists and ratings about a person (Person::id), with their answers.
/// `describe`: returns a paragraph about the attempt with this id; "": the form is about no attempt.
Result<Markup> judgementSection(const Visit& visit, const std::string& person,
                                const std::function<Markup(const std::string& attempt)>& describe);
/// Returns the section of a trainee's own page with links to the questionnaires.
Result<Markup> questionnaireSection(const Visit& visit);

/// A form about an attempt beside its video: parts are the attempt's id and the form's name.
Response showAttemptForm(const Visit& visit, const Parts& parts);
Response handInAttemptForm(const Visit& visit, const Parts& parts);
/// A questionnaire for the user; the part is its name.
Response showQuestionnaire(const Visit& visit, const Parts& parts);
Response handInQuestionnaire(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
