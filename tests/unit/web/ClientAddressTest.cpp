#include "WebRig.h"
#include "http/ClientAddress.h"
#include "http/SocketAddress.h"

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

web::Request requestFrom(const std::string& client, const std::string& forwarded = {}) {
  web::Request request{.method = "GET", .path = "/", .client = client};
  if (!forwarded.empty()) request.headers["x-forwarded-for"] = forwarded;
  return request;
}

TEST(WebClientAddress, IsThatOfTheConnectionUnlessANamedProxyStatesAnother) {
  const web::WebOptions direct, unnamed{.behindProxy = true}, named{.proxies = {"10.0.0.2", "10.0.0.3"}};
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.9", "1.2.3.4"), direct), "10.0.0.9");
  EXPECT_EQ(clientAddress(requestFrom("127.0.0.1", "1.2.3.4"), unnamed), "");
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "1.2.3.4"), named), "1.2.3.4");
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.9", "1.2.3.4"), named), "10.0.0.9") << "not from the proxy";
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "9.9.9.9, 1.2.3.4"), named), "1.2.3.4") << "a client wrote 9.9.9.9";
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "9.9.9.9 ,1.2.3.4,\t10.0.0.3"), named), "1.2.3.4") << "two proxies";
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "2001:db8::1"), named), "2001:db8::1");
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "2001:0DB8:0:0::1"), named), "2001:db8::1") << "the same address";
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "::ffff:1.2.3.4"), named), "1.2.3.4");
  EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", "1.2.3.4, ::ffff:10.0.0.3"), named), "1.2.3.4");
  const web::WebOptions version6{.proxies = {"0:0:0:0:0:0:0:1"}};
  EXPECT_EQ(clientAddress(requestFrom("::1", "2001:db8::9"), version6), "2001:db8::9");
  EXPECT_EQ(clientAddress(requestFrom("2001:db8::2", "2001:db8::9"), version6), "2001:db8::2") << "not from the proxy";
  for (const std::string bad : {"", "unknown", "1.2.3.4, <script>", "1.2.3.4,"})
    EXPECT_EQ(clientAddress(requestFrom("10.0.0.2", bad), named), "") << bad;
}

TEST(WebClientAddress, OneSubscriberHasOneNetwork) {
  EXPECT_EQ(web::networkOf("10.0.0.9"), "10.0.0.9");
  EXPECT_EQ(web::networkOf("2001:db8:1:2:3:4:5:6"), web::networkOf("2001:db8:1:2::9"));
  EXPECT_NE(web::networkOf("2001:db8:1:2::9"), web::networkOf("2001:db8:1:3::9"));
  EXPECT_EQ(web::networkOf("::ffff:10.0.0.9"), "10.0.0.9");
}

TEST(WebClientAddress, PasswordsStayOnThisComputerWithoutACertificate) {
  const auto isAllowed = [](const std::string& address) { return web::checkOptions({.address = address}).has_value(); };
  for (const std::string here : {"127.0.0.1", "127.9.9.9", "::1", "0:0:0:0:0:0:0:1", "::ffff:127.0.0.1", "localhost"})
    EXPECT_TRUE(isAllowed(here)) << here;
  for (const std::string elsewhere :
       {"0.0.0.0", "::", "10.0.0.5", "2001:db8::1", "::ffff:10.0.0.5", "127.evil.invalid", "::1%lo", "[::1]", ""})
    EXPECT_FALSE(isAllowed(elsewhere)) << elsewhere;
  EXPECT_EQ(web::withPort("::1", 80), "[::1]:80");
  EXPECT_EQ(web::withPort("127.0.0.1", 80), "127.0.0.1:80");
}

