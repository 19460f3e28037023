#include "Answer.h"

#include <QtCore/QDateTime>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

std::string cellOf(const Json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end() || found->is_null()) return "n/a";
  if (found->is_boolean()) return found->get<bool>() ? "yes" : "no";
  if (found->is_number_float()) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", found->get<double>());
    return text;
  }
  std::string text = found->is_string() ? found->get<std::string>() : found->dump();
  std::ranges::replace_if(
      text, [](unsigned char letter) { return letter < 0x20 || letter == 0x7f; }, ' ');
  return text;
}

/// In letters, of UTF-8.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char letter) { return (letter & 0xc0) != 0x80; }));
}

void print(Outcome& outcome, const Result<Answer>& answer) {
  if (!answer) return refuse(outcome, answer.error());
  const bool hasFailed = !answer->failure.empty();
  outcome.status = answer->status;
  if (outcome.json && !hasFailed) return printJson(answer->object);
  if (!outcome.json) std::cout << answer->text << (answer->text.ends_with('\n') || answer->text.empty() ? "" : "\n");
  if (hasFailed) refuse(outcome, Error{answer->failure}, answer->object);
}

}  // namespace

CLI::App* addAnsweringCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                              std::function<Result<Answer>()> work) {
  CLI::App* command = group.add_subcommand(name, about);
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print one JSON object");
  command->callback([json, &outcome, work = std::move(work)] {
    outcome.json = *json;
    print(outcome, work());
  });
  return command;
}

CLI::App* addStoreCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                          SigningIn signingIn, std::function<Result<Answer>(const StoreOptions&)> work) {
  auto options = std::make_shared<StoreOptions>();
  CLI::App* command =
      addAnsweringCommand(group, outcome, name, about, [options, work = std::move(work)] { return work(*options); });
  if (signingIn == SigningIn::Yes) addSignInOptions(*command, *options);
  addDatabaseOption(*command, *options);
  return command;
}

CLI::App* addSignedInCommand(CLI::App& group, Outcome& outcome, const std::string& name, const std::string& about,
                             std::function<Result<Answer>(const SignedIn&)> work) {
  return addStoreCommand(group, outcome, name, about, SigningIn::Yes,
                         [work = std::move(work)](const StoreOptions& options) -> Result<Answer> {
                           const auto by = signIn(options);
                           return by ? work(*by) : tl::unexpected(by.error());
                         });
}

std::string tableOf(const Json& rows, const std::vector<Column>& columns) {
  std::vector<std::vector<std::string>> lines(1);
  std::vector<std::size_t> widths;
  for (const Column& column : columns) lines[0].emplace_back(column.title);
  for (const Json& row : rows) {
    lines.emplace_back();
    for (const Column& column : columns) lines.back().push_back(cellOf(row, column.key));
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    widths.push_back(0);
    for (const auto& line : lines) widths[i] = std::max(widths[i], widthOf(line[i]));
  }
  std::string text;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < columns.size(); ++i)
      text += line[i] + (i + 1 < columns.size() ? std::string(widths[i] - widthOf(line[i]) + 2, ' ') : "\n");
  return text;
}

std::string timeText(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000, Qt::UTC).toString(Qt::ISODateWithMs).toStdString();
}

}  // namespace insonate::cli
