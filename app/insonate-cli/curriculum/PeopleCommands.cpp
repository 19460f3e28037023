#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PersonData.h>

#include <map>
#include <memory>

namespace insonate::cli {
namespace {

const std::map<std::string, Role> kRoles{
    {"trainee", Role::Trainee}, {"instructor", Role::Instructor}, {"administrator", Role::Administrator}};

struct NewPersonArguments {
  NewPerson person;
  std::string className;
  NewPasswordOption password;
};

void addPersonOptions(CLI::App& command, NewPersonArguments& a) {
  command.add_option("NAME", a.person.name, "Name for signing in")->required();
  command.add_option("--full-name", a.person.fullName, "Full name")->required();
  command.add_option("--email", a.person.email, "E-mail address");
  a.password.addTo(command);
}

Answer toldOf(const Person& person, const std::string& sentence) {
  return {{{"person", toJson(person)}}, sentence};
}

Result<Answer> setUp(const StoreOptions& options, const NewPersonArguments& a) {
  const auto password = a.password.read("A password for " + a.person.name);
  if (!password) return tl::unexpected(password.error());
  const auto store = openOrMakeStore(options);
  if (!store) return tl::unexpected(store.error());
  const auto by = store->createFirstAdministrator(a.person, *password);
  if (!by) return tl::unexpected(by.error());
  Answer answer = toldOf(by->person(), by->person().name + " is the administrator of " + store->place() +
                                           "; next: insonate-cli curriculum people add, and classes add.");
  answer.object["database"] = store->place();
  return answer;
}

Result<Answer> listPeople(const SignedIn& by) {
  const auto people = PeopleStore(by).all();
  if (!people) return tl::unexpected(people.error());
  Json rows = Json::array();
  for (const Person& person : *people) rows.push_back(toJson(person));
  return Answer{{{"people", rows}},
                tableOf(rows, {{"name", "name"},
                               {"full_name", "full name"},
                               {"email", "e-mail"},
                               {"role", "role"},
                               {"disabled", "disabled"}})};
}

Result<Answer> add(const SignedIn& by, const NewPersonArguments& a) {
  std::string cohort;
  if (!a.className.empty()) {
    const auto found = classNamed(by, a.className);
    if (!found) return tl::unexpected(found.error());
    cohort = found->id;
  }
  const auto password = a.password.read("A first password for " + a.person.name);
  if (!password) return tl::unexpected(password.error());
  const auto person = PeopleStore(by).add(a.person, *password, cohort);
  if (!person) return tl::unexpected(person.error());
  return toldOf(*person, person->name + " is added as " + nameOf(person->role) +
                             ". The person chooses a new password at the first sign-in.");
}

/// `change` alters the person; `done` ends the sentence that begins with their name.
Result<Answer> change(const SignedIn& by, const std::string& name, const std::function<void(Person&)>& change,
                      const std::string& done) {
  auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  change(*person);
  if (auto changed = PeopleStore(by).change(*person); !changed) return tl::unexpected(changed.error());
  return toldOf(*person, person->name + done);
}

Result<Answer> resetPassword(const SignedIn& by, const std::string& name, const NewPasswordOption& option) {
  const auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  const auto password = option.read("A new password for " + person->name);
  if (!password) return tl::unexpected(password.error());
  if (auto done = PeopleStore(by).resetPassword(person->id, *password); !done) return tl::unexpected(done.error());
  return toldOf(*person, person->name + " can sign in with this password now, and then chooses a new password.");
}

Result<Answer> changeOwnPassword(const StoreOptions& options, const NewPasswordOption& option) {
  const auto store = openStore(options);
  if (!store) return tl::unexpected(store.error());
  const auto old = readOwnPassword(options);
  if (!old) return tl::unexpected(old.error());
  const auto by = store->signIn(options.name, *old);
  if (!by) return tl::unexpected(by.error());
  const auto password = option.read("Your new password");
  if (!password) return tl::unexpected(password.error());
  if (auto done = PeopleStore(*by).changeOwnPassword(*old, *password); !done) return tl::unexpected(done.error());
  return toldOf(by->person(), "Your password is changed.");
}

Result<Answer> exportPerson(const SignedIn& by, const std::string& name, const std::string& file) {
  const auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  const auto counts = PersonData(by).exportTo(person->id, file, terminalProgress());
  if (!counts) return tl::unexpected(counts.error());
  Answer answer = toldOf(*person, "Wrote all data of " + person->name + " to " + file +
                                      " (attempts: " + std::to_string(counts->attempts) +
                                      ", recordings: " + std::to_string(counts->recordings) + ").");
  answer.object.update({{"file", file}, {"attempts", counts->attempts}, {"recordings", counts->recordings}});
  return answer;
}

/// The numbers of what is lost: "recordings (3), ...".
std::string extentWords(const PersonExtent& extent) {
  const auto counted = [](const char* what, std::int64_t count) {
    return std::string(what) + " (" + std::to_string(count) + ")";
  };
  return counted("recordings", extent.recordings) + ", " + counted("comments on attempts", extent.comments) + " and " +
         counted("texts in forms", extent.forms);
}

Result<Answer> erase(const SignedIn& by, const std::string& name, bool isConfirmed) {
  const auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  const auto extent = PersonData(by).previewErasure(person->id);
  if (!extent) return tl::unexpected(extent.error());
  if (!isConfirmed)
    return fail("Nothing was erased. An erasure deletes the names, the e-mail address and the sessions of " +
                person->name + ", " + extentWords(*extent) +
                ", and cannot be undone. Results stay under a pseudonym. Repeat the command with --yes to erase.");
  if (auto done = PersonData(by).erase(person->id); !done) return tl::unexpected(done.error());
  const auto erased = PeopleStore(by).person(person->id);
  if (!erased) return tl::unexpected(erased.error());
  Answer answer = toldOf(*erased, person->name + " is erased, with " + extentWords(*extent) +
                                      ". The results are shown as those of '" + erased->fullName +
                                      "'. Backups that were made before still have the data.");
  answer.object.update({{"attempts", extent->attempts},
                        {"recordings", extent->recordings},
                        {"comments", extent->comments},
                        {"forms", extent->forms}});
  return answer;
}

void addSetUp(CLI::App& curriculum, Outcome& outcome) {
  auto a = std::make_shared<NewPersonArguments>();
  CLI::App* command = addStoreCommand(curriculum, outcome, "setup",
                                      "Make a new store of people and attempts, with its first administrator",
                                      SigningIn::No, [a](const StoreOptions& options) { return setUp(options, *a); });
  addPersonOptions(*command, *a);
}

void addAdd(CLI::App& people, Outcome& outcome) {
  auto a = std::make_shared<NewPersonArguments>();
  CLI::App* command =
      addSignedInCommand(people, outcome, "add", "Add a person", [a](const SignedIn& by) { return add(by, *a); });
  addPersonOptions(*command, *a);
  command->add_option("--role", a->person.role, "Role: trainee (default), instructor or administrator")
      ->transform(CLI::Transformer(kRoles));
  command->add_option("--class", a->className, "Class that the person joins");
}

void addChanges(CLI::App& people, Outcome& outcome) {
  const auto add = [&](const char* verb, const char* about, bool disabled, const char* done) {
    auto name = std::make_shared<std::string>();
    addSignedInCommand(people, outcome, verb, about,
                       [=](const SignedIn& by) {
                         return change(
                             by, *name, [disabled](Person& person) { person.disabled = disabled; }, done);
                       })
        ->add_option("NAME", *name, "Name of the person")
        ->required();
  };
  add("disable", "Prevent a person from signing in; the data of the person are kept", true,
      " can no longer sign in. The data of the person are kept.");
  add("enable", "Let a disabled person sign in again", false, " can sign in again.");
  struct Arguments {
    std::string name;
    Role role = Role::Trainee;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* role = addSignedInCommand(people, outcome, "role", "Set a person's role", [a](const SignedIn& by) {
    return change(
        by, a->name, [a](Person& person) { person.role = a->role; }, std::string(" is now ") + nameOf(a->role) + ".");
  });
  role->add_option("NAME", a->name, "Name of the person")->required();
  role->add_option("ROLE", a->role, "Role: trainee, instructor or administrator")
      ->required()
      ->transform(CLI::Transformer(kRoles));
}

void addExport(CLI::App& people, Outcome& outcome) {
  struct Arguments {
    std::string name, file;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* command = addSignedInCommand(
      people, outcome, "export", "Write all data of a person to a ZIP file (for this person and administrators)",
      [a](const SignedIn& by) { return exportPerson(by, a->name, a->file); });
  command->add_option("--name,NAME", a->name, "Name of the person")->required();
  command->add_option("--out,FILE", a->file, "ZIP file to write")->required()->check(notEmpty());
}

void addErase(CLI::App& people, Outcome& outcome) {
  struct Arguments {
    std::string name;
    bool isConfirmed = false;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* command = addSignedInCommand(people, outcome, "erase",
                                         "Erase a person for ever; results stay under a pseudonym (administrators)",
                                         [a](const SignedIn& by) { return erase(by, a->name, a->isConfirmed); });
  command->add_option("--name,NAME", a->name, "Name of the person")->required();
  command->add_flag("--yes", a->isConfirmed, "Erase; without this flag, the command states what it would delete");
}

void addPasswords(CLI::App& people, Outcome& outcome) {
  auto own = std::make_shared<NewPasswordOption>();
  own->addTo(*addStoreCommand(people, outcome, "password", "Choose your own password", SigningIn::Yes,
                              [own](const StoreOptions& options) { return changeOwnPassword(options, *own); }));
  struct Arguments {
    std::string name;
    NewPasswordOption password;
  };
  auto a = std::make_shared<Arguments>();
  CLI::App* reset = addSignedInCommand(people, outcome, "reset-password",
                                       "Set a new password for a person who forgot the password or is locked out",
                                       [a](const SignedIn& by) { return resetPassword(by, a->name, a->password); });
  reset->add_option("NAME", a->name, "Name of the person")->required();
  a->password.addTo(*reset);
}

}  // namespace

void addPeopleCommands(CLI::App& curriculum, Outcome& outcome) {
  addSetUp(curriculum, outcome);
  CLI::App& people =
      *curriculum.add_subcommand("people", "Manage the accounts of trainees, instructors and administrators");
  people.require_subcommand(1);
  addSignedInCommand(people, outcome, "list", "List all people (administrators)", listPeople);
  addAdd(people, outcome);
  addChanges(people, outcome);
  addPasswords(people, outcome);
  addExport(people, outcome);
  addErase(people, outcome);
}

}  // namespace insonate::cli