TEST(WebClientAddress, OnlyADirectRequestComesFromHere) {
  web::Request request = requestFrom("127.0.0.1");
  request.headers["host"] = "127.0.0.1:8443";
  EXPECT_TRUE(web::isFromHere(request));
  request.headers["host"] = "localhost";
  EXPECT_TRUE(web::isFromHere(request));
  for (const std::string host : {"", "insonate.example", "127.0.0.1.insonate.example", "127.evil.example:80"}) {
    request.headers["host"] = host;
    EXPECT_FALSE(web::isFromHere(request)) << host;
  }
  request = requestFrom("::1");
  request.headers["host"] = "[::1]:8443";
  EXPECT_TRUE(web::isFromHere(request));
  for (const std::string host : {"[2001:db8::1]:8443", "[", "::1.evil.example"}) {
    request.headers["host"] = host;
    EXPECT_FALSE(web::isFromHere(request)) << host;
  }
  request = requestFrom("127.0.0.1", "10.0.0.9");
  request.headers["host"] = "localhost";
  EXPECT_FALSE(web::isFromHere(request)) << "passed on by a proxy";
  request = requestFrom("10.0.0.9");
  request.headers["host"] = "localhost";
  EXPECT_FALSE(web::isFromHere(request));
}

class WebSignInLimit : public OnBoth {};
INSONATE_ON_BOTH(WebSignInLimit);

TEST_P(WebSignInLimit, WrongPasswordsOfAnAddressAreLimitedWhateverTheNames) {
  const WebSchool school(rig->open());
  const auto answer = [&](const std::string& client, const std::string& name, const std::string& password) {
    web::Request request = WebSchool::request("POST", "/sign-in", "");
    request.client = client;
    request.form = {{"name", name}, {"password", password}};
    return school.site.answer(request);
  };
  for (int i = 0; i < 10; ++i) EXPECT_EQ(answer("10.0.0.9", "anna", kPassword).status, 303) << "a class signs in";
  for (int i = 0; i < 30; ++i)
    EXPECT_THAT(answer("10.0.0.9", "invented" + std::to_string(i), "wrong password").body, HasSubstr("is wrong"));
  EXPECT_THAT(answer("10.0.0.9", "anna", kPassword).body, HasSubstr("this network address. Try again in 60 s"));
  EXPECT_EQ(answer("10.0.0.8", "anna", kPassword).status, 303) << "another address";
  // Three tries within a minute, which do not put the end of the minute off.
  for (int i = 0; i < 3; ++i) {
    rig->pass(19 * kSecond_us);
    EXPECT_EQ(answer("10.0.0.9", "anna", kPassword).status, 401);
  }
  rig->pass(3 * kSecond_us);
  EXPECT_EQ(answer("10.0.0.9", "anna", "wrong password").status, 401) << "one more try each minute";
  EXPECT_THAT(answer("10.0.0.9", "anna", kPassword).body, HasSubstr("this network address"));
  rig->pass(60 * kSecond_us);
  EXPECT_EQ(answer("10.0.0.9", "anna", kPassword).status, 303);
  EXPECT_EQ(answer("10.0.0.9", "anna", kPassword).status, 303) << "a right password does not count";
}

TEST_P(WebSignInLimit, WrongPasswordsOfANetworkOfVersion6CountTogether) {
  const WebSchool school(rig->open());
  const auto answer = [&](const std::string& client, const std::string& name, const std::string& password) {
    web::Request request = WebSchool::request("POST", "/sign-in", "");
    request.client = client;
    request.form = {{"name", name}, {"password", password}};
    return school.site.answer(request);
  };
  for (int i = 0; i < 30; ++i)
    (void)answer("2001:db8:1:2::" + std::to_string(i + 1), "invented" + std::to_string(i), "wrong password");
  EXPECT_THAT(answer("2001:db8:1:2:9::9", "anna", kPassword).body, HasSubstr("this network address"));
  EXPECT_EQ(answer("2001:db8:1:3::1", "anna", kPassword).status, 303) << "another network";
}

TEST_P(WebSignInLimit, NoNameLocksAnAddress) {
  const WebSchool school(rig->open());
  web::Request request = WebSchool::request("POST", "/sign-in", "");
  request.client = "10.0.0.9";
  request.form = {{"name", "address 10.0.0.9"}, {"password", "wrong password"}};
  for (int i = 0; i < 7; ++i) (void)school.site.answer(request);
  request.form = {{"name", "anna"}, {"password", kPassword}};
  EXPECT_EQ(school.site.answer(request).status, 303);
}

}  // namespace
}  // namespace insonate::test
