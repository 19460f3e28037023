#include <insonate/tissue/OwnLabels.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

TEST(OwnLabels, ATidyNameIsOneShortLine) {
  EXPECT_EQ(tidyLabelName("  left\n jugular\r\n\tvein \x7f"), "left jugular vein");
  EXPECT_EQ(tidyLabelName("a\u2028b\u0085c"), "a b c") << "what Unicode breaks lines with";
  EXPECT_EQ(tidyLabelName("say \"C:\\x\""), "say 'C:/x'");
  EXPECT_EQ(tidyLabelName("<b>vein</b> &amp;"), "<b>vein</b> &amp;") << "text, not markup";
  EXPECT_EQ(tidyLabelName(std::string("a\0b", 3)), "a b");
  EXPECT_EQ(tidyLabelName(" \n "), "");
}

TEST(OwnLabels, ALongNameIsCutBetweenCharacters) {
  EXPECT_EQ(tidyLabelName(std::string(10'000, 'x')), std::string(64, 'x'));
  std::string umlauts;
  for (int n = 0; n < 5'000; ++n) umlauts += "\u00e4";
  EXPECT_EQ(tidyLabelName("x" + umlauts), "x" + umlauts.substr(0, 62));
}

TEST(OwnLabels, WhatIsNoUtf8IsReplaced) {
  EXPECT_EQ(tidyLabelName("\xe4ste"), "?ste") << "Latin-1";
  EXPECT_EQ(tidyLabelName("\xc0\xaf"), "??") << "too long a form";
  EXPECT_EQ(tidyLabelName("\xed\xa0\x80"), "???") << "half of a surrogate pair";
  EXPECT_EQ(tidyLabelName("\xf0\x9f\x92\x89 \u9838"), "\xf0\x9f\x92\x89 \u9838");
  EXPECT_EQ(tidyLabelName("\xf0\x9f"), "??") << "cut off";
}

TEST(OwnLabels, TidyingTwiceChangesNothing) {
  for (const std::string& name : {std::string("a \xff b"), std::string(63, 'a') + " b", std::string("\"\\\n")})
    EXPECT_EQ(tidyLabelName(tidyLabelName(name)), tidyLabelName(name));
}

TEST(OwnLabels, NameAndTissueAreTheAuthorsWhereHeSaidThem) {
  const OwnLabels own{{17, {"left jugular", kVein}}, {18, {"", kBone}}};
  EXPECT_EQ(labelName(own, 17), "left jugular");
  EXPECT_EQ(labelName(own, 18), "label 18");
  EXPECT_EQ(labelName(own, kVein), "vein");
  EXPECT_EQ(tissueOf(own, 17), kVein);
  EXPECT_EQ(tissueOf(own, 19), 19) << "unknown, which is said where it matters";
  EXPECT_EQ(tissueOf(own, kArtery), kArtery);
  EXPECT_FALSE(isOwnLabel(15));
  EXPECT_TRUE(isOwnLabel(16));
  EXPECT_FALSE(isOwnLabel(255));
}

}  // namespace
}  // namespace insonate
