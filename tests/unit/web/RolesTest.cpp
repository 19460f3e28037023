#include "RawClient.h"
#include "RouteTable.h"
#include "http/HttpServer.h"
#include "page/Page.h"

#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/Workstations.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Secret of a session, or token of a workstation.
struct Sender {
  std::string secret{}, token{};
};

struct Answer {
  int status = 0;
  std::string text{};  ///< headers and body
};

/// The pages of a school behind a server, which is asked over connections.
class WebRoles : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    const web::Site& site = school->site;
    auto started = web::HttpServer::start(
        {.port = 0}, [&](const web::Request& request) { return site.answer(request); }, {}, {},
        [&](const web::Request& request) { return site.admit(request); });
    if (!started) throw std::runtime_error(started.error().message);
    server = std::move(*started);
  }
  void TearDown() override {
    if (school) school->site.endStreams();
  }

  Answer ask(std::string_view method, const std::string& path, web::Fields form, const Sender& sender) const {
    const bool isPost = method == "POST";
    if (!sender.secret.empty()) form.emplace("code", web::formCode(sender.secret));
    std::string body;
    if (isPost)
      for (const auto& [name, value] : form)
        body += (body.empty() ? "" : "&") + web::encoded(name) + "=" + web::encoded(value);
    // The name of the server in a network: programs on the server's computer may read more.
    std::string head = std::string(method) + " " + path + " HTTP/1.1\r\nHost: site.example\r\nConnection: close\r\n" +
                       "Sec-Fetch-Site: same-origin\r\n";
    if (!sender.secret.empty()) head += "Cookie: insonate=" + sender.secret + "\r\n";
    if (!sender.token.empty()) head += "Authorization: Bearer " + sender.token + "\r\n";
    if (isPost)
      head +=
          "Content-Type: application/x-www-form-urlencoded\r\nContent-Length: " + std::to_string(body.size()) + "\r\n";
    web::RawClient client(server->port());
    client.send(head + "\r\n" + body);
    Answer answer{.text = client.receiveUntil("\r\n\r\n")};
    EXPECT_THAT(answer.text, StartsWith("HTTP/1.1 "));
    // A stream of events does not end.
    if (answer.text.find("text/event-stream") == std::string::npos) answer.text += client.receive();
    answer.status = answer.text.size() > 12 ? std::stoi(answer.text.substr(9, 3)) : 0;
    return answer;
  }
  Sender signedIn(const std::string& name) const { return {.secret = school->signIn(name)}; }

  /// Senders whose session or token is missing, has ended or was revoked.
  std::map<std::string, Sender> outsiders() {
    std::map<std::string, Sender> senders{{"guest", {}}, {"expired session", signedIn("ina")}};
    rig->pass(BrowserSessions::kLongest_us + kSecond_us);
    const Person vera = school->add("vera", Role::Instructor, school->spring.id);
    senders["revoked session"] = signedIn("vera");
    succeed(PeopleStore(school->admin).resetPassword(vera.id, "another password"));
    senders["revoked token"] = {.token = valueOf(Workstations(school->admin).add("ward 8"))};
    succeed(Workstations(school->admin).revoke("ward 8"));
    senders["workstation"] = {.token = valueOf(Workstations(school->admin).add("ward 9"))};
    return senders;
  }

  void expectOfOutsider(const RouteLine& line, const std::string& who, const Sender& sender) const {
    FreshTargets targets(*school);
    const Answer answer = ask(line.method, targets.filledIn(line.path), targets.filledIn(line.form), sender);
    const int usual = line.guest > 0 ? line.guest : line.method == "GET" ? 303 : 403;
    EXPECT_EQ(answer.status, who == "workstation" && line.workstation > 0 ? line.workstation : usual) << answer.text;
    if (line.guest == 0 && line.method == "GET") {
      EXPECT_THAT(answer.text, HasSubstr("Location: /sign-in?next="));
    }
    EXPECT_THAT(answer.text, Not(HasSubstr("Dr anna")));
  }

  void expectOfUser(const RouteLine& line, std::size_t user, const std::map<std::string, Sender>& senders) const {
    FreshTargets targets(*school);
    const std::string path = targets.filledIn(line.path);
    const web::Fields form = targets.filledIn(line.form);
    const bool isNewPerson = user == kSelf && targets.person();
    const Answer answer =
        ask(line.method, path, form, isNewPerson ? signedIn(targets.person()->name) : senders.at(kUsers[user]));
    EXPECT_EQ(answer.status, line.statuses[user]) << answer.text.substr(0, 2000);
    // A refusal tells no stranger about Anna; her instructor and an administrator may see her on the page that says it.
    const bool isStranger = user != kSelf && kUsers[user] != "ina" && kUsers[user] != "admin";
    if (answer.status != 200 && isStranger) {
      EXPECT_THAT(answer.text, Not(HasSubstr("Dr anna")));
    }
  }

  std::optional<WebSchool> school;
  std::unique_ptr<web::HttpServer> server;
};
INSONATE_ON_BOTH(WebRoles);

TEST_P(WebRoles, EachRouteAnswersEachUserAsTheDatabaseAllows) {
  const auto others = outsiders();
  std::map<std::string, Sender> senders;
  for (const std::string& name : kUsers) senders[name] = signedIn(name);
  for (const RouteLine& line : routeTable(*school)) {
    for (const auto& [who, sender] : others) {
      SCOPED_TRACE(who + ": " + std::string(line.method) + " " + line.path);
      expectOfOutsider(line, who, sender);
    }
    for (std::size_t user = 0; user < kUsers.size(); ++user) {
      SCOPED_TRACE(kUsers[user] + ": " + std::string(line.method) + " " + line.path);
      expectOfUser(line, user, senders);
    }
  }
}

/// Tells whether the path fits the pattern, in which "*" stands for one part.
bool fits(std::string_view pattern, const std::string& path) {
  const auto parts = [](std::string_view text) {
    std::vector<std::string_view> all;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('/', begin), text.size());
      all.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    return all;
  };
  const auto expected = parts(pattern), given = parts(std::string_view(path).substr(0, path.find('?')));
  return expected.size() == given.size() &&
         std::equal(expected.begin(), expected.end(), given.begin(),
                    [](std::string_view wanted, std::string_view part) { return wanted == "*" || wanted == part; });
}

TEST_P(WebRoles, TheTableHasALineForEachRoute) {
  std::set<std::pair<std::string_view, std::string_view>> missing;
  for (const auto& route : web::Site::routes()) missing.insert(route);
  const auto lines = routeTable(*school);
  for (const RouteLine& line : lines) {
    EXPECT_TRUE(fits(line.route, line.path)) << line.path << " is not an address of the route " << line.route;
    missing.erase({line.method, line.route});
  }
  for (const auto& [method, route] : missing) ADD_FAILURE() << method << " " << route << " has no line in the table";
  EXPECT_GE(lines.size(), web::Site::routes().size());
}

}  // namespace
}  // namespace insonate::test
