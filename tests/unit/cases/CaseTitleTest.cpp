#include <insonate/cases/CaseTitle.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

std::string titleIn(const char* folder, std::string_view before = kImportedTitle) {
  CaseManifest manifest;
  manifest.title = before;
  setTitleFromFolder(manifest, folder);
  return manifest.title;
}

TEST(CaseTitle, AnImportIsCalledAsItsFolder) {
  EXPECT_EQ(titleIn("/cases/neck"), "neck");
  EXPECT_EQ(titleIn("/cases/short neck.case"), "short neck");
  EXPECT_EQ(titleIn("/cases/neck 1.2"), "neck 1.2");
  EXPECT_EQ(titleIn("/cases/neck.case/"), "neck");
  EXPECT_EQ(titleIn("/cases/a/../Hals Müller"), "Hals Müller");
}

TEST(CaseTitle, WhatSomebodyNamedKeepsItsName) {
  EXPECT_EQ(titleIn("/cases/neck", "Short neck, large vein"), "Short neck, large vein");
}

TEST(CaseTitle, ARootNamesNothing) {
  EXPECT_EQ(titleIn("/"), kImportedTitle);
}

}  // namespace
}  // namespace insonate
