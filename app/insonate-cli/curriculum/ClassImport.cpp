#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/ClassList.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/FirstPassword.h>
#include <insonate/curriculum/PeopleStore.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

struct ImportArguments {
  std::string className, list, passwords;
};

Result<std::string> textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return fail("The class list " + file.string() + " cannot be read; check its name and permissions.");
  return text;
}

/// Before anyone is added, so that nobody is there whose password nobody knows.
Result<std::vector<std::string>> writePasswords(const fs::path& file, const std::vector<ClassListEntry>& added) {
  if (file.empty()) return fail("New people need first passwords: name a file for them with --passwords.");
  std::error_code error;
  if (fs::exists(file, error))
    return fail(file.string() + " is there already and may hold passwords of an earlier import; name another file.");
  std::vector<std::string> passwords;
  std::vector<std::vector<std::string>> rows{{"name", "full name", "e-mail", "first password"}};
  for (const ClassListEntry& entry : added) {
    passwords.push_back(firstPassword());
    rows.push_back({entry.person.name, entry.person.fullName, entry.person.email, passwords.back()});
  }
  const auto written = writeAtomically(file, [&](const fs::path& beside) -> Result<void> {
    std::ofstream stream(beside, std::ios::binary);
    fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write);
    if (!(stream << csvText(rows) << std::flush)) return fail("Could not write " + beside.string() + ".");
    return {};
  });
  if (!written) return tl::unexpected(written.error());
  return passwords;
}

/// What of a list has come about.
struct Imported {
  std::vector<std::string> added, joined;
  std::vector<ClassListTrouble> troubles;
  int already = 0;
};

Result<void> addAll(const SignedIn& by, const Cohort& cohort, const std::vector<ClassListEntry>& entries,
                    const std::vector<std::string>& passwords, Imported& done) {
  const Progress progress = terminalProgress();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!report(progress, "Adding people", static_cast<double>(i) / static_cast<double>(entries.size())))
      return fail("Cancelled after " + std::to_string(i) + " of " + std::to_string(entries.size()) +
                  " people; import the list again for the others.");
    const auto person = PeopleStore(by).add(entries[i].person, passwords[i], cohort.id);
    if (person)
      done.added.push_back(person->name);
    else
      done.troubles.push_back({entries[i].line, person.error().message});
  }
  report(progress, "Adding people", 1);
  return {};
}

Result<void> joinAll(const SignedIn& by, const Cohort& cohort, const std::vector<ClassListMatch::Known>& known,
                     Imported& done) {
  const auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  std::set<std::string> there;
  for (const Member& member : *members) there.insert(member.person.id);
  for (const ClassListMatch::Known& one : known) {
    if (there.contains(one.person.id))
      ++done.already;
    else if (auto joined = CohortStore(by).join(cohort.id, one.person.id, false); joined)
      done.joined.push_back(one.person.name);
    else
      done.troubles.push_back({one.entry.line, joined.error().message});
  }
  return {};
}

Answer toldOf(const Imported& done, const ImportArguments& a) {
  Json troubles = Json::array();
  for (const ClassListTrouble& trouble : done.troubles) {
    troubles.push_back({{"line", trouble.line}, {"text", trouble.sentence}});
    std::cerr << "line " << trouble.line << ": " << trouble.sentence << '\n';
  }
  std::string text = std::to_string(done.added.size()) + " added, " + std::to_string(done.joined.size()) + " joined, " +
                     std::to_string(done.already) + " there already, " + std::to_string(done.troubles.size()) +
                     " in trouble.";
  if (!done.added.empty()) text += " First passwords, to be handed out and deleted: " + a.passwords;
  return {{{"added", done.added}, {"joined", done.joined}, {"already_there", done.already}, {"troubles", troubles}},
          text};
}

Result<Answer> importList(const SignedIn& by, const ImportArguments& a) {
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto text = textOf(a.list);
  if (!text) return tl::unexpected(text.error());
  const auto list = parseClassList(*text);
  if (!list) return fail(a.list + ": " + list.error().message);
  const auto people = peopleSeen(by);
  if (!people) return tl::unexpected(people.error());
  const ClassListMatch match = matchClassList(*list, *people);
  Imported done{.added = {}, .joined = {}, .troubles = match.troubles, .already = 0};
  if (!match.added.empty()) {
    const auto passwords = writePasswords(a.passwords, match.added);
    if (!passwords) return tl::unexpected(passwords.error());
    if (auto added = addAll(by, *cohort, match.added, *passwords, done); !added) return tl::unexpected(added.error());
  }
  if (auto joined = joinAll(by, *cohort, match.known, done); !joined) return tl::unexpected(joined.error());
  return toldOf(done, a);
}

}  // namespace

void addClassImport(CLI::App& classes, Outcome& outcome) {
  auto a = std::make_shared<ImportArguments>();
  CLI::App* command = addSignedInCommand(classes, outcome, "import", "People of a class list (CSV, as Moodle has it)",
                                         [a](const SignedIn& by) { return importList(by, *a); });
  command->add_option("CLASS", a->className, "Class that they learn in")->required();
  command->add_option("LIST", a->list, "CSV with names, e-mail addresses, user names")->required()->check(notEmpty());
  command->add_option("--passwords", a->passwords, "New file for the first passwords of who is added");
}

}  // namespace insonate::cli
