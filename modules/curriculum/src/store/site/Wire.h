#pragma once

#include "store/CurriculumRows.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/FilledForm.h>
#include <insonate/curriculum/Person.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate::store {

/// A person as a workstation sends it, with the hash of the password.
struct SentPerson {
  Person person{};
  std::string password{};
  bool mustChange = false;
  std::int64_t version = 1;
};

struct SentAttempt {
  StoredAttempt kept{};
  AttemptFacts ended{};  ///< facts of the attempt as they were before the attempt was voided
  std::optional<std::int64_t> voided_us{};
  std::string voidedBy{}, acceptedBy{};
  std::vector<Row> comments{};  ///< rows of INSONATE_COMMENT_COLUMNS
};

/// An entry of a workstation's outbox, with the present data of the attempt or form that the entry names.
struct SentItem {
  std::int64_t number = 0;
  std::string kind{}, id{};
  std::optional<SentAttempt> attempt{};  ///< attempt; for a form, the attempt that the form is about, which must be on
                                         ///< the server first
  std::optional<FilledForm> form{};
  bool isForeign = false;  ///< true: the attempt was made at another workstation, and only comments and forms on it
                           ///< are sent
  std::string password{};
  bool mustChange = false;
  std::int64_t version = 0;
};

struct SentBatch {
  std::vector<SentItem> items{};
  std::int64_t waiting = 0;
  AuditAnchor auditEnd{};  ///< end of the workstation's audit log
};

/// Answer of a server to a batch.
struct Taken {
  std::vector<std::int64_t> numbers{};  ///< entries of the outbox that the server has stored or refused for good
  int attempts = 0, forms = 0;
  std::vector<std::string> troubles{};  ///< sentences about data that could not be stored, as in UploadReport
};

/// Rows as texts, keyed by the first column.
using Rows = std::map<std::string, std::vector<std::string>>;

/// Columns of people with their passwords, in the order of the rows of Taught::people.
inline constexpr std::string_view kPeopleColumns =
    "id, name, name_key, full_name, email, role, disabled, password, must_change, version";

inline constexpr std::size_t kEmailColumn = 4, kPasswordColumn = 7, kVersionColumn = 9;

/// State of the attempts that people made at other workstations: a hash for each person (Person::id).
using Digests = std::map<std::string, std::string>;

/// Data that a server gives to a workstation. A person's password may be empty: either the workstation already has the
/// password of this version, or the person must first sign in to the server.
struct Taught {
  Rows people{}, cohorts{}, memberships{};
  std::vector<StoredCurriculum> curricula{};
  /// Rows about the workstation's attempts. voided: id, voided_us, voided_by, void_reason. accepted: attempt,
  /// accepted_by. refused (attempts that the server could not verify): attempt, why. comments:
  /// INSONATE_COMMENT_COLUMNS.
  std::vector<Row> voided{}, accepted{}, refused{}, comments{};
  std::vector<Row> openings{};        ///< rows of INSONATE_OPENING_COLUMNS
  std::vector<std::string> erased{};  ///< people whom the server has erased, whom the workstation erases, too
  /// Time before which attempts lose their recordings by the server's rule of retention; empty: never.
  std::optional<std::int64_t> deleted_us{};
};

/// Part of the ended attempts that people made at other workstations.
struct AttemptsElsewhere {
  std::vector<SentAttempt> attempts{};
  std::string last{};  ///< last person (Person::id) of this part; empty: no part follows
};

}  // namespace insonate::store
