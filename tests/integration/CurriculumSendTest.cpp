#include "integration/CommandLine.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QCoreApplication>
#include <QTcpServer>
#include <QTcpSocket>
#include <atomic>
#include <fstream>
#include <memory>
#include <set>
#include <thread>

namespace insonate::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A learning record store on loopback, which keeps each statement once; on a thread of its own.
class Records {
 public:
  Records() : thread_([this] { serve(); }) {
    while (port == 0) std::this_thread::yield();
  }
  ~Records() {
    stop_ = true;
    thread_.join();
  }

  std::atomic<int> port = 0, status = 200, requests = 0;
  std::atomic<int> refusesAfter = 1000;  ///< requests
  std::set<std::string> kept;
  std::string head;  ///< of the last request

 private:
  void serve() {
    QTcpServer server;
    if (!server.listen(QHostAddress::LocalHost)) return;
    port = server.serverPort();
    while (!stop_) {
      if (!server.waitForNewConnection(50)) continue;
      const std::unique_ptr<QTcpSocket> socket(server.nextPendingConnection());
      while (!stop_ && answerOn(*socket)) {
      }
    }
  }

  bool answerOn(QTcpSocket& socket) {
    QByteArray got;
    while (!isWhole(got)) {
      if (!socket.waitForReadyRead(200) && (stop_ || socket.state() != QTcpSocket::ConnectedState)) return false;
      got += socket.readAll();
    }
    const int end = got.indexOf("\r\n\r\n");
    head = got.left(end).toStdString();
    const int answer = ++requests > refusesAfter ? 503 : status.load();
    const json list = json::parse(got.mid(end + 4).toStdString(), nullptr, false);
    if (answer == 200)
      for (const json& one : list) kept.insert(one["id"]);
    socket.write("HTTP/1.1 " + QByteArray::number(answer) + " x\r\nContent-Length: 2\r\n\r\n[]");
    return socket.waitForBytesWritten(1000);
  }
  static bool isWhole(const QByteArray& got) {
    const int end = got.indexOf("\r\n\r\n"), length = got.toLower().indexOf("content-length:");
    return end > 0 && length > 0 &&
           got.size() >= end + 4 + got.mid(length + 15, got.indexOf('\r', length) - length - 15).trimmed().toInt();
  }

  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

class CurriculumSend : public testing::Test {
 protected:
  void write(int count) const {
    json list = json::array();
    for (int n = 0; n < count; ++n)
      list.push_back({{"id", "id-" + std::to_string(n)}, {"verb", {{"id", "passed"}}}, {"actor", "Zoë \"Z\""}});
    std::ofstream(folder / "x.json") << list;
  }
  CommandResult send(const std::string& to) const {
    return runCommand("curriculum send " + shellWord(folder / "x.json") + " --json --user school --to " + to,
                      folder / "errors.txt", "env INSONATE_LRS_PASSWORD='open sesame' ");
  }
  std::string address() const { return "http://127.0.0.1:" + std::to_string(records.port) + "/xapi/"; }

  const TemporaryFolder folder;
  Records records;
};

TEST_F(CurriculumSend, EachStatementArrivesOnceHoweverOftenItIsSent) {
  write(120);
  for (int time = 0; time < 2; ++time) {
    const CommandResult result = send(address());
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(json::parse(result.output)["statements"], 120);
  }
  EXPECT_EQ(records.kept.size(), 120U);
  EXPECT_EQ(records.requests, 6) << "fifty at once";
  EXPECT_THAT(records.head, HasSubstr("POST /xapi/statements HTTP"));
  EXPECT_THAT(records.head, HasSubstr("X-Experience-API-Version: 1.0.3"));
  EXPECT_THAT(records.head, HasSubstr("Authorization: Basic c2Nob29sOm9wZW4gc2VzYW1l"));
}

TEST_F(CurriculumSend, SaysWhatTheStoreSaid) {
  write(120);
  records.status = 401;
  EXPECT_THAT(send(address()).errors, HasSubstr("does not accept this name and password"));
  records.status = 409;
  EXPECT_THAT(send(address()).errors, HasSubstr("other statements with the same ids"));
  records.status = 302;
  EXPECT_THAT(send(address()).errors, HasSubstr("HTTP 302")) << "a password is not handed on";
  records.status = 200;
  records.refusesAfter = records.requests + 1;
  const CommandResult half = send(address());
  EXPECT_EQ(half.status, 1);
  EXPECT_THAT(half.errors, HasSubstr("50 statements were sent before"));
}

TEST_F(CurriculumSend, PasswordsGoNowhereUnsafe) {
  write(1);
  for (const char* to :
       {"http://lrs.example.org/xapi", "https://me:secret@lrs.example.org", "ftp://localhost/x", "lrs", "''"}) {
    const CommandResult result = send(to);
    EXPECT_EQ(result.status, 1) << to;
    EXPECT_THAT(result.errors, HasSubstr("begins with https://")) << to;
  }
  EXPECT_THAT(send("http://127.0.0.1:1/xapi").errors, HasSubstr("cannot be reached"));
  EXPECT_EQ(records.requests, 0);
}

TEST_F(CurriculumSend, OnlyStatementsAreSent) {
  for (const char* text : {"", "{}", "[1]", "[{\"id\": 1}]"}) {
    std::ofstream(folder / "x.json") << text;
    const CommandResult result = send(address());
    EXPECT_EQ(result.status, 1) << text;
    EXPECT_THAT(result.errors, HasSubstr("not a list of xAPI statements")) << text;
  }
  EXPECT_EQ(records.requests, 0);
}

}  // namespace
}  // namespace insonate::test
