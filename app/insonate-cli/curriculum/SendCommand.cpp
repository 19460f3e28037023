#include "Answer.h"
#include "Groups.h"
#include "LearningRecords.h"
#include "Password.h"

#include <nlohmann/json.hpp>

#include <QCoreApplication>
#include <algorithm>
#include <fstream>
#include <memory>

namespace insonate::cli {
namespace {

struct SendArguments {
  std::string file, passwordFile;
  LearningRecords records;
};

Result<std::vector<std::string>> statementsIn(const std::string& file) {
  std::ifstream stream(file);
  if (!stream)
    return fail("There is no file " + file + ", or it cannot be read; write it by 'curriculum export xapi'.");
  const Json list = Json::parse(stream, nullptr, false);
  const auto isStatement = [](const Json& one) {
    return one.is_object() && one.contains("id") && one.contains("verb");
  };
  if (!list.is_array() || !std::ranges::all_of(list, isStatement))
    return fail(file + " is not a list of xAPI statements. Write one with 'curriculum export xapi'.");
  std::vector<std::string> statements;
  for (const Json& one : list) statements.push_back(one.dump());
  return statements;
}

Result<Answer> send(const SendArguments& a) {
  const auto statements = statementsIn(a.file);
  if (!statements) return tl::unexpected(statements.error());
  const auto password = readPassword({.file = a.passwordFile,
                                      .variable = "INSONATE_LRS_PASSWORD",
                                      .prompt = "Password of " + a.records.user + " at " + a.records.endpoint});
  if (!password) return tl::unexpected(password.error());
  LearningRecords records = a.records;
  records.password = *password;
  // Qt's network asks for one.
  int count = 1;
  char name[] = "insonate-cli";
  char* arguments[] = {name, nullptr};
  const QCoreApplication application(count, arguments);
  if (auto sent = sendStatements(records, *statements, terminalProgress()); !sent) return tl::unexpected(sent.error());
  return Answer{{{"endpoint", records.endpoint}, {"statements", statements->size()}},
                records.endpoint + " has all " + std::to_string(statements->size()) + " statements."};
}

}  // namespace

void addSendCommand(CLI::App& curriculum, Outcome& outcome) {
  auto a = std::make_shared<SendArguments>();
  CLI::App* command = addAnsweringCommand(curriculum, outcome, "send",
                                          "Send xAPI statements to a learning record store", [a] { return send(*a); });
  command->add_option("FILE", a->file, "Statements, as 'curriculum export xapi' writes them")
      ->required()
      ->check(notEmpty());
  command->add_option("--to", a->records.endpoint, "Address of the learning record store: https://lrs.example.org/xapi")
      ->required();
  command->add_option("--user", a->records.user, "User name at the learning record store")->required();
  command->add_option("--password-file", a->passwordFile,
                      "File with the password in its first line; by default the environment variable "
                      "INSONATE_LRS_PASSWORD, or else the command asks for it");
}

}  // namespace insonate::cli
