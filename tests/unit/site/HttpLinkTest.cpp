#include "unit/curriculum/StoreRig.h"

#include <insonate/curriculum/Workstations.h>
#include <insonate/site/HttpLink.h>
#include <insonate/web/WebServer.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

/// A server that listens at a port of this computer, and a workstation.
class HttpLinkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    rig.services.workstation = "server";
    rig.services.now_us = {};
    school.emplace(rig.open());
    ward.services.now_us = {};
    near.emplace(ward.open());
    token = valueOf(Workstations(school->admin).add("ward 7"));
  }
  /// Starts the server and returns its address.
  std::string serve(web::WebOptions options = {}) {
    options.port = 0;
    auto started = web::WebServer::start(school->store, options);
    if (!started) throw std::runtime_error(started.error().message);
    server.emplace(std::move(*started));
    return server->url();
  }
  SiteUpload siteAt(const std::string& url, const std::filesystem::path& authority = {}) const {
    return {*near, valueOf(httpLink({.url = url, .token = token, .authority = authority}))};
  }
  /// An attempt with a recording of this size, which is not one of Insonate.
  std::string addAttempt(std::size_t size_bytes) const {
    const SignedIn anna = valueOf(near->signIn("anna", kPassword));
    const auto file = ward.folder / "recording";
    std::ofstream(file) << std::string(size_bytes, 'a');
    AttemptFacts facts = endedFacts(begunFacts());
    facts.curriculum.clear(), facts.level.clear();
    facts.recordingHash.clear();
    const auto sum = ward.folder / "sum";
    if (std::system(("sha256sum '" + file.string() + "' > '" + sum.string() + "'").c_str()) != 0)
      throw std::runtime_error("sha256sum failed");
    std::ifstream(sum) >> facts.recordingHash;
    return valueOf(AttemptStore(anna).add(facts, file));
  }
  AttemptProof proofOf(const std::string& attempt) const {
    return valueOf(AttemptStore(school->admin).attempt(attempt)).facts.proof;
  }
  /// A certificate for 127.0.0.1 that signs itself; false without openssl.
  bool makeCertificate() const {
    return std::system(("openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=127.0.0.1 -addext "
                        "subjectAltName=IP:127.0.0.1 -keyout '" +
                        (rig.folder / "key.pem").string() + "' -out '" + (rig.folder / "certificate.pem").string() +
                        "' 2>/dev/null")
                           .c_str()) == 0;
  }

  StoreRig rig, ward;
  std::optional<School> school;
  std::optional<CurriculumStore> near;
  std::optional<web::WebServer> server;
  std::string token;
};

TEST_F(HttpLinkTest, AttemptsAndRecordingsArriveAndAreVerified) {
  const SiteUpload site = siteAt(serve());
  EXPECT_EQ(valueOf(site.signIn("anna", kPassword)), SiteUpload::Reached::Yes);
  const std::string attempt = addAttempt(1'300'000);
  const UploadReport report = valueOf(site.exchange());
  EXPECT_EQ(report.attempts, 1);
  EXPECT_EQ(report.recordings, 1);
  for (int i = 0; i < 100 && proofOf(attempt) == AttemptProof::Verifying; ++i) std::this_thread::sleep_for(100ms);
  EXPECT_EQ(proofOf(attempt), AttemptProof::Unproven) << "the file is no recording of an attempt";
  EXPECT_TRUE(std::filesystem::exists(valueOf(AttemptStore(school->admin).attempt(attempt)).recordingFile));
}

TEST_F(HttpLinkTest, TheServersSentencesReachTheUser) {
  const SiteUpload site = siteAt(serve());
  EXPECT_THAT(refusalOf(site.signIn("anna", "wrong password")), HasSubstr("password"));
  succeed(Workstations(school->admin).revoke("ward 7"));
  EXPECT_THAT(refusalOf(site.exchange()), HasSubstr("does not accept this computer's token"));
}

TEST_F(HttpLinkTest, AnUnknownTokenIsToldToWorkstationsThatSendMuch) {
  const std::string large(3 << 20, 'a');
  const SiteLink known = valueOf(httpLink({.url = serve(), .token = token}));
  EXPECT_THAT(valueOf(known.send("facts", large)).text, HasSubstr("not a message of Insonate"));
  succeed(Workstations(school->admin).revoke("ward 7"));
  const SiteAnswer refused = valueOf(known.send("facts", large));
  EXPECT_TRUE(refused.isRefusal);
  EXPECT_THAT(refused.text, HasSubstr("does not accept this computer's token"));
}

TEST_F(HttpLinkTest, AnAddressThatIsNoServerIsTold) {
  const std::string url = serve();
  server.reset();
  EXPECT_THAT(refusalOf(siteAt(url).exchange()), HasSubstr("cannot be reached"));
  EXPECT_THAT(refusalOf(siteAt(serve() + "classes").exchange()), HasSubstr("status 404"));
  EXPECT_THAT(refusalOf(httpLink({.url = "http://example.org", .token = token})), HasSubstr("unencrypted"));
  EXPECT_THAT(refusalOf(httpLink({.url = "http://127.example.org", .token = token})), HasSubstr("unencrypted"));
  EXPECT_THAT(refusalOf(httpLink({.url = "http://[2001:db8::1]:8443", .token = token})), HasSubstr("unencrypted"));
  EXPECT_THAT(refusalOf(httpLink({.url = "ftp://example.org", .token = token})), HasSubstr("begins with https://"));
  EXPECT_THAT(refusalOf(httpLink({.url = "https://", .token = token})), HasSubstr("no address"));
  EXPECT_THAT(refusalOf(httpLink({.url = "https://example.org", .token = "abc\r\nX: y"})), HasSubstr("The token has"));
}

TEST_F(HttpLinkTest, AServerMayHaveAnAddressOfVersion6) {
  const auto started = web::WebServer::start(school->store, {.address = "::1", .port = 0});
  if (!started) GTEST_SKIP() << "This computer has no IPv6: " << started.error().message;
  EXPECT_THAT(started->url(), ::testing::StartsWith("http://[::1]:"));
  EXPECT_TRUE(siteAt(started->url()).exchange());
}

TEST_F(HttpLinkTest, ACertificateMustBeTrusted) {
  if (!makeCertificate()) GTEST_SKIP() << "openssl is not installed";
  const std::string url = serve({.certificate = rig.folder / "certificate.pem", .key = rig.folder / "key.pem"});
  ASSERT_THAT(url, ::testing::StartsWith("https://"));
  EXPECT_THAT(refusalOf(siteAt(url).exchange()), HasSubstr("does not trust"));
  EXPECT_TRUE(siteAt(url, rig.folder / "certificate.pem").exchange());
  EXPECT_THAT(refusalOf(siteAt(url, rig.folder / "none.pem").exchange()), HasSubstr("cannot be read"));
}

TEST_F(HttpLinkTest, RequestsWithoutATokenAreRefused) {
  const std::string url = serve();
  const int port = std::stoi(url.substr(url.rfind(':') + 1));
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET, address.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  ASSERT_EQ(::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  const std::string request =
      "POST /api/site/directory HTTP/1.1\r\nHost: x\r\nConnection: close\r\nContent-Length: 2\r\n\r\n{}";
  ASSERT_EQ(::send(socket, request.data(), request.size(), 0), static_cast<ssize_t>(request.size()));
  char answer[16] = {};
  (void)!::recv(socket, answer, sizeof answer - 1, 0);
  ::close(socket);
  EXPECT_STREQ(answer, "HTTP/1.1 401 Un");
}

}  // namespace
}  // namespace insonate::test
