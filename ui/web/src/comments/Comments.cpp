#include "comments/Comments.h"

#include <insonate/curriculum/CommentStore.h>

#include <QRegularExpression>
#include <QString>
#include <cmath>

namespace insonate::web {
namespace {

Markup commentItem(const Visit& visit, const AttemptComment& comment, const std::string& query) {
  Markup head = element("strong", {}, recordingTimeText(comment.at_us)) + text(" " + comment.author + ", ") +
                timeOf(comment.written_us);
  Markup item = element("p", {{"class", "quiet"}}, head) + element("p", {{"class", "lines"}}, comment.text);
  const Person& by = visit.by->person();
  if (comment.by == by.id || by.role == Role::Administrator) {
    const std::string address =
        "/attempts/" + encoded(comment.attempt) + "/comments/" + encoded(comment.id) + "/remove" + query;
    item += postForm(visit, address, {}, "Remove");
  }
  return element("li", {}, item);
}

bool mayComment(const Visit& visit, const AttemptFacts& attempt) {
  const Person& by = visit.by->person();
  return by.role != Role::Trainee && by.id != attempt.person && attempt.state != AttemptState::Open;
}

Markup commentForm(const Visit& visit, const AttemptFacts& attempt, const std::string& query,
                   const CommentDraft& draft) {
  Markup fields;
  if (!draft.trouble.empty()) fields += troubleLine(draft.trouble);
  const std::string label = "Time in the recording, 0:00 to " + recordingTimeText(attempt.length_us);
  fields += inputField(label, "at", "text", "off", draft.time) + textField("Comment", "text", draft.text) +
            note("The trainee can read the comment. A comment cannot be changed afterwards, but it can be removed.");
  return postForm(visit, "/attempts/" + encoded(attempt.id) + "/comments" + query, fields, "Add comment");
}

}  // namespace

Result<std::int64_t> recordingTime(const std::string& text) {
  static const QRegularExpression kTime(QStringLiteral("^\\s*(?:(\\d{1,4}):)?(\\d{1,6}(?:[.,]\\d{1,6})?)\\s*$"));
  const auto match = kTime.match(QString::fromStdString(text));
  const double minutes = match.captured(1).toDouble(), seconds = match.captured(2).replace(',', '.').toDouble();
  if (!match.hasMatch() || (!match.captured(1).isEmpty() && seconds >= 60))
    return fail("'" + text + "' is not a time. Enter minutes and seconds, such as 1:05, or seconds, such as 65.");
  return std::llround((60 * minutes + seconds) * 1e6);
}

std::string recordingTimeText(std::int64_t time_us) {
  const std::int64_t tenths = time_us / 100'000, seconds = tenths / 10 % 60;
  const std::string rest = tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10);
  return std::to_string(tenths / 600) + (seconds < 10 ? ":0" : ":") + std::to_string(seconds) + rest;
}

Result<Markup> commentSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query,
                              const CommentDraft& draft) {
  const CommentStore store(*visit.by);
  const auto comments = store.listByAttempt(attempt.id);
  if (!comments) return tl::unexpected(comments.error());
  if (attempt.person == visit.by->person().id && !comments->empty())
    if (auto read = store.markRead(attempt.id); !read) return tl::unexpected(read.error());
  const bool canAdd = mayComment(visit, attempt);
  if (!canAdd && !draft.trouble.empty()) return fail(draft.trouble);
  if (comments->empty() && !canAdd) return Markup();
  Markup items;
  for (const AttemptComment& one : *comments) items += commentItem(visit, one, query);
  Markup content = items.empty() ? paragraph("No comments yet.") : element("ol", {{"class", "comments"}}, items);
  if (canAdd) content += commentForm(visit, attempt, query, draft);
  return section("Comments", content);
}

}  // namespace insonate::web
