#include <insonate/igtlink/LinkCommand.h>

#include <gmock/gmock.h>

#include <random>

namespace insonate {
namespace {

TEST(LinkCommandText, IsReadAsPlusWritesIt) {
  const auto command = parsedCommand(
      "<?xml version=\"1.0\"?>\n<Command Name=\"SetUsParameter\" UsDeviceId='USDevice'>\n"
      "  <!-- depth -->\n  <Parameter Name=\"DepthMm\" Value=\"50\"/>\n"
      "  <Parameter Name=\"Note\" Value=\"&lt;a&gt; &amp; &quot;b&apos;\"></Parameter>\n</Command>\n");
  ASSERT_TRUE(command) << command.error().message;
  EXPECT_EQ(command->name, "SetUsParameter");
  ASSERT_EQ(command->parameters.size(), 2U);
  EXPECT_EQ(command->parameters[0].name, "DepthMm");
  EXPECT_EQ(command->parameters[0].value, "50");
  EXPECT_EQ(command->parameters[1].value, "<a> & \"b'");
}

TEST(LinkCommandText, CharactersMayBeReferredToByNumber) {
  const auto command = parsedCommand("<Command Name=\"Get&#65;\"/>");
  ASSERT_TRUE(command) << command.error().message;
  EXPECT_EQ(command->name, "GetA");
}

TEST(LinkCommandText, ThatIsNoCommandIsRefused) {
  for (const char* text : {"", "DepthMm 50", "<Command", "<Command Name=\"a\">", "<Command Name=\"a\"></Order>",
                           "<Command Name=a/>", "<Command Name=\"a\" Name=\"b\"/>", "<Command Name=\"a\"/><b/>", "<<<<",
                           "<!DOCTYPE x [<!ENTITY y \"z\">]><Command Name=\"a\"/>"})
    EXPECT_FALSE(parsedCommand(text)) << text;
  const auto nameless = parsedCommand("<Command/>");
  ASSERT_FALSE(nameless);
  EXPECT_EQ(nameless.error().message, "The command is not an element Command with an attribute Name.");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_FALSE(parsedCommand(deep));
}

TEST(LinkCommandText, WithRandomChangesIsReadOrRefused) {
  std::mt19937 random(7);
  const std::string valid =
      "<Command Name=\"SetUsParameter\"><Parameter Name='DepthMm' Value=\"5&amp;0\"/><!-- x --></Command>";
  int read = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string text = valid;
    if (round % 2 == 0) text.resize(std::uniform_int_distribution<std::size_t>(valid.size() / 2, valid.size())(random));
    for (int change = std::uniform_int_distribution<int>(0, 3)(random); change > 0; --change)
      text[std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random)] = static_cast<char>(random());
    read += parsedCommand(text) ? 1 : 0;
  }
  EXPECT_GT(read, 100);
}

TEST(LinkReplyText, HasTheFormOfPlus) {
  EXPECT_EQ(replyText({true, "The depth is 50 mm.", {}}),
            "<CommandReply Status=\"SUCCESS\" Message=\"The depth is 50 mm.\" />");
  EXPECT_EQ(replyText({false, "\"<&", {{"DepthMm", "40", false}}}),
            "<CommandReply Status=\"FAIL\" Message=\"&quot;&lt;&amp;\"><Parameter Name=\"DepthMm\" Success=\"false\" "
            "Value=\"40\" /></CommandReply>");
}

}  // namespace
}  // namespace insonate
