#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the result of an attempt by the rules of a class. `parts`: the id of the attempt. "class" in the query: the id
/// of the class.
Response showAttempt(const Visit& visit, const Parts& parts);
/// Sends an event whenever the data of the page of an attempt may have changed (livePage()). `parts`: the id of the
/// attempt.
Response followAttempt(const Visit& visit, const Parts& parts);
/// Accepts an attempt, or voids it (voidAttempt()), for the reason in the form's field "reason". `parts`: the id of the
/// attempt.
Response acceptAttempt(const Visit& visit, const Parts& parts);
Response voidAttempt(const Visit& visit, const Parts& parts);
/// Adds a comment to an attempt. The form's field "at" contains the time in the recording, "text" the text of the
/// comment. `parts`: the id of the attempt.
Response addComment(const Visit& visit, const Parts& parts);
/// Removes a comment. `parts`: the ids of attempt and comment.
Response removeComment(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
