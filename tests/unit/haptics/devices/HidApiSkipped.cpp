#include <gtest/gtest.h>

TEST(HidApiTest, OnMadeUpDevices) {
  GTEST_SKIP() << "umockdev is not installed: packaging/dependencies";
}
