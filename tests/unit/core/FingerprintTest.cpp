#include <insonate/core/Fingerprint.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

/// The values that the hash's authors publish.
TEST(Fingerprint, IsThatOfItsAuthors) {
  Fingerprint none, letter, word;
  EXPECT_EQ(none.text(), "cbf29ce484222325");
  letter.add("a");
  EXPECT_EQ(letter.text(), "af63dc4c8601ec8c");
  word.add("foo"), word.add("bar");
  EXPECT_EQ(word.text(), "85944171f73967e8");
}

}  // namespace
}  // namespace insonate
