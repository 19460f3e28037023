#include "StoreRig.h"

#include <insonate/curriculum/StoreUpkeep.h>

#include <sys/stat.h>

#include <fstream>

namespace insonate::test {
namespace {
namespace fs = std::filesystem;

using ::testing::HasSubstr;

constexpr const char* kBytes = "abc";
/// FIPS 180-4.
constexpr const char* kHash = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

AttemptFacts recordedFacts() {
  AttemptFacts facts = endedFacts(begunFacts());
  facts.recordingHash = kHash;
  return facts;
}

std::size_t fileCount(const fs::path& folder) {
  std::error_code none;
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder, none), fs::directory_iterator()));
}

/// An attempt's recording "made.attempt", of which `facts` know the hash.
class StoreRecordings : public ::testing::Test {
 protected:
  StoreRecordings() { write(made, kBytes); }
  AttemptStore anna() const { return AttemptStore(school.as(school.anna)); }
  fs::path kept(const AttemptFacts& of) const { return folder / (of.id + ".attempt"); }

  const StoreRig rig;
  const School school{rig.open()};
  const fs::path made = rig.folder / "made.attempt", folder = rig.address + ".recordings";
  const AttemptFacts facts = recordedFacts();
};

TEST_F(StoreRecordings, AnAddedAttemptsRecordingIsKeptForItsOwnerAlone) {
  valueOf(anna().add(facts, made));
  EXPECT_EQ(bytesOf(kept(facts)), kBytes);
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
  EXPECT_EQ(fs::status(kept(facts)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::remove(made);
  EXPECT_EQ(valueOf(anna().attempt(facts.id)).recordingFile, kept(facts));
  EXPECT_EQ(valueOf(anna().page(school.anna.id, 1))[0].recordingFile, kept(facts));
  write(made, kBytes);
  valueOf(anna().add(facts, made));
  EXPECT_EQ(fileCount(folder), 1U) << "added twice is kept once";
}

TEST_F(StoreRecordings, WhatCannotBeCopiedAddsNothing) {
  EXPECT_THAT(refusalOf(anna().add(facts, rig.folder / "none")), HasSubstr("cannot be read; check its permissions"));
  write(made, "abd");
  EXPECT_THAT(refusalOf(anna().add(facts, made)), HasSubstr("was changed while it was read"));
  EXPECT_EQ(fileCount(folder), 0U) << "nothing half-written either";
  fs::remove(folder);
  write(folder, "a file in the folder's place");
  EXPECT_THAT(refusalOf(anna().add(facts, made)), HasSubstr("for recordings cannot be made"));
  EXPECT_TRUE(valueOf(anna().history(school.anna.id)).empty());
}

TEST_F(StoreRecordings, ARefusedAttemptLeavesNoRecording) {
  AttemptFacts first = facts;
  first.handsHash = std::string(64, 'b');
  valueOf(anna().add(first, made));
  AttemptFacts again = recordedFacts();
  again.handsHash = first.handsHash;
  EXPECT_THAT(refusalOf(anna().add(again, made)), HasSubstr("A recording counts once"));
  EXPECT_EQ(fileCount(folder), 1U);
}

TEST_F(StoreRecordings, ARecordingIsKeptAfterItsAttemptEnded) {
  const AttemptStore attempts = anna();
  valueOf(attempts.begin(facts));
  EXPECT_THAT(refusalOf(attempts.storeRecording(facts.id, made)), HasSubstr("has no recording"));
  succeed(attempts.end(facts));
  EXPECT_EQ(valueOf(attempts.attempt(facts.id)).recordingFile, "");
  EXPECT_THAT(refusalOf(AttemptStore(school.as(school.ben)).storeRecording(facts.id, made)),
              HasSubstr("You do not have the permission for this"));
  succeed(attempts.storeRecording(facts.id, made));
  succeed(attempts.storeRecording(facts.id, made));
  EXPECT_EQ(bytesOf(kept(facts)), kBytes);
}

TEST_F(StoreRecordings, AFolderOthersCouldReadLosesTheirRights) {
  fs::create_directory(folder);
  fs::permissions(folder, fs::perms::all);
  valueOf(anna().add(facts, made));
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
}

TEST_F(StoreRecordings, ABackupTakesThemAlongAndARestoreBringsThemBack) {
  valueOf(anna().add(facts, made));
  const fs::path backup = rig.folder / "backup.db",
                 backedUp = rig.folder / "backup.db.recordings" / kept(facts).filename();
  succeed(StoreUpkeep(school.admin).backup(backup));
  EXPECT_EQ(bytesOf(backedUp), kBytes);
  EXPECT_EQ(fs::status(backedUp.parent_path()).permissions(), fs::perms::owner_all);

  write(kept(facts), "damaged since");
  succeed(restoreStore(rig.address, backup, "admin", kPassword));
  EXPECT_EQ(bytesOf(kept(facts)), kBytes);
  fs::remove_all(folder);
  succeed(restoreStore(rig.address, backup, "admin", kPassword));
  EXPECT_EQ(valueOf(anna().attempt(facts.id)).recordingFile, kept(facts));
}

TEST_F(StoreRecordings, ABackupWithoutItsRecordingsIsNone) {
  valueOf(anna().add(facts, made));
  const fs::path backup = rig.folder / "backup.db";
  write(rig.folder / "backup.db.recordings", "a file in the folder's place");
  EXPECT_THAT(refusalOf(StoreUpkeep(school.admin).backup(backup)), HasSubstr("for recordings cannot be made"));
  EXPECT_FALSE(fs::exists(backup));
  fs::remove(rig.folder / "backup.db.recordings");
  EXPECT_EQ(refusalOf(StoreUpkeep(school.admin).backup(backup, [](std::string_view, double) { return false; })),
            kCancelled);
  EXPECT_FALSE(fs::exists(backup));
}

TEST(StoreRecordingsOnServer, AreInTheFolderThatTheWorkstationNames) {
  if (!PostgresServer::shared()) GTEST_SKIP() << "PostgreSQL 15 is not installed";
  StoreRig rig(Place::Server);
  const fs::path made = rig.folder / "made.attempt", folder = rig.folder / "recordings";
  write(made, kBytes);
  {
    const School school(rig.open());
    const AttemptFacts facts = recordedFacts();
    const AttemptStore attempts(school.as(school.anna));
    valueOf(attempts.add(facts, made));
    EXPECT_EQ(valueOf(attempts.attempt(facts.id)).recordingFile, "") << "no folder was named";
  }
  rig.services.recordings = folder;
  const CurriculumStore store = rig.open();
  const AttemptFacts facts = recordedFacts();
  const AttemptStore attempts(valueOf(store.signIn("anna", kPassword)));
  valueOf(attempts.add(facts, made));
  EXPECT_EQ(bytesOf(folder / (facts.id + ".attempt")), kBytes);
}

}  // namespace
}  // namespace insonate::test
