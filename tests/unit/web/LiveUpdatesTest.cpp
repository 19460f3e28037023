#include "WebRig.h"
#include "http/EventStream.h"

#include <insonate/curriculum/CommentStore.h>

#include <array>
#include <chrono>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Returns the text that a browser would have received by now.
std::string receivedBy(web::EventStream& stream) {
  std::array<char, 4096> part{};
  // Without a connection nothing can be suspended, so that the stream must not be read when it is empty.
  stream.push("probe", 0);
  const auto count = stream.read(nullptr, part.data(), part.size(), -1);
  return count < 0 ? "over" : std::string(part.data(), std::size_t(count));
}

class WebLive : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
  }
  /// The stream of events at this address; the test fails if the page has none.
  std::shared_ptr<web::EventStream> streamOf(const std::string& page, const std::string& secret) const {
    const std::string body = school->get(page, secret).body, attribute = "data-events=\"";
    const std::size_t from = body.find(attribute) + attribute.size();
    EXPECT_THAT(body, HasSubstr("<script src=\"/live.js\" defer"));
    const web::Response response = school->get(body.substr(from, body.find('"', from) - from), secret);
    EXPECT_EQ(response.type, "text/event-stream") << response.body;
    return response.events;
  }
  /// Waits until an event has arrived, at most half a minute.
  static bool isTold(web::EventStream& stream) {
    for (int i = 0; i < 300; ++i) {
      if (receivedBy(stream).find("event: changed") != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }

  std::optional<WebSchool> school;
};
INSONATE_ON_BOTH(WebLive);

TEST_P(WebLive, PagesThatShowAPersonAreToldAndOthersAreNot) {
  const std::string ina = school->signIn("ina"), otto = school->signIn("otto"), anna = school->signIn("anna");
  const auto spring = streamOf("/classes/" + school->spring.id, ina),
             autumn = streamOf("/classes/" + school->autumn.id, otto),
             member = streamOf("/classes/" + school->spring.id + "/people/" + school->anna.id, ina),
             own = streamOf("/me", anna);
  // Looks at the class are in the log, but nothing that a page shows.
  EXPECT_THAT(receivedBy(*spring), Not(HasSubstr("changed")));
  valueOf(CommentStore(school->as(school->ina)).add(school->annas, 0, "Steeper"));
  EXPECT_TRUE(isTold(*spring));
  EXPECT_TRUE(isTold(*member));
  EXPECT_TRUE(isTold(*own));
  EXPECT_THAT(receivedBy(*autumn), Not(HasSubstr("changed")));
}

TEST_P(WebLive, WhatHappensBetweenAPageAndItsStreamIsTold) {
  const std::string ina = school->signIn("ina");
  const std::string page = "/classes/" + school->spring.id, body = school->get(page, ina).body;
  const std::size_t at = body.find("?since=");
  const std::string since = body.substr(at, body.find('"', at) - at);
  keepAttempt(school->as(school->ben));
  EXPECT_THAT(receivedBy(*school->get(page + "/events" + since, ina).events), HasSubstr("event: changed"));
  web::Request again = WebSchool::request("GET", page + "/events" + since, ina);
  again.headers["last-event-id"] = "100000";
  EXPECT_THAT(receivedBy(*school->site.answer(again).events), Not(HasSubstr("event: changed")))
      << "the browser has the newest";
}

TEST_P(WebLive, AUserHasALimitedNumberOfStreams) {
  const std::string ina = school->signIn("ina"), admin = school->signIn("admin");
  std::vector<std::shared_ptr<web::EventStream>> streams;
  for (int i = 0; i < 60; ++i) streams.push_back(streamOf("/me", ina));
  EXPECT_EQ(school->get("/me/events", ina).status, 503);
  EXPECT_TRUE(streamOf("/me", admin)) << "others have theirs";
  streams.front()->detach();
  EXPECT_TRUE(streamOf("/me", ina)) << "a page was closed";
  school->site.endStreams();
  EXPECT_EQ(school->get("/me/events", ina).status, 503);
  EXPECT_EQ(receivedBy(*streams.back()), "over");
}

}  // namespace
}  // namespace insonate::test
