#include "support/TestData.h"

#include <insonate/core/AtomicFile.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

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

TEST(AtomicFolder, ReplacedFilesAndOldOnesAreNeverBothThere) {
  const test::TemporaryFolder folder;
  const fs::path target = folder / "case";
  fs::create_directories(target / "sub");
  for (const char* name : {"ct.nrrd", "case.json", "stale.nrrd", "sub/notes.txt"})
    std::ofstream(target / name) << "old";
  ASSERT_TRUE(writeFolderAtomically(target,
                                    [](const fs::path& beside) {
                                      return put(beside / "ct.nrrd", "new").and_then([&] {
                                        return put(beside / "case.json", "new");
                                      });
                                    },
                                    {"stale.nrrd"}));
  EXPECT_EQ(names(target), (std::set<std::string>{"case.json", "ct.nrrd", "sub"}));
  EXPECT_EQ(contents(target / "case.json"), "new");
  EXPECT_EQ(contents(target / "sub" / "notes.txt"), "old");
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"case"});
}

/// A reader that looks all the time while a folder is replaced sees two files of one generation only.
TEST(AtomicFolder, AReaderNeverSeesAMix) {
  const test::TemporaryFolder folder;
  const fs::path target = folder / "case";
  const auto write = [&](const std::string& text) {
    return writeFolderAtomically(target, [&](const fs::path& beside) {
      return put(beside / "a", text).and_then([&] { return put(beside / "b", text); });
    });
  };
  ASSERT_TRUE(write("0"));
  std::atomic<bool> done{false};
  int mixed = 0;
  std::thread reader([&] {
    while (!done) {
      // One folder, opened once: what a kill at this moment would leave.
      const int at = ::open(target.c_str(), O_DIRECTORY | O_RDONLY | O_CLOEXEC);
      if (at < 0) continue;
      const auto of = [&](const char* name) {
        char c = 0;
        const int file = ::openat(at, name, O_RDONLY | O_CLOEXEC);
        if (file < 0) return c;
        if (::read(file, &c, 1) != 1) c = 0;
        ::close(file);
        return c;
      };
      const char a = of("a"), b = of("b");
      if (a && b && a != b) ++mixed;
      ::close(at);
    }
  });
  for (int n = 1; n < 60; ++n) ASSERT_TRUE(write(std::to_string(n % 10)));
  done = true;
  reader.join();
  EXPECT_EQ(mixed, 0);
}

TEST(AtomicFolder, ALinkToAFolderStaysALink) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "real");
  std::ofstream(folder / "real" / "a") << "old";
  fs::create_directory_symlink(folder / "real", folder / "link");
  ASSERT_TRUE(writeFolderAtomically(folder / "link", [](const fs::path& beside) { return put(beside / "a", "new"); }));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "real" / "a"), "new");
}

/// Another program that is in the middle of writing a folder.
class Writer {
 public:
  explicit Writer(const fs::path& target) {
    int ready[2];
    if (::pipe(ready) != 0) return;
    child_ = ::fork();
    if (child_ == 0) {
      const auto held = writeFolderAtomically(target, [&](const fs::path& beside) -> Result<void> {
        ::mkdir((beside / "half").c_str(), 0700);
        if (::write(ready[1], "x", 1) == 1)
          for (;;) ::pause();
        return fail("nobody listens");
      });
      ::_exit(held ? 0 : 1);
    }
    char told = 0;
    EXPECT_EQ(::read(ready[0], &told, 1), 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Writer() { kill(); }
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_ = 0;
};

Result<void> writeCase(const fs::path& target) {
  return writeFolderAtomically(target, [](const fs::path& beside) { return put(beside / "a", "new"); });
}

TEST(AbandonedParts, GoWhenTheSamePlaceIsWrittenNext) {
  const test::TemporaryFolder folder;
  Writer first(folder / "neck.case"), other(folder / "other.case");
  first.kill(), other.kill();
  ASSERT_EQ(names(folder.path()).size(), 2u) << "what a kill leaves";
  ASSERT_TRUE(writeCase(folder / "neck.case"));
  const auto left = names(folder.path());
  ASSERT_EQ(left.size(), 2u);
  EXPECT_TRUE(left.contains("neck.case"));
  EXPECT_TRUE(left.begin()->starts_with(".other.part-")) << "that of another place stays";
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"neck.case"});
}

TEST(AbandonedParts, StayWhileAProgramWritesThem) {
  const test::TemporaryFolder folder;
  Writer writer(folder / "neck.case");
  const auto before = names(folder.path());
  ASSERT_EQ(before.size(), 1u);
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()), before);
  ASSERT_TRUE(writeCase(folder / "neck.case"));
  EXPECT_TRUE(names(folder.path()).contains(*before.begin()));
  EXPECT_TRUE(fs::exists(folder / *before.begin() / "half"));
  writer.kill();
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()), std::set<std::string>{"neck.case"});
}

TEST(AbandonedParts, AreNothingElseThatIsHidden) {
  const test::TemporaryFolder folder;
  const std::set<std::string> hidden{".part-1-2",       ".neck.part-", ".neck.part-x-1.case", ".neck.part-1.case",
                                     ".neck.part-1-2x", ".neck.case",  "neck.part-1-2.case",  ".neck.part-1-.case"};
  for (const std::string& name : hidden) fs::create_directory(folder / name);
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()), hidden);
  std::ofstream(folder / ".file.part-1-2.json") << "x";
  fs::create_directory_symlink(folder / ".neck.case", folder / ".link.part-1-2.case");
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()).size(), hidden.size() + 2) << "a file or a link is no part of a folder";
  removeAbandonedParts(folder / "nowhere");
}

TEST(AbandonedParts, StayBesideATargetThatWasLostBetweenTwoSteps) {
  const test::TemporaryFolder folder;
  for (const char* name : {".neck.part-1-2.case", ".neck.old-1-3.case"}) fs::create_directory(folder / name);
  removeAbandonedParts(folder.path());
  EXPECT_EQ(names(folder.path()).size(), 2u);
  fs::remove(folder / ".neck.old-1-3.case");
  removeAbandonedParts(folder.path());
  EXPECT_TRUE(names(folder.path()).empty());
}

TEST(AtomicFolder, ErrorsNameTheTarget) {
  const test::TemporaryFolder folder;
  const auto failed = writeFolderAtomically(folder / "case", [](const fs::path& beside) -> Result<void> {
    return fail("Could not write " + (beside / "ct.nrrd").string() + ": the disk is full.");
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message,
            "Could not write " + (folder / "case" / "ct.nrrd").string() + ": the disk is full.");
}

TEST(FolderTarget, IsRefusedBeforeTheWork) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "file") << "text";
  fs::create_symlink(folder / "nothing", folder / "link");
  const auto refusal = [](const fs::path& target) {
    const auto ok = checkFolderTarget(target);
    return ok ? std::string() : ok.error().message;
  };
  EXPECT_EQ(refusal(folder / "new"), "");
  EXPECT_EQ(refusal(folder.path()), "");
  EXPECT_NE(refusal("").find("empty"), std::string::npos);
  EXPECT_NE(refusal(folder / "file").find("is a file"), std::string::npos);
  EXPECT_NE(refusal(folder / "link").find("link to a folder that does not exist"), std::string::npos);
  EXPECT_NE(refusal(folder / "none" / "case").find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace insonate
