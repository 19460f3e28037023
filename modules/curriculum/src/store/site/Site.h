#pragma once

#include "store/Core.h"
#include "store/site/Wire.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace insonate::store {

/// A server as a workstation sees it: either the server's database, or the program that serves this database over a
/// network.
class Site {
 public:
  virtual ~Site() = default;

  virtual const std::string& place() const = 0;
  /// Tells whether the server can be reached.
  virtual bool answers() = 0;
  /// Fails if the server cannot be reached, refuses the workstation, or has no people yet.
  virtual Result<void> greet(Core& here) = 0;
  /// Returns the ids that belong to no person on the server.
  virtual Result<std::set<std::string>> unknownPeople(const std::set<std::string>& ids) = 0;
  /// Adds people as disabled trainees, with another sign-in name if the name is taken. Returns sentences for the user.
  virtual Result<std::vector<std::string>> addPeople(const std::vector<SentPerson>& people) = 0;
  virtual Result<Taken> take(const SentBatch& batch) = 0;
  /// Returns the data that the server gives to the workstation, except for attempts at other workstations.
  virtual Result<Taught> teach() = 0;
  /// Returns attempts at other workstations, of those people after the person `after`, in the order of their ids, whose
  /// digest differs from that in `known`. A part has all attempts of a person or none, and ends after about 200
  /// attempts.
  virtual Result<AttemptsElsewhere> attemptsElsewhere(const Digests& known, const std::string& after) = 0;
  /// Checks name and password, and returns the person with the hash of the password, which the workstation needs for
  /// sign-ins without a connection. Returns an empty value if the workstation has the passwords of the server in any
  /// case.
  virtual Result<std::optional<SentPerson>> signIn(const std::string& name, const std::string& password) = 0;
  /// Changes a password, and returns the person with the hash of the new password.
  virtual Result<SentPerson> changePassword(const std::string& name, const std::string& old,
                                            const std::string& password) = 0;
  /// Sends the recordings that the server needs. Does nothing if the server keeps none.
  virtual Result<void> takeRecordings(Core& here, UploadReport& report, const Progress& progress) = 0;
};

/// The workstation whose requests a server answers.
struct Sender {
  std::string workstation{};
  /// true: the workstation has the password of the database, and its own store makes the decisions. false: the server
  /// decides what the workstation's people may do, gives the workstation only the data of these people, and verifies
  /// attempts itself.
  bool isTrusted = true;
};

/// The server's database. A workstation uses this class if it opens the database directly; the server's program uses
/// this class for its workstations.
class StoreSite final : public Site {
 public:
  StoreSite(std::shared_ptr<Core> core, Sender sender) : core_(std::move(core)), sender_(std::move(sender)) {}

  const std::string& place() const override { return core_->place(); }
  bool answers() override;
  Result<void> greet(Core& here) override;
  Result<std::set<std::string>> unknownPeople(const std::set<std::string>& ids) override;
  Result<std::vector<std::string>> addPeople(const std::vector<SentPerson>& people) override;
  Result<Taken> take(const SentBatch& batch) override;
  Result<Taught> teach() override;
  Result<AttemptsElsewhere> attemptsElsewhere(const Digests& known, const std::string& after) override;
  Result<std::optional<SentPerson>> signIn(const std::string& name, const std::string& password) override;
  Result<SentPerson> changePassword(const std::string& name, const std::string& old,
                                    const std::string& password) override;
  Result<void> takeRecordings(Core& here, UploadReport& report, const Progress& progress) override;

 private:
  std::shared_ptr<Core> core_;
  Sender sender_;
};

/// A server that is reached through a network (SiteLink).
class RemoteSite final : public Site {
 public:
  explicit RemoteSite(SiteLink link) : link_(std::move(link)) {}

  const std::string& place() const override { return link_.place; }
  bool answers() override;
  Result<void> greet(Core& here) override;
  Result<std::set<std::string>> unknownPeople(const std::set<std::string>& ids) override;
  Result<std::vector<std::string>> addPeople(const std::vector<SentPerson>& people) override;
  Result<Taken> take(const SentBatch& batch) override;
  Result<Taught> teach() override;
  Result<AttemptsElsewhere> attemptsElsewhere(const Digests& known, const std::string& after) override;
  Result<std::optional<SentPerson>> signIn(const std::string& name, const std::string& password) override;
  Result<SentPerson> changePassword(const std::string& name, const std::string& old,
                                    const std::string& password) override;
  Result<void> takeRecordings(Core& here, UploadReport& report, const Progress& progress) override;

 private:
  SiteLink link_;
};

/// Reads the next entries of a workstation's outbox, after the entry with number `after`.
Result<SentBatch> readBatch(Core& here, std::int64_t after);
/// Stores a batch in the server's database; `server` is a transaction for writing.
Result<Taken> takeBatch(Transaction& transaction, Core& server, const Sender& sender, const SentBatch& batch);
Result<Taught> readTaught(Core& server, const Sender& sender);
Result<AttemptsElsewhere> readElsewhere(Core& server, const Sender& sender, const Digests& known,
                                        const std::string& after);
/// Returns digests of all people of a workstation.
Result<Digests> digestsHere(Core& here);
std::optional<SentAttempt> readAttempt(Transaction& transaction, const std::string& id);
/// Copies an attempt from another database to this one, or adds those data of the attempt that are missing here. The
/// result does not depend on the order of such calls or on their number. Fails if the attempt differs from the one that
/// is stored here, or if its recording already counts for another attempt. `sender`: workstation from which the attempt
/// comes.
Result<void> mergeAttempt(Transaction& here, const Sender& sender, const SentAttempt& sent, std::int64_t now_us);
/// Stores the data of a server in the workstation's database.
Result<void> takeTaught(Core& here, Taught taught, UploadReport& report);
/// Stores attempts at other workstations; their people must be stored first.
Result<void> takeElsewhere(Core& here, const std::vector<SentAttempt>& attempts, UploadReport& report);
Result<std::vector<SentPerson>> peopleOf(Core& here);
/// Tells whether the person has signed in to the server at this workstation.
bool isKnownAt(Transaction& server, const std::string& workstation, const std::string& person);
void knowAt(Transaction& server, const std::string& workstation, const std::string& person, std::int64_t now_us);

}  // namespace insonate::store
