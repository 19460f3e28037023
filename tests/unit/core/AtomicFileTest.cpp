#include "support/TestData.h"

#include <insonate/core/AtomicFile.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace insonate {
namespace {
namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
  return found;
}

Result<void> put(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return {};
}

TEST(AtomicFile, WritesAndReplaces) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeAtomically(folder / "a.json", "first"));
  ASSERT_TRUE(writeAtomically(folder / "a.json", std::string_view("sec\0nd", 6)));
  EXPECT_EQ(contents(folder / "a.json"), std::string("sec\0nd", 6));
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"a.json"});
}

TEST(AtomicFile, TheWriterSeesTheFinalExtensionBesideTheTarget) {
  const test::TemporaryFolder folder;
  fs::path seen;
  ASSERT_TRUE(writeAtomically(folder / "labels.seg.nrrd", [&](const fs::path& beside) {
    seen = beside;
    return put(beside, "x");
  }));
  EXPECT_EQ(seen.extension(), ".nrrd");
  EXPECT_EQ(seen.parent_path(), folder.path());
}

TEST(AtomicFile, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeAtomically(folder / "a.txt", "old"));
  const auto failed = writeAtomically(folder / "a.txt", [](const fs::path& beside) -> Result<void> {
    std::ofstream(beside) << "half";
    return fail("No more room.");
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "No more room.");
  EXPECT_EQ(contents(folder / "a.txt"), "old");
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, AnExceptionBecomesASentence) {
  const test::TemporaryFolder folder;
  const auto failed = writeAtomically(folder / "a.txt", [](const fs::path& beside) -> Result<void> {
    std::ofstream(beside) << "half";
    throw std::runtime_error("writer broke");
  });
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().message.find("writer broke"), std::string::npos);
  EXPECT_NE(failed.error().message.find("a.txt"), std::string::npos);
  EXPECT_TRUE(names(folder.path()).empty());
}

TEST(AtomicFile, AWriterThatWroteNothingIsNoticed) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(writeAtomically(folder / "a.txt", [](const fs::path&) { return Result<void>{}; }));
  EXPECT_TRUE(names(folder.path()).empty());
}

TEST(AtomicFile, AMissingFolderIsNamed) {
  const test::TemporaryFolder folder;
  const auto failed = writeAtomically(folder / "missing" / "a.txt", "text");
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().message.find("missing"), std::string::npos);
}

TEST(AtomicFile, ATargetThatIsAFolderIsRefusedAndKept) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "a.txt");
  std::ofstream(folder / "a.txt" / "inside") << "kept";
  EXPECT_FALSE(writeAtomically(folder / "a.txt", "text"));
  EXPECT_EQ(contents(folder / "a.txt" / "inside"), "kept");
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, AFullDiskIsASentenceAndLeavesNothing) {
  // /dev/full accepts opening and refuses every byte; a symbolic link to it stands in for the file beside the target.
  const test::TemporaryFolder folder;
  const auto failed = writeAtomically(folder / "a.txt", [](const fs::path& beside) -> Result<void> {
    fs::create_symlink("/dev/full", beside);
    std::ofstream out(beside);
    out << "text";
    out.close();
    if (!out) return fail("The disk is full.");
    return {};
  });
  EXPECT_FALSE(failed);
  EXPECT_TRUE(names(folder.path()).empty());
}

TEST(AtomicFolder, CreatesTheFolderWithAllFiles) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"case", "other/"}) {
    ASSERT_TRUE(writeFolderAtomically(folder / name, [](const fs::path& beside) {
      return put(beside / "ct.nrrd", "ct").and_then([&] { return put(beside / "case.json", "json"); });
    }));
    EXPECT_EQ(names(folder / name), (std::set<std::string>{"case.json", "ct.nrrd"}));
  }
  EXPECT_EQ(names(folder.path()), (std::set<std::string>{"case", "other"}));
}

TEST(AtomicFolder, ReplacesItsFilesAndKeepsTheOthers) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "case");
  std::ofstream(folder / "case" / "ct.nrrd") << "old";
  std::ofstream(folder / "case" / "notes.txt") << "mine";
  ASSERT_TRUE(
      writeFolderAtomically(folder / "case", [](const fs::path& beside) { return put(beside / "ct.nrrd", "new"); }));
  EXPECT_EQ(contents(folder / "case" / "ct.nrrd"), "new");
  EXPECT_EQ(contents(folder / "case" / "notes.txt"), "mine");
}

TEST(AtomicFolder, AFailureHalfwayTouchesNothing) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "case");
  std::ofstream(folder / "case" / "ct.nrrd") << "old";
  const auto failed = writeFolderAtomically(folder / "case", [](const fs::path& beside) -> Result<void> {
    std::ofstream(beside / "ct.nrrd") << "new";
    return fail("Labels could not be written.");
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(contents(folder / "case" / "ct.nrrd"), "old");
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"case"});
}

TEST(AtomicFolder, AFailureLeavesNoNewFolder) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(
      writeFolderAtomically(folder / "case", [](const fs::path&) -> Result<void> { return fail("No luck."); }));
  EXPECT_TRUE(names(folder.path()).empty());
}

}  // namespace
}  // namespace insonate
