#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A comment at a time of an attempt's recording.
struct AttemptComment {
  std::string id{};        ///< UUID
  std::string attempt{};   ///< AttemptFacts::id
  std::int64_t at_us = 0;  ///< time since the recording began
  std::string by{};        ///< author (Person::id)
  std::string author{};    ///< full name of the author, or sign-in name if there is no full name
  std::int64_t written_us = 0;
  std::string text{};
  bool isRead = false;  ///< true: the trainee who made the attempt has read the comment

  bool operator==(const AttemptComment&) const = default;
};

/// Access to comments on attempts in the database, with the permissions of a signed-in user. Instructors comment on
/// attempts of learners in their cohorts (classes). The comments can be read by the trainee who made the attempt and by
/// all who may see the attempt. A comment cannot be changed. The recording does not change.
class CommentStore {
 public:
  explicit CommentStore(SignedIn by) : by_(std::move(by)) {}

  /// Adds a comment of 1 to 4000 bytes at a time within an ended attempt, and returns its id.
  Result<std::string> add(const std::string& attempt, std::int64_t at_us, const std::string& text) const;
  /// Removes the text of a comment on `attempt`. This is allowed to administrators, and to the author of the comment as
  /// long as the author may comment on the attempt. Removing the comment again is no error.
  Result<void> remove(const std::string& attempt, const std::string& comment) const;

  /// Returns the comments on an attempt, without removed ones, in the order of their times.
  Result<std::vector<AttemptComment>> listByAttempt(const std::string& attempt) const;
  /// Stores that the signed-in user, who made the attempt, has read all its comments.
  Result<void> markRead(const std::string& attempt) const;

  struct Count {
    int all = 0, unread = 0;

    bool operator==(const Count&) const = default;
  };
  /// Returns the number of comments on each commented attempt of a person, by AttemptFacts::id.
  Result<std::map<std::string, Count>> countsOf(const std::string& person) const;

 private:
  SignedIn by_;
};

/// Formats a number of comments for a table: "3", "3, 1 unread"; "" if there are none.
std::string commentCountText(const CommentStore::Count& count);

}  // namespace insonate
