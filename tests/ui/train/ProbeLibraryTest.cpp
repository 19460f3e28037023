#include "probe/ProbeLibrary.h"

#include <gtest/gtest.h>
#include <support/TestData.h>

#include <QString>
#include <fstream>

namespace insonate::train {
namespace {

TEST(ProbeLibrary, FoldersAndFilesOfNoUse) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "broken.json") << "{ no probe";
  ProbeLibrary library(QString::fromStdString(folder.path().string()));
  EXPECT_TRUE(library.entries().empty());
  Probe probe = loadProbe("phased").value();
  EXPECT_FALSE(library.save(probe)) << "a built-in name";
  probe.name = "Ä/b:c";
  ASSERT_TRUE(library.save(probe));
  ASSERT_EQ(library.entries().size(), 1u);
  EXPECT_FALSE(library.rename("Ä/b:c", "linear"));
  EXPECT_FALSE(library.remove("no such"));
  std::ofstream(folder / "file") << "in the way";
  ProbeLibrary nowhere(QString::fromStdString((folder / "file/probes").string()));
  const auto refused = nowhere.save(probe);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("could not be made"), std::string::npos);
}

}  // namespace
}  // namespace insonate::train
