#include "WebRig.h"

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/curriculum/AuditLog.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

class WebAuditAnchors : public OnBoth {};
INSONATE_ON_BOTH(WebAuditAnchors);

TEST_P(WebAuditAnchors, AreWrittenFromTheStartOfTheServerToItsEnd) {
  const CurriculumStore store = rig->open();
  const School school(store);
  const web::WebOptions options{
      .port = 0, .videos = rig->folder / "videos", .auditAnchors = rig->folder / "audit.anchors"};
  {
    const auto server = web::WebServer::start(store, options);
    ASSERT_TRUE(server) << server.error().message;
    ASSERT_EQ(valueOf(readAuditAnchors(options.auditAnchors)).size(), 1U);
    EXPECT_FALSE(AuditLog(school.as(school.ina)).anchor()) << "an entry while the server runs";
  }
  const auto anchors = valueOf(readAuditAnchors(options.auditAnchors));
  EXPECT_GT(anchors.back().number, anchors.front().number) << "the end of the log is written when the server ends";
  EXPECT_TRUE(AuditLog(school.admin).verify(anchors));
}

TEST_P(WebAuditAnchors, AFileThatCannotBeWrittenKeepsTheServerFromStarting) {
  const web::WebOptions options{.port = 0, .auditAnchors = rig->folder.path() / "no folder" / "anchors"};
  const auto server = web::WebServer::start(rig->open(), options);
  ASSERT_FALSE(server);
  EXPECT_THAT(server.error().message, HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace insonate::test
