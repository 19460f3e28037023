#include "http/Messages.h"
#include "page/Markup.h"

#include <gmock/gmock.h>

namespace insonate::web {
namespace {

using ::testing::Pair;
using ::testing::UnorderedElementsAre;

TEST(WebMessages, FormsAreDecoded) {
  EXPECT_THAT(fieldsOfForm("name=Ada+L%C3%B6w&password=a%26b%3Dc&empty=&=none&noValue"),
              UnorderedElementsAre(Pair("name", "Ada L\xC3\xB6w"), Pair("password", "a&b=c"), Pair("empty", ""),
                                   Pair("", "none")));
  EXPECT_THAT(fieldsOfForm("a=1&a=2"), UnorderedElementsAre(Pair("a", "1"))) << "the first counts";
  EXPECT_THAT(fieldsOfForm(""), testing::IsEmpty());
}

TEST(WebMessages, WhatIsNoTextIsLeftOut) {
  EXPECT_EQ(decoded("a%00b%0Dc%1B", false), "abc");
  EXPECT_EQ(decoded("line%0Aline", false), "line\nline");
  EXPECT_EQ(decoded("%FF%FEx", false), "x");
  EXPECT_EQ(decoded("%C0%AF", false), "") << "an overlong slash";
  EXPECT_EQ(decoded("100%", false), "100%");
  EXPECT_EQ(decoded("a+b", false), "a+b");
}

TEST(WebMessages, EncodedTextDecodesToItself) {
  const std::string hostile = "a/b?c&d=e+f%g \xC3\xA4 \"<'";
  EXPECT_EQ(encoded(hostile).find_first_of("/?&=+ \"<'"), std::string::npos);
  EXPECT_EQ(decoded(encoded(hostile), true), hostile);
}

TEST(WebMessages, CookiesAreSplit) {
  EXPECT_THAT(fieldsOfCookies("insonate=abc; other=1;bad;  third = x"),
              UnorderedElementsAre(Pair("insonate", "abc"), Pair("other", "1"), Pair("third", "x")));
}

TEST(WebMarkup, TextAndAttributesAreEscaped) {
  const std::string hostile = "<script>alert('1')</script>\"&";
  EXPECT_EQ(text(hostile).html(), "&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;&quot;&amp;");
  const std::string html = element("a", {{"title", hostile}}, hostile).html();
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(element("a", {{"title", "\" onclick=\"x"}}, "y").html(), "<a title=\"&quot; onclick=&quot;x\">y</a>");
  EXPECT_EQ(element("br", {}).html(), "<br>");
}

}  // namespace
}  // namespace insonate::web
