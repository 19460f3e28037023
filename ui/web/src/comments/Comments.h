#pragma once

#include "page/Page.h"

#include <insonate/curriculum/AttemptFacts.h>

namespace insonate::web {

/// Text that the user typed in the form of a comment, and the reason why it was refused.
struct CommentDraft {
  std::string time{}, text{}, trouble{};
};

/// Returns the comments on an attempt with, for those who may comment on it, a form for another one. Fails if the draft
/// was refused to a user without this form. `query`: that of the attempt's page, to which the form returns ("" or
/// "?class=5"). A trainee has then read the comments.
Result<Markup> commentSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query,
                              const CommentDraft& draft);

/// Reads a time of a recording, "1:05" or "65.5", in microseconds; fails with a sentence.
Result<std::int64_t> recordingTime(const std::string& text);
/// Formats a time of a recording: "1:05.5".
std::string recordingTimeText(std::int64_t time_us);

}  // namespace insonate::web
