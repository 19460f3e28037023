#include <insonate/haptics/UdevRules.h>

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

using namespace insonate;

namespace {

TEST(UdevRules, ThoseInThePackageAreThoseOfTheTables) {
  std::ifstream file(INSONATE_SOURCE_DIR "/packaging/70-insonate.rules");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), udevRules()) << "insonate-cli devices --udev-rules > packaging/70-insonate.rules";
}

TEST(UdevRules, NameEachDeviceOfATable) {
  EXPECT_THAT(
      udevRules(),
      testing::HasSubstr(R"(KERNEL=="hidraw*", ATTRS{idVendor}=="16c0", ATTRS{idProduct}=="0486", TAG+="uaccess")"));
}

}  // namespace
