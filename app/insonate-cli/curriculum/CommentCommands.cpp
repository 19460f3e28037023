#include "Answer.h"
#include "Groups.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Csv.h>

#include <cmath>
#include <memory>

namespace insonate::cli {
namespace {

constexpr double kSecond_us = 1e6;

struct CommentArguments {
  std::string attempt, text, comment, csv;
  double at_s = 0;
};

Json rowOf(const AttemptComment& one) {
  return {{"id", one.id},     {"attempt", one.attempt}, {"at_s", double(one.at_us) / kSecond_us},
          {"by", one.by},     {"author", one.author},   {"written", timeText(one.written_us)},
          {"text", one.text}, {"read", one.isRead}};
}

std::string csvOf(const std::vector<AttemptComment>& comments) {
  std::vector<std::vector<std::string>> rows{{"id", "attempt", "at (s)", "author", "written (UTC)", "text", "read"}};
  for (const AttemptComment& one : comments)
    rows.push_back({one.id, one.attempt, csvNumber(double(one.at_us) / kSecond_us), one.author,
                    timeText(one.written_us), one.text, one.isRead ? "yes" : "no"});
  return csvText(rows);
}

Result<Answer> write(const SignedIn& by, const CommentArguments& a) {
  const auto id = CommentStore(by).add(a.attempt, std::llround(a.at_s * kSecond_us), a.text);
  if (!id) return tl::unexpected(id.error());
  return Answer{{{"id", *id}, {"attempt", a.attempt}, {"at_s", a.at_s}}, "Stored as comment " + *id + "."};
}

Result<Answer> list(const SignedIn& by, const CommentArguments& a) {
  const auto comments = CommentStore(by).listByAttempt(a.attempt);
  if (!comments) return tl::unexpected(comments.error());
  Json rows = Json::array();
  for (const AttemptComment& one : *comments) rows.push_back(rowOf(one));
  Answer answer{{{"attempt", a.attempt}, {"comments", rows}},
                rows.empty() ? "No comments yet."
                             : tableOf(rows, {{"at_s", "at (s)"},
                                              {"author", "author"},
                                              {"written", "written"},
                                              {"read", "read"},
                                              {"text", "text"},
                                              {"id", "comment"}})};
  const auto attempt = AttemptStore(by).attempt(a.attempt);
  if (!attempt) return tl::unexpected(attempt.error());
  if (attempt->facts.person == by.person().id)
    if (auto read = CommentStore(by).markRead(a.attempt); !read) return tl::unexpected(read.error());
  if (a.csv.empty()) return answer;
  if (auto written = writeAtomically(a.csv, csvOf(*comments)); !written) return tl::unexpected(written.error());
  answer.object["file"] = a.csv;
  answer.text += "\nWrote " + a.csv + ".";
  return answer;
}

Result<Answer> remove(const SignedIn& by, const CommentArguments& a) {
  if (auto done = CommentStore(by).remove(a.attempt, a.comment); !done) return tl::unexpected(done.error());
  return Answer{{{"id", a.comment}, {"attempt", a.attempt}, {"state", "removed"}},
                "The comment is removed. The audit log names its author and the user who removed it."};
}

}  // namespace

void addCommentCommands(CLI::App& attempts, Outcome& outcome) {
  CLI::App& comments = *attempts.add_subcommand("comments", "Manage comments on recorded attempts");
  comments.require_subcommand(1);
  const auto a = std::make_shared<CommentArguments>();
  const auto addAttempt = [a](CLI::App* command) {
    command->add_option("ATTEMPT", a->attempt, "The attempt's id, from 'attempts list'")->required();
    return command;
  };
  CLI::App* adding =
      addAttempt(addSignedInCommand(comments, outcome, "add", "Write a comment, which cannot be changed afterwards",
                                    [a](const SignedIn& by) { return write(by, *a); }));
  adding->add_option("TEXT", a->text, "Text of the comment")->required();
  adding->add_option("--at", a->at_s, "Time in the recording, in seconds")->required();
  CLI::App* listing = addAttempt(addSignedInCommand(
      comments, outcome, "list", "List an attempt's comments; a trainee who lists them has read them",
      [a](const SignedIn& by) { return list(by, *a); }));
  listing->add_option("--csv", a->csv, "Also write the comments to this file");
  CLI::App* removing = addAttempt(addSignedInCommand(
      comments, outcome, "remove", "Remove a comment of your own; administrators can remove any comment",
      [a](const SignedIn& by) { return remove(by, *a); }));
  removing->add_option("COMMENT", a->comment, "The comment's id, from 'comments list --json'")->required();
}

}  // namespace insonate::cli
