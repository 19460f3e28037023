#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace insonate {
namespace store {
class Site;
struct SentPerson;
}  // namespace store

/// An attempt or form that waits to be sent to the server.
struct PendingUpload {
  std::int64_t number = 0;
  std::string kind{};  ///< kind of the data: "attempt" or "form"
  std::string id{};    ///< id of the attempt or form
  std::int64_t since_us = 0;
};

/// Result of SiteUpload::exchange().
struct UploadReport {
  int attempts = 0, forms = 0;                 ///< numbers of attempts and forms that the server accepted
  int recordings = 0;                          ///< number of recordings that were sent to the server
  int people = 0, cohorts = 0, curricula = 0;  ///< numbers of people, cohorts and curricula that came from the server
                                               ///< and were new or different on this workstation
  /// Sentences about data that could not be sent, with what to do: a name that belongs to another person on the server,
  /// a curriculum that differs on the server. Everything else was sent.
  std::vector<std::string> errors{};
};

/// Answer of a server to a request.
struct SiteAnswer {
  bool isRefusal = false;  ///< true: `text` is a sentence that says why the server refuses the request
  std::string text{};
};

/// Connection of a workstation to the program that serves a site's database over a network (insonate-server).
struct SiteLink {
  std::string place{};  ///< address of the server, for messages
  /// Sends a request that consists of `path` and `body`. Fails with a sentence if the server cannot be reached. May be
  /// called on any thread.
  std::function<Result<SiteAnswer>(const std::string& path, const std::string& body)> send{};
};

/// Exchanges data between the database of a workstation and that of a server: downloads people, roles, cohorts and
/// curricula, and uploads attempts and forms. There are two ways. Either the workstation opens the server's database
/// itself; it then receives all people, cohorts and curricula of the server. Or the workstation is connected to the
/// server's program through a SiteLink.
///
/// Through a SiteLink, the workstation receives only the people who have signed in to the server at this workstation,
/// and the classes and learners of the instructors among these people. It also sends the recordings, from which the
/// server verifies the attempts.
///
/// No user needs to be signed in, since the exchange shows no data to a user. Data are sent again until the server
/// confirms them; data that arrive twice are stored once. If only the workstation knows a person, this person is
/// uploaded as a disabled trainee, whom an administrator of the server may enable.
class SiteUpload {
 public:
  /// `server`: the server's database, which the workstation opens itself.
  SiteUpload(CurriculumStore here, const CurriculumStore& server);
  SiteUpload(CurriculumStore here, SiteLink server);

  /// Exchanges data in batches; each batch is one transaction. Batches before a failure or a cancellation remain
  /// stored. Fails if the server cannot be reached or has no people yet.
  Result<UploadReport> exchange(const Progress& progress = {}) const;
  enum class Reached { Yes, No };
  /// Lets the server check name and password, and stores the person on the workstation, so that the person can later
  /// sign in at the workstation even without a connection. Fails if the server refuses the sign-in. Returns No if the
  /// server cannot be reached. Works only through a SiteLink; with the server's database it does nothing.
  Result<Reached> signIn(const std::string& name, const std::string& password) const;
  /// Changes a person's password on the server, and stores the new password on the workstation. Works only through a
  /// SiteLink.
  Result<void> changePassword(const std::string& name, const std::string& old, const std::string& password) const;
  /// Returns the address of the server, for messages.
  const std::string& place() const;
  /// Returns the number of attempts and forms that wait to be sent. If the workstation has no server, they wait
  /// indefinitely.
  Result<std::int64_t> pending() const;
  /// Returns the names of the cases (Level::caseName) that the curricula of this workstation's classes use, without
  /// archived classes; each name once.
  Result<std::vector<std::string>> caseNames() const;

 private:
  Result<void> keep(const store::SentPerson& person) const;

  CurriculumStore here_;
  std::shared_ptr<store::Site> server_;
};

/// Returns attempts and forms that wait to be sent to the server, oldest first, at most `count` (1 to 1000). For
/// administrators and instructors.
Result<std::vector<PendingUpload>> pendingUploads(const SignedIn& by, int count);

}  // namespace insonate
