#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the result of an attempt, whose id is the only part, by the rules of the class named by the query's "class".
Response showAttempt(const Visit& visit, const Parts& parts);
/// Accepts or voids the attempt whose id is the only part, for the form's "reason".
Response acceptAttempt(const Visit& visit, const Parts& parts);
Response voidAttempt(const Visit& visit, const Parts& parts);
/// Adds a comment to the attempt whose id is the only part, at the form's time "at" with its text "text".
Response addComment(const Visit& visit, const Parts& parts);
/// Removes a comment: parts are the ids of attempt and comment.
Response removeComment(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
