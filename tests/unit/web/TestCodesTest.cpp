#include "WebRig.h"

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebTestCodes : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (rig) school.emplace(rig->open());
  }
  std::string pageWith(const std::string& cookie, const std::string& secret) const {
    web::Request request = WebSchool::request("GET", address(), secret);
    const std::size_t equals = cookie.find('=');
    request.cookies[cookie.substr(0, equals)] = cookie.substr(equals + 1, cookie.find(';') - equals - 1);
    return school->site.answer(request).body;
  }
  std::string address() const { return "/classes/" + school->spring.id + "/tests"; }

  std::optional<WebSchool> school;
};
INSONATE_ON_BOTH(WebTestCodes);

TEST_P(WebTestCodes, OnlyTheSessionThatOpenedATestShowsItsCode) {
  const std::string ina = school->signIn("ina");
  const std::string code = "ven\u00fcs;1";
  const web::Response opened =
      school->post(address(), {{"level", "jugular_test"}, {"whom", "class"}, {"test-code", code}}, ina);
  ASSERT_EQ(opened.status, 303) << opened.body;
  const std::string cookie = headerOf(opened, "Set-Cookie");
  EXPECT_THAT(cookie,
              AllOf(HasSubstr("; Path=" + address() + ";"), HasSubstr("HttpOnly"), HasSubstr("SameSite=Strict")));
  EXPECT_THAT(pageWith(cookie, ina), HasSubstr("with the code " + code));
  EXPECT_THAT(school->get(address(), ina).body, AllOf(HasSubstr("<td>with a code</td>"), Not(HasSubstr(code))))
      << "another browser does not have it";
  EXPECT_THAT(pageWith(cookie, school->signIn("ina")), Not(HasSubstr(code))) << "after signing in again";
  EXPECT_THAT(pageWith(cookie, school->signIn("admin")), Not(HasSubstr(code))) << "another user of the browser";
}

TEST_P(WebTestCodes, ATestWithoutACodeLeavesNoCookie) {
  const web::Response opened = school->post(
      address(), {{"level", "jugular_test"}, {"whom", "class"}, {"end", "2100-01-01T00:00"}}, school->signIn("ina"));
  ASSERT_EQ(opened.status, 303);
  EXPECT_EQ(headerOf(opened, "Set-Cookie"), "");
}

}  // namespace
}  // namespace insonate::test
