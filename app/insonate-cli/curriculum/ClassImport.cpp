#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/ClassImport.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

struct ImportArguments {
  std::string className, list, passwords;
};

Result<std::string> textOf(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return fail(file.string() + " is a folder; name the class list in it.");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail("The class list " + file.string() + " cannot be read; check its name and permissions.");
  return text;
}

/// Prints the reason for each refused line, and returns the outcome of each line.
Json outcomeOf(const std::vector<ClassImportRow>& plan) {
  using enum ClassImportRow::Step;
  Json object{{"added", Json::array()},
              {"joined", Json::array()},
              {"already_there", Json::array()},
              {"troubles", Json::array()}};
  for (const ClassImportRow& row : plan) {
    if (row.step == Add) object["added"].push_back(row.person.name);
    if (row.step == Join) object["joined"].push_back(row.person.name);
    if (row.step == AlreadyThere)
      object["already_there"].push_back(
          {{"line", row.line}, {"name", row.person.name}, {"full_name", row.person.fullName}});
    if (row.step != Refuse) continue;
    object["troubles"].push_back({{"line", row.line}, {"text", row.why}});
    std::cerr << row.why << '\n';
  }
  return object;
}

Answer toldOf(const Json& object, const std::string& passwords) {
  std::string text = std::to_string(object["added"].size()) + " added, " + std::to_string(object["joined"].size()) +
                     " joined, " + std::to_string(object["already_there"].size()) + " there already, " +
                     std::to_string(object["troubles"].size()) + " with errors.";
  for (const Json& person : object["already_there"])
    text +=
        "\nLine " + person["line"].dump() + ": " + person["full_name"].get<std::string>() + " is already in the class.";
  if (!object["added"].empty()) text += "\nFirst passwords; hand them out, then delete this file: " + passwords;
  return {.object = object, .text = text, .failure = {}, .status = object["troubles"].empty() ? 0 : kDoneInPart};
}

/// The passwords are written before anyone is added, so that nobody is there whose password nobody knows.
Result<void> carryOut(const SignedIn& by, const Cohort& cohort, const std::vector<ClassImportRow>& plan,
                      const std::string& file) {
  const auto passwords = ClassImport::passwordsFor(plan);
  if (!passwords.empty()) {
    if (file.empty())
      return fail("The list has new people, who need first passwords. Name a file for the passwords with --passwords.");
    if (auto written = writeFirstPasswords(file, passwords); !written) return written;
  }
  auto done = ClassImport(by).apply(cohort.id, plan, passwords, terminalProgress());
  std::error_code error;
  if (!done && !passwords.empty()) fs::remove(file, error);
  return done;
}

Result<Answer> importList(const SignedIn& by, const ImportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto text = textOf(a.list);
  if (!text) return tl::unexpected(text.error());
  const auto list = parseClassList(*text);
  if (!list) return fail(a.list + ": " + list.error().message);
  const auto plan = ClassImport(by).plan(cohort->id, *list);
  if (!plan) return tl::unexpected(plan.error());
  if (plan->empty()) return fail(a.list + " contains no people; below the first line, each line is one person.");
  if (std::ranges::all_of(*plan, [](const ClassImportRow& row) { return row.step == ClassImportRow::Step::Refuse; }))
    return Answer{.object = outcomeOf(*plan),
                  .text = {},
                  .failure = "No person was imported: every line of " + a.list +
                             " has an error. Correct the list and import it again."};
  if (auto done = carryOut(by, *cohort, *plan, a.passwords); !done) return tl::unexpected(done.error());
  return toldOf(outcomeOf(*plan), a.passwords);
}

}  // namespace

void addClassImport(CLI::App& classes, Outcome& outcome) {
  auto a = std::make_shared<ImportArguments>();
  CLI::App* command =
      addSignedInCommand(classes, outcome, "import",
                         "Import the people of a class list (CSV, as Moodle exports it). The exit status is 3 if some "
                         "lines were left out because of errors",
                         [a](const SignedIn& by) { return importList(by, *a); });
  command->add_option("CLASS", a->className, "Class that the person joins")->required();
  command->add_option("LIST", a->list, "CSV with names, e-mail addresses, user names")->required()->check(notEmpty());
  command->add_option("--passwords", a->passwords, "New file for the first passwords of added people");
}

}  // namespace insonate::cli
