#include "RawClient.h"
#include "http/EventStream.h"
#include "http/HttpServer.h"
#include "http/Ranges.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <thread>

namespace insonate::web {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::unique_ptr<HttpServer> serving(const HttpServer::Answer& answer, const HttpLimits& limits = {},
                                    const HttpServer::Refused& refused = {}, const HttpServer::Admit& admit = {}) {
  auto server = HttpServer::start({.port = 0}, answer, limits, refused, admit);
  if (!server) throw std::runtime_error(server.error().message);
  return std::move(*server);
}

Response echo(const Request& request) {
  std::string body = request.method + " " + request.path;
  for (const auto& [name, value] : request.query) body += " ?" + name + "=" + value;
  for (const auto& [name, value] : request.form) body += " " + name + "=" + value;
  for (const auto& [name, value] : request.files) body += " file:" + name + "=" + value;
  for (const auto& [name, value] : request.cookies) body += " cookie:" + name + "=" + value;
  return {.type = "text/plain", .body = body + " from " + request.client};
}

const std::string kClose = "Host: localhost\r\nConnection: close\r\n";

TEST(WebHttpServer, PassesTheRequestOn) {
  const auto server = serving(&echo);
  const std::string got =
      RawClient(server->port())
          .ask("GET /classes/a%20b?x=1%262&y=%C3%A4 HTTP/1.1\r\n" + kClose + "Cookie: insonate=abc; z=1\r\n\r\n");
  EXPECT_THAT(got, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(got, HasSubstr("GET /classes/a b ?x=1&2 ?y=\xC3\xA4 cookie:insonate=abc cookie:z=1 from 127.0.0.1"));
  const std::string form = "name=Ada+L&password=%3Cx%3E";
  EXPECT_THAT(RawClient(server->port())
                  .ask("POST /sign-in HTTP/1.1\r\n" + kClose + "Content-Type: application/x-www-form-urlencoded\r\n" +
                       "Content-Length: " + std::to_string(form.size()) + "\r\n\r\n" + form),
              HasSubstr("POST /sign-in name=Ada L password=<x>"));
  const std::string head = RawClient(server->port()).ask("HEAD / HTTP/1.1\r\n" + kClose + "\r\n");
  EXPECT_THAT(head, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(head, testing::EndsWith("\r\n\r\n")) << "without a body";
}

TEST(WebHttpServer, ASlowIdentityProviderStopsNoPage) {
  std::atomic<bool> isReleased = false;
  const auto server = serving([&](const Request& request) {
    while (!isReleased && request.path.starts_with("/sign-in/openid"))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return echo(request);
  });
  std::vector<std::unique_ptr<RawClient>> clients;
  for (const std::string path : {"/sign-in/openid", "/sign-in/openid/return"})
    for (int i = 0; i < 6; ++i) {
      clients.push_back(std::make_unique<RawClient>(server->port()));
      clients.back()->send("GET " + path + " HTTP/1.1\r\n" + kClose + "\r\n");
    }
  EXPECT_THAT(RawClient(server->port()).ask("GET /sign-in HTTP/1.1\r\n" + kClose + "\r\n"), StartsWith("HTTP/1.1 200"));
  isReleased = true;
  for (const auto& client : clients) EXPECT_THAT(client->receive(), StartsWith("HTTP/1.1 200"));
}

/// A request with a form of several parts, as browsers send a file.
std::string multipart(const std::string& path, const std::string& type, const std::string& body,
                      const std::string& headers = {}) {
  return "POST " + path + " HTTP/1.1\r\n" + kClose + headers + "Content-Type: " + type +
         "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

const std::string kParts = "multipart/form-data; boundary=xyz";

std::string part(const std::string& disposition, const std::string& content) {
  return "--xyz\r\nContent-Disposition: form-data; " + disposition + "\r\n\r\n" + content + "\r\n";
}

TEST(WebHttpServer, ReadsFormsOfSeveralParts) {
  const auto server = serving(&echo);
  const auto ask = [&](const std::string& body) { return RawClient(server->port()).ask(multipart("/", kParts, body)); };
  const std::string latin1 = "Name\r\nJ\xE4ger --xy\r\n--xy\r\n";
  EXPECT_THAT(ask(part("name=\"code\"", "abc") + part("name=\"list\"; filename=\"a.csv\"", latin1) +
                  part("name=\"text\"", "") + "--xyz--\r\n"),
              HasSubstr("POST / code=abc text= file:list=" + latin1 + " from"))
      << "byte by byte";
  EXPECT_THAT(ask(part("name=\"a\"", "1") + part("name=\"a\"", "2") + "--xyz--\r\n"), HasSubstr("POST / a=1 from"))
      << "the first counts";
  EXPECT_THAT(ask(part("name=\"a\"", std::string("x\0y\xFFz\x1B", 6)) + "--xyz--\r\n"), HasSubstr("POST / a=xyz from"));
  EXPECT_THAT(ask(part("name=\"list\"; filename=\"\"", "") + "--xyz--\r\n"), HasSubstr("=")) << "no file was chosen";
}

TEST(WebHttpServer, RefusesPartsThatAreNoForm) {
  std::atomic<int> answered = 0;
  const auto server = serving([&](const Request& request) {
    ++answered;
    return echo(request);
  });
  for (const std::string& type : {std::string("multipart/form-data"), std::string("multipart/form-data; boundary="),
                                  std::string("multipart/mixed; boundary=xyz")})
    EXPECT_THAT(RawClient(server->port()).ask(multipart("/", type, part("name=\"a\"", "1") + "--xyz--\r\n")),
                StartsWith("HTTP/1.1 400"))
        << type;
  EXPECT_THAT(RawClient(server->port()).ask(multipart("/", kParts, part("name=\"a\"", "1"))),
              StartsWith("HTTP/1.1 400"))
      << "cut off";
  EXPECT_EQ(answered, 0);
}

TEST(WebHttpServer, ListsOfUsersMayBeLargerThanOtherForms) {
  const auto server = serving(&echo, {}, {}, [](const Request&) { return std::optional<Response>(); });
  const auto ask = [&](const std::string& path, std::size_t bytes, const std::string& cookie) {
    const std::string body = part("name=\"list\"; filename=\"a\"", std::string(bytes, 'a')) + "--xyz--\r\n";
    return RawClient(server->port()).ask(multipart(path, kParts, body, cookie)).substr(0, 12);
  };
  const std::string cookie = "Cookie: insonate=abc\r\n";
  const std::size_t large = HttpServer::kLargestBody_bytes;
  EXPECT_EQ(ask("/classes/5/import", large, cookie), "HTTP/1.1 200");
  EXPECT_EQ(ask("/classes/5/import", large, ""), "HTTP/1.1 413") << "nobody is signed in";
  EXPECT_EQ(ask("/classes/5/name", large, cookie), "HTTP/1.1 413");
  EXPECT_EQ(ask("/classes/5/import", HttpServer::kLargestBodyOfList_bytes, cookie), "HTTP/1.1 413");
}

TEST(WebHttpServer, ALargeBodyOfAnUnknownSenderIsNotKept) {
  std::atomic<int> asked = 0, answered = 0;
  const auto server = serving(
      [&](const Request& request) {
        ++answered;
        return Response{.body = std::to_string(request.body.size()) + " bytes"};
      },
      {}, {},
      [&](const Request& request) -> std::optional<Response> {
        ++asked;
        EXPECT_TRUE(request.body.empty());
        if (request.headers.at("authorization") == "Bearer known") return std::nullopt;
        return Response{.status = 401, .body = "unknown"};
      });
  const auto ask = [&](const std::string& token, const std::string& lengthAndBody) {
    return RawClient(server->port())
        .ask("POST /api/site/facts HTTP/1.1\r\n" + kClose + "Authorization: Bearer " + token + "\r\n" + lengthAndBody);
  };
  const auto sized = [](std::size_t bytes) {
    return "Content-Length: " + std::to_string(bytes) + "\r\n\r\n" + std::string(bytes, 'a');
  };
  std::string chunked = "Transfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 20; ++i) chunked += "1000\r\n" + std::string(4096, 'a') + "\r\n";
  chunked += "0\r\n\r\n";
  const std::size_t large = HttpServer::kLargestBodyOfWorkstation_bytes;
  EXPECT_THAT(ask("forged", sized(HttpServer::kLargestBody_bytes)), HasSubstr("65536 bytes")) << "the page refuses it";
  EXPECT_EQ(asked, 0) << "as small as a form";
  EXPECT_THAT(ask("known", sized(large)), HasSubstr(std::to_string(large) + " bytes"));
  EXPECT_THAT(ask("known", chunked), HasSubstr("81920 bytes"));
  EXPECT_EQ(answered, 3);
  EXPECT_THAT(ask("forged", sized(large)), StartsWith("HTTP/1.1 401"));
  EXPECT_THAT(ask("forged", chunked), StartsWith("HTTP/1.1 401"));
  EXPECT_EQ(answered, 3);
  EXPECT_EQ(asked, 4);
  EXPECT_THAT(ask("known", sized(large + 1)), StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(RawClient(server->port()).ask("POST /api/site/facts HTTP/1.1\r\n" + kClose + sized(large)),
              StartsWith("HTTP/1.1 413"))
      << "without a token";
}

/// Each of them announces the body of a workstation, and only the bodies of known senders count.
TEST(WebHttpServer, ClientsWithoutATokenDoNotFillTheMemory) {
  const auto server =
      serving([](const Request&) { return Response{.body = "taken"}; }, {.connectionsOfOneAddress = 1000}, {},
              [](const Request& request) {
                return request.headers.at("authorization") == "Bearer known" ? std::nullopt
                                                                             : std::optional(Response{.status = 401});
              });
  const std::size_t large = HttpServer::kLargestBodyOfWorkstation_bytes;
  const auto request = [&](const std::string& token) {
    return "POST /api/site/facts HTTP/1.1\r\n" + kClose + "Authorization: Bearer " + token +
           "\r\nContent-Length: " + std::to_string(large) + "\r\n\r\n" + std::string(large - 1, 'a');
  };
  // The bodies of workstations may have 192 MB together.
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 60; ++i) {
    clients.push_back(std::make_unique<RawClient>(server->port()));
    clients.back()->send(request("forged"));
  }
  EXPECT_THAT(RawClient(server->port()).ask(request("known") + "a"), HasSubstr("taken"));
}

TEST(WebHttpServer, SendsAPartOfAFile) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "video") << std::string(100'000, 'a') << "here" << std::string(100'000, 'b');
  const auto server =
      serving([&](const Request& request) { return sendFile(request, folder / "video", "video/webm"); });
  const auto ask = [&](const std::string& header) {
    return RawClient(server->port()).ask("GET / HTTP/1.1\r\n" + kClose + header + "\r\n");
  };
  const std::string part = ask("Range: bytes=100000-100003\r\n");
  EXPECT_THAT(part, StartsWith("HTTP/1.1 206"));
  EXPECT_THAT(part, HasSubstr("Content-Range: bytes 100000-100003/200004\r\n"));
  EXPECT_THAT(part, testing::EndsWith("\r\n\r\nhere"));
  const std::string whole = ask("");
  EXPECT_THAT(whole, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(whole, HasSubstr("Accept-Ranges: bytes\r\n"));
  EXPECT_EQ(whole.size() - whole.find("\r\n\r\n") - 4, 200'004U);
  EXPECT_THAT(ask("Range: bytes=200004-\r\n"), StartsWith("HTTP/1.1 416"));
  const std::size_t tag = part.find("ETag: ") + 6;
  const std::string same = part.substr(tag, part.find('\r', tag) - tag);
  EXPECT_THAT(ask("Range: bytes=0-3\r\nIf-Range: " + same + "\r\n"), StartsWith("HTTP/1.1 206"));
  EXPECT_THAT(ask("Range: bytes=0-3\r\nIf-Range: \"other\"\r\n"), StartsWith("HTTP/1.1 200")) << "another file";
}

TEST(WebHttpServer, ReadsRanges) {
  const auto words = [](std::string_view header) {
    const auto range = rangeOf(header, 1000);
    return range ? std::to_string(range->begin) + "+" + std::to_string(range->size) : "outside";
  };
  EXPECT_EQ(words(""), "0+1000");
  EXPECT_EQ(words("bytes=0-"), "0+1000");
  EXPECT_EQ(words("bytes=200-299"), "200+100");
  EXPECT_EQ(words("bytes=900-5000"), "900+100");
  EXPECT_EQ(words("bytes=-1"), "999+1");
  EXPECT_EQ(words("bytes=-5000"), "0+1000");
  EXPECT_EQ(words("bytes=999-"), "999+1");
  for (const std::string_view outside : {"bytes=1000-", "bytes=5000-6000", "bytes=-0"})
    EXPECT_EQ(words(outside), "outside") << outside;
  for (const std::string_view ignored : {"bytes=1-2,5-6", "lines=1-2", "bytes=9-3", "bytes=x-", "bytes=1-x",
                                         "bytes=", "bytes=-", "bytes=99999999999999999999-", "bytes=0x1-2"})
    EXPECT_EQ(words(ignored), "0+1000") << ignored;
}

TEST(WebHttpServer, RefusesWhatIsTooLargeOrNoRequest) {
  std::atomic<int> answered = 0, tooLarge = 0;
  const auto server = serving(
      [&](const Request& request) {
        ++answered;
        return echo(request);
      },
      {}, [&](int status) { tooLarge += status == 413 ? 1 : 0; });
  const std::string large(HttpServer::kLargestBody_bytes + 1, 'a');
  EXPECT_THAT(
      RawClient(server->port())
          .ask("POST / HTTP/1.1\r\n" + kClose + "Content-Length: " + std::to_string(large.size()) + "\r\n\r\n" + large),
      StartsWith("HTTP/1.1 413"));
  std::string chunked = "POST / HTTP/1.1\r\n" + kClose + "Transfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 20; ++i) chunked += "1000\r\n" + std::string(4096, 'a') + "\r\n";
  EXPECT_THAT(RawClient(server->port()).ask(chunked + "0\r\n\r\n"), StartsWith("HTTP/1.1 413"));
  EXPECT_EQ(answered, 0);
  EXPECT_EQ(tooLarge, 2);
  EXPECT_THAT(
      RawClient(server->port()).ask("GET / HTTP/1.1\r\n" + kClose + "X: " + std::string(40'000, 'a') + "\r\n\r\n"),
      HasSubstr(" 4"));
  RawClient(server->port()).ask(std::string("\x16\x03\x01\0\xff garbage\r\n\r\n", 18));
  EXPECT_THAT(RawClient(server->port()).ask("GET /still HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /still"));
}

TEST(WebHttpServer, AddressesAreDecodedOnce) {
  const auto server = serving(&echo);
  EXPECT_THAT(RawClient(server->port()).ask("GET /%2561udit?x=%2541+b HTTP/1.1\r\n" + kClose + "\r\n"),
              HasSubstr("GET /%61udit ?x=%41 b"));
}

TEST(WebHttpServer, RefusesALengthThatCanBeReadInTwoWays) {
  const auto server = serving(&echo);
  for (const std::string headers :
       {"Content-Length: 5\r\nContent-Length: 17\r\n", "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n",
        "Transfer-Encoding: chunked\r\nTransfer-Encoding: identity\r\n"})
    EXPECT_THAT(RawClient(server->port()).ask("POST / HTTP/1.1\r\n" + kClose + headers + "\r\n0\r\n\r\n"),
                HasSubstr(" 400 "))
        << headers;
}

TEST(WebHttpServer, EventsArriveOneByOneWhileTheConnectionStaysOpen) {
  const auto stream = std::make_shared<EventStream>();
  // The time for taking an answer does not end a stream.
  const auto server = serving([&](const Request&) { return Response{.type = "text/event-stream", .events = stream}; },
                              {.answer = std::chrono::milliseconds(200)});
  RawClient client(server->port());
  client.send("GET /events HTTP/1.1\r\n" + kClose + "\r\n");
  EXPECT_THAT(client.receiveUntil("retry: 5000\n\n"), HasSubstr("text/event-stream"));
  for (int i = 1; i <= 3; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    stream->push("changed", i);
    EXPECT_THAT(client.receiveUntil("data:\n\n"), HasSubstr("id: " + std::to_string(i) + "\nevent: changed\n"));
  }
  stream->keepAlive();
  EXPECT_THAT(client.receiveUntil(":\n\n"), HasSubstr(":\n\n"));
  EXPECT_FALSE(stream->isOver());
  stream->end();
  client.receive();
  EXPECT_TRUE(client.isEnded());
}

TEST(WebHttpServer, AStreamWhoseBrowserWentAwayIsOver) {
  const auto stream = std::make_shared<EventStream>();
  const auto server = serving([&](const Request&) { return Response{.type = "text/event-stream", .events = stream}; });
  {
    RawClient client(server->port());
    client.send("GET /events HTTP/1.1\r\n" + kClose + "\r\n");
    client.receiveUntil("retry");
  }
  for (int i = 0; i < 500 && !stream->isOver(); ++i) {
    stream->keepAlive();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(stream->isOver());
}

TEST(WebHttpServer, PasswordChecksHoldNoOtherRequestUp) {
  std::atomic<bool> done = false;
  const auto server = serving([&](const Request& request) {
    for (int i = 0; request.path == "/sign-in" && !done && i < 1000; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return echo(request);
  });
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 10; ++i) {
    clients.push_back(std::make_unique<RawClient>(server->port()));
    clients.back()->send("POST /sign-in HTTP/1.1\r\n" + kClose + "Content-Length: 0\r\n\r\n");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_THAT(RawClient(server->port()).ask("GET /health HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /health"));
  EXPECT_FALSE(done) << "before the first of them ended";
  done = true;
  for (const auto& client : clients) EXPECT_THAT(client->receive(), HasSubstr("POST /sign-in"));
}

TEST(WebHttpServer, DownloadsOfDataHoldNoOtherRequestUpAndTheirFilesAreReleased) {
  const insonate::test::TemporaryFolder folder;
  std::ofstream(folder / "data.zip") << "the data";
  std::atomic<bool> done = false;
  std::atomic<int> owners = 0;
  const auto server = serving([&](const Request& request) {
    if (request.method != "POST") return echo(request);
    for (int i = 0; !done && i < 1000; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ++owners;
    const std::shared_ptr<const void> owner(&owners, [&](const void*) { --owners; });
    return Response{.type = "application/zip", .file = folder / "data.zip", .fileSize = 8, .fileOwner = owner};
  });
  std::vector<std::unique_ptr<RawClient>> clients;
  for (const std::string path : {"/me/data", "/people/5/data", "/me/data", "/me/data", "/me/data"}) {
    clients.push_back(std::make_unique<RawClient>(server->port()));
    clients.back()->send("POST " + path + " HTTP/1.1\r\n" + kClose + "Content-Length: 0\r\n\r\n");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_THAT(RawClient(server->port()).ask("GET /me HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /me"));
  EXPECT_FALSE(done) << "before the first of them ended";
  done = true;
  for (const auto& client : clients) EXPECT_THAT(client->receive(), HasSubstr("the data"));
  for (int i = 0; owners > 0 && i < 500; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(owners, 0);
}

TEST(WebHttpServer, SlowClientsHoldNobodyUp) {
  const auto server = serving(&echo);
  std::vector<std::unique_ptr<RawClient>> slow;
  for (int i = 0; i < 100; ++i) {
    slow.push_back(std::make_unique<RawClient>(server->port()));
    ASSERT_TRUE(slow.back()->connected());
    slow.back()->send(i % 2 == 0 ? "GET /slow HT" : "POST /slow HTTP/1.1\r\nHost: x\r\nContent-Length: 10\r\n\r\nabc");
  }
  EXPECT_THAT(RawClient(server->port()).ask("GET /quick HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /quick"));
}

TEST(WebHttpServer, AClientThatSendsOneByteAtATimeIsEnded) {
  using namespace std::chrono_literals;
  const auto server = serving(&echo, {.request = 400ms});
  for (const std::string start : {"GET /", "POST /slow HTTP/1.1\r\nHost: x\r\nContent-Length: 10000\r\n\r\n"}) {
    RawClient slow(server->port());
    slow.send(start);
    std::atomic<bool> isEnded = false;
    std::thread sender([&] {
      while (!isEnded) {
        slow.send("a");
        std::this_thread::sleep_for(50ms);
      }
    });
    (void)slow.receive();
    EXPECT_TRUE(slow.isEnded()) << start;
    isEnded = true;
    sender.join();
  }
  EXPECT_THAT(RawClient(server->port()).ask("GET /quick HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /quick"));
}

TEST(WebHttpServer, AClientThatDoesNotTakeItsAnswerIsEnded) {
  using namespace std::chrono_literals;
  constexpr std::size_t kLarge = 64 << 20;
  const auto server =
      serving([&](const Request&) { return Response{.body = std::string(kLarge, 'a')}; }, {.answer = 300ms});
  RawClient slow(server->port());
  slow.send("GET / HTTP/1.1\r\n" + kClose + "\r\n");
  std::this_thread::sleep_for(1500ms);
  EXPECT_LT(slow.receive().size(), kLarge);
}

TEST(WebHttpServer, TheTimeOfTheServerIsNotThatOfTheClient) {
  using namespace std::chrono_literals;
  const auto server = serving(
      [](const Request& request) {
        std::this_thread::sleep_for(700ms);
        return echo(request);
      },
      {.request = 200ms, .answer = 200ms});
  EXPECT_THAT(RawClient(server->port()).ask("GET /late HTTP/1.1\r\n" + kClose + "\r\n"), HasSubstr("GET /late"));
}

TEST(WebHttpServer, AnAddressHasALimitedNumberOfConnections) {
  const auto server = serving(&echo, {.connectionsOfOneAddress = 3});
  std::vector<std::unique_ptr<RawClient>> held;
  for (int i = 0; i < 3; ++i) {
    held.push_back(std::make_unique<RawClient>(server->port()));
    held.back()->send("GET /held HTTP/1.1\r\nHost: x\r\n");
  }
  EXPECT_EQ(RawClient(server->port()).ask("GET /more HTTP/1.1\r\n" + kClose + "\r\n"), "");
  EXPECT_THAT(held.front()->ask("Connection: close\r\n\r\n"), HasSubstr("GET /held"));
  held.front().reset();
  std::string got;
  for (int tries = 0; got.empty() && tries < 100; ++tries) {
    got = RawClient(server->port()).ask("GET /more HTTP/1.1\r\n" + kClose + "\r\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_THAT(got, HasSubstr("GET /more")) << "after one has ended";
}

/// Tells whether this computer has the address ::1.
bool hasVersion6() {
  return HttpServer::start({.address = "::1", .port = 0}, &echo).has_value();
}

TEST(WebHttpServer, ListensAtAddressesOfVersion6AndAtNames) {
  if (!hasVersion6()) GTEST_SKIP() << "This computer has no IPv6.";
  const auto answerOf = [](const std::string& listen, const std::string& client) {
    const auto server = HttpServer::start({.address = listen, .port = 0}, &echo);
    if (!server) return server.error().message;
    return RawClient((*server)->port(), client).ask("GET / HTTP/1.1\r\n" + kClose + "\r\n");
  };
  EXPECT_THAT(answerOf("::1", "::1"), HasSubstr("from ::1"));
  EXPECT_THAT(answerOf("0:0:0:0:0:0:0:1", "::1"), HasSubstr("from ::1"));
  EXPECT_EQ(answerOf("::1", "127.0.0.1"), "");
  EXPECT_THAT(answerOf("::", "::1"), HasSubstr("from ::1"));
  EXPECT_THAT(answerOf("::", "127.0.0.1"), HasSubstr("from 127.0.0.1")) << "all addresses";
  EXPECT_THAT(answerOf("localhost", "127.0.0.1"), HasSubstr("from 127.0.0.1"));
}

TEST(WebHttpServer, ANetworkOfVersion6HasALimitedNumberOfConnections) {
  if (!hasVersion6()) GTEST_SKIP() << "This computer has no IPv6.";
  auto server = HttpServer::start({.address = "::1", .port = 0}, &echo, {.connectionsOfOneAddress = 3});
  ASSERT_TRUE(server) << server.error().message;
  std::vector<std::unique_ptr<RawClient>> held;
  for (int i = 0; i < 3; ++i) {
    held.push_back(std::make_unique<RawClient>((*server)->port(), "::1"));
    held.back()->send("GET /held HTTP/1.1\r\nHost: x\r\n");
  }
  EXPECT_EQ(RawClient((*server)->port(), "::1").ask("GET /more HTTP/1.1\r\n" + kClose + "\r\n"), "");
}

TEST(WebHttpServer, EachProxyOnTheWayIsNamed) {
  const auto server = serving([](const Request& request) {
    return Response{.body = valueOf(request.headers, "x-forwarded-for") + " " + valueOf(request.headers, "x-other")};
  });
  EXPECT_THAT(RawClient(server->port())
                  .ask("GET / HTTP/1.1\r\n" + kClose +
                       "X-Forwarded-For: 9.9.9.9\r\nX-Other: a\r\nX-Forwarded-For: 1.2.3.4\r\nX-Other: b\r\n\r\n"),
              HasSubstr("9.9.9.9, 1.2.3.4 a"));
}

TEST(WebHttpServer, SlowAnswersHoldUpOnlyTheirWorkers) {
  std::atomic<int> atOnce = 0, most = 0;
  const auto server = serving([&](const Request& request) {
    int now = ++atOnce, seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    --atOnce;
    return echo(request);
  });
  std::atomic<int> right = 0;
  std::vector<std::thread> clients;
  for (int i = 0; i < 24; ++i)
    clients.emplace_back([&, i] {
      const std::string path = "/" + std::to_string(i);
      if (RawClient(server->port()).ask("GET " + path + " HTTP/1.1\r\n" + kClose + "\r\n").find("GET " + path + " ") !=
          std::string::npos)
        ++right;
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(right, 24);
  EXPECT_GT(most, 1) << "requests are answered at the same time";
}

TEST(WebHttpServer, EndsWhileClientsWait) {
  auto server = serving([](const Request& request) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return echo(request);
  });
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 8; ++i) {
    clients.push_back(std::make_unique<RawClient>(server->port()));
    clients.back()->send("GET / HTTP/1.1\r\n" + kClose + "\r\n");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  server.reset();
  for (const auto& client : clients) (void)client->receive();
}

TEST(WebHttpServer, SaysWhyItCannotStart) {
  const auto first = serving(&echo);
  const auto second = HttpServer::start({.port = first->port()}, &echo);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("cannot listen at 127.0.0.1:" + std::to_string(first->port())));
  const auto named = HttpServer::start({.address = "somewhere.invalid"}, &echo);
  ASSERT_FALSE(named);
  EXPECT_THAT(named.error().message, HasSubstr("'somewhere.invalid' is neither an IP address nor a known name"));
  const auto elsewhere = HttpServer::start({.address = "2001:db8::1", .port = 8443}, &echo);
  ASSERT_FALSE(elsewhere);
  EXPECT_THAT(elsewhere.error().message, HasSubstr("cannot listen at [2001:db8::1]:8443"));
  const auto uncertified = HttpServer::start({.port = 0, .certificate = "/nowhere.pem", .key = "/nowhere.pem"}, &echo);
  ASSERT_FALSE(uncertified);
  EXPECT_THAT(uncertified.error().message, HasSubstr("/nowhere.pem"));
  const auto folder = HttpServer::start({.port = 0, .certificate = "/tmp", .key = "/tmp"}, &echo);
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message, HasSubstr("is a folder"));
}

}  // namespace
}  // namespace insonate::web
