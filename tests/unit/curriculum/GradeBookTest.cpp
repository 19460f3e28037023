#include <insonate/curriculum/GradeBook.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

Person personNamed(const std::string& name, const std::string& email) {
  return {"id-" + name, name, "Full " + name, email};
}

TEST(GradeBook, HasKeyAndGrade) {
  const std::vector<Grade> grades{{personNamed("ada", "ada@example.org"), 87.654, ""},
                                  {personNamed("bob", "bob@example.org"), 100.0, ""}};
  EXPECT_EQ(gradeBook("Jugular test", GradeKey::Email, grades).csv,
            "\uFEFFEmail address,Jugular test\r\nada@example.org,87.65\r\nbob@example.org,100\r\n");
  EXPECT_EQ(gradeBook("Jugular test", GradeKey::Name, grades).csv,
            "\uFEFFID number,Jugular test\r\nada,87.65\r\nbob,100\r\n");
}

TEST(GradeBook, FeedbackNeverComesWithoutItsGrade) {
  const std::vector<Grade> grades{{personNamed("ada", "a@x.org"), 80.0, "=Good"},
                                  {personNamed("bob", "b@x.org"), std::nullopt, "Begin"},
                                  {personNamed("cyd", ""), 70.0, "No key"},
                                  {personNamed("dee", "d@x.org"), std::numeric_limits<double>::quiet_NaN(), "?"},
                                  {personNamed("eve", "e@x.org"), 0.0, ""}};
  const GradeBook book = gradeBook("T", GradeKey::Email, grades);
  EXPECT_EQ(book.csv, "\uFEFFEmail address,T,T (feedback)\r\na@x.org,80,'=Good\r\ne@x.org,0,\r\n");
  ASSERT_EQ(book.leftOut.size(), 3U);
  EXPECT_EQ(book.leftOut[0].fullName, "Full bob");
  EXPECT_EQ(book.leftOut[0].why, "no grade yet");
  EXPECT_EQ(book.leftOut[1].fullName, "Full cyd");
  EXPECT_EQ(book.leftOut[1].why, "no e-mail address");
  EXPECT_EQ(book.leftOut[2].why, "no grade yet");
  // If only people who are left out have feedback, there is no such column.
  EXPECT_EQ(gradeBook("T", GradeKey::Email, std::span(grades).subspan(1)).csv,
            "\uFEFFEmail address,T\r\ne@x.org,0\r\n");
}

}  // namespace
}  // namespace insonate
