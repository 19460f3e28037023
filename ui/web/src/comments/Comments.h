#pragma once

#include "page/Page.h"

#include <insonate/curriculum/AttemptFacts.h>

namespace insonate::web {

/// Text that the user typed in the form for a comment, and the reason why the comment was refused.
struct CommentDraft {
  std::string time{}, text{}, trouble{};
};

/// Returns the section with the comments on an attempt. Users who may comment on the attempt also get a form for a new
/// comment. Fails if `draft` was refused and the user gets no form. `query`: query of the attempt's page, to which the
/// form returns ("" or "?class=5"). If the user is the trainee, marks the comments as read.
Result<Markup> commentSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query,
                              const CommentDraft& draft);

/// Reads a time of a recording, "1:05" or "65.5", in microseconds; fails with a sentence.
Result<std::int64_t> recordingTime(const std::string& text);
/// Formats a time of a recording: "1:05.5".
std::string recordingTimeText(std::int64_t time_us);

}  // namespace insonate::web
