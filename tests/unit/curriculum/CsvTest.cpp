#include <insonate/curriculum/Csv.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::vector<std::string>> fieldsOf(const std::string& text) {
  const auto rows = parseCsv(text);
  EXPECT_TRUE(rows) << (rows ? "" : rows.error().message);
  std::vector<std::vector<std::string>> fields;
  if (rows)
    for (const CsvRow& row : *rows) fields.push_back(row.fields);
  return fields;
}

/// Without the byte order mark.
std::string plainText(const std::vector<std::vector<std::string>>& rows) {
  return csvText(rows).substr(3);
}

TEST(Csv, QuotesHoldSeparatorsBreaksAndQuotes) {
  EXPECT_THAT(fieldsOf("a,\"b,\"\"c\"\"\",d\r\n1,\"two\nlines\",\r\n"),
              ElementsAre(ElementsAre("a", "b,\"c\"", "d"), ElementsAre("1", "two\nlines", "")));
  EXPECT_THAT(fieldsOf("a,\"\"\n"), ElementsAre(ElementsAre("a", "")));
}

TEST(Csv, AnyLineEndSeparatorAndMarkIsRead) {
  for (const std::string end : {"\n", "\r\n", "\r"})
    EXPECT_THAT(fieldsOf("\xEF\xBB\xBFname;mail" + end + end + "\"A;B\";c,d" + end + "x;y"),
                ElementsAre(ElementsAre("name", "mail"), ElementsAre("A;B", "c,d"), ElementsAre("x", "y")));
  EXPECT_THAT(fieldsOf("\"a,b,c\"\td\n1\t2"), ElementsAre(ElementsAre("a,b,c", "d"), ElementsAre("1", "2")));
  EXPECT_TRUE(fieldsOf("").empty());
  EXPECT_TRUE(fieldsOf("\n\n").empty());
}

TEST(Csv, AFirstLineCanNameTheSeparator) {
  for (const std::string line : {"sep=;\r\n", "SEP=;\n", "\"sep=;\"\n", "\xEF\xBB\xBFsep=;\r\n"}) {
    const auto rows = parseCsv(line + "\"a,b\",c,d;e\n1;2\n");
    EXPECT_THAT(rows.error().message, HasSubstr("Line 2 has text after a closing quote")) << line;
    EXPECT_THAT(fieldsOf(line + "a,b,c;d\n1;2\n"), ElementsAre(ElementsAre("a,b,c", "d"), ElementsAre("1", "2")))
        << line;
  }
  EXPECT_EQ(parseCsv("sep=;\r\na;b\r\n")->front().line, 2);
  EXPECT_TRUE(fieldsOf("sep=;").empty());
  EXPECT_THAT(fieldsOf("sep=x\n"), ElementsAre(ElementsAre("sep=x")));
}

TEST(Csv, RowsKnowTheirLines) {
  const auto rows = parseCsv("a\n\"two\nlines\"\n\nb\r\nc");
  ASSERT_TRUE(rows);
  std::vector<int> lines;
  for (const CsvRow& row : *rows) lines.push_back(row.line);
  EXPECT_THAT(lines, ElementsAre(1, 2, 5, 6));
}

TEST(Csv, WhatIsNoCsvIsRefusedWithItsLine) {
  EXPECT_THAT(parseCsv("a\nb,\"c\nd").error().message, HasSubstr("Line 2 opens a quote that is never closed"));
  EXPECT_THAT(parseCsv("\"").error().message, HasSubstr("Line 1 opens a quote"));
  EXPECT_THAT(parseCsv("a\n\"b\"c").error().message, HasSubstr("Line 2 has text after a closing quote"));
  EXPECT_THAT(parseCsv("J\xFCrgen,1").error().message, HasSubstr("not UTF-8"));
  EXPECT_THAT(parseCsv(std::string("a\0b", 3)).error().message, HasSubstr("zero byte"));
}

TEST(Csv, ByteOrderMarkIsWrittenAndReadBack) {
  const std::string text = csvText({{"J\u00fcrgen"}, {"\uFEFFx"}});
  EXPECT_EQ(text, "\xEF\xBB\xBFJ\u00fcrgen\r\n\uFEFFx\r\n");
  EXPECT_THAT(fieldsOf(text), ElementsAre(ElementsAre("J\u00fcrgen"), ElementsAre("\uFEFFx"))) << "the first one only";
}

TEST(Csv, FormulasAreDefused) {
  EXPECT_EQ(plainText({{"=1+1", "+49 30", "-cmd", "@x", "\tx", "\rx"}}),
            "'=1+1,'+49 30,'-cmd,'@x,\"'\tx\",\"'\rx\"\r\n");
  EXPECT_EQ(plainText({{"=HYPERLINK(\"http://x\",\"y\")"}}), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"\r\n");
  EXPECT_EQ(plainText({{"-3.5", "1e-7", "-inf", "a=b", ""}}), "-3.5,1e-7,'-inf,a=b,\r\n");
}

TEST(Csv, FormulasAreDefusedForOtherSeparatorsToo) {
  // In files separated by semicolons or tabs, a quote within a field is text and a line's end ends a row.
  EXPECT_EQ(plainText({{"a", "x;=1+1;y"}}), "a,\"x;'=1+1;y\"\r\n");
  EXPECT_EQ(plainText({{"a", "x\t@y"}}), "a,\"x\t'@y\"\r\n");
  EXPECT_EQ(plainText({{"a", "x\r\n=1+1\n-z"}}), "a,\"x\r\n'=1+1\n'-z\"\r\n");
  EXPECT_EQ(plainText({{"\uFF1D1+1", "\uFF0Bx", "\uFF0Dx", "\uFF20x"}}), "'\uFF1D1+1,'\uFF0Bx,'\uFF0Dx,'\uFF20x\r\n");
  EXPECT_EQ(plainText({{"a=b", "well-made", "a; b", "x\r\n\r\ny"}}), "a=b,well-made,\"a; b\",\"x\r\n\r\ny\"\r\n");
}

TEST(Csv, WhatIsWrittenIsReadAsTheSame) {
  std::mt19937 random(3);
  const std::vector<std::string> letters{"a", ",", ";", "\t", "\"", "\r", "\n", "'", " ", "\xC3\xA4"};
  for (int run = 0; run < 300; ++run) {
    std::vector<std::vector<std::string>> rows(1 + random() % 4, std::vector<std::string>(2));
    for (auto& row : rows)
      for (std::string& field : row) {
        field = "x";
        for (auto n = random() % 6; n > 0; --n) field += letters[random() % letters.size()];
      }
    rows.insert(rows.begin(), {"a", "b"});  // the head line settles the separator
    EXPECT_EQ(fieldsOf(csvText(rows)), rows);
  }
}

TEST(Csv, NumbersAreShortAndTheSameEverywhere) {
  EXPECT_EQ(csvNumber(0.1), "0.1");
  EXPECT_EQ(csvNumber(-12.5), "-12.5");
  EXPECT_EQ(csvNumber(std::nullopt), "");
  EXPECT_EQ(csvNumber(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(csvNumber(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

TEST(Csv, WhatSpreadsheetsCallUnicodeIsNamed) {
  const auto rows = parseCsv(std::string_view("\xFF\xFEn\0a\0", 6));
  ASSERT_FALSE(rows);
  EXPECT_THAT(rows.error().message, HasSubstr("UTF-16"));
}

}  // namespace
}  // namespace insonate
