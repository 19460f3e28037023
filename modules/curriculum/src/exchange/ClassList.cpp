#include "store/Texts.h"

#include <insonate/curriculum/ClassList.h>
#include <insonate/curriculum/Csv.h>

#include <QTextCodec>
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace insonate {
namespace {

using store::nameKey;

/// A text without surrounding blanks, also no-break spaces.
std::string trimmed(std::string_view text) {
  return QString::fromUtf8(text.data(), int(text.size())).trimmed().toStdString();
}

std::string findingText(int line, const std::string& what) {
  return "Line " + std::to_string(line) + ": " + what;
}

/// Column of each field; empty if there is no such column.
struct Columns {
  std::optional<std::size_t> first, last, secondLast, full, email, userName, idNumber;
};

/// Titles of columns, as nameKey() writes them, in English, German, French and Spanish exports of Moodle and in usual
/// spreadsheets.
struct Title {
  std::optional<std::size_t> Columns::*field;
  std::vector<std::string_view> words;
};
const std::vector<Title>& knownTitles() {
  static const std::vector<Title> titles{
      {&Columns::first,
       {"first name", "firstname", "given name", "vorname", "prénom", "prenom", "prénoms", "nombre", "nombre(s)",
        "nombres"}},
      {&Columns::last,
       {"last name", "lastname", "surname", "family name", "nachname", "familienname", "nom", "nom de famille",
        "apellido(s)", "apellidos", "apellido", "primer apellido"}},
      {&Columns::secondLast, {"segundo apellido"}},
      {&Columns::full,
       {"full name", "fullname", "name", "vollständiger name", "nom complet", "nombre completo", "nombre y apellidos"}},
      {&Columns::email,
       {"email address", "email", "e-mail", "e-mail address", "mail", "e-mail-adresse", "e-mail adresse",
        "emailadresse", "mailadresse", "adresse mail", "adresse de courriel", "courriel", "adresse e-mail",
        "adresse électronique", "dirección de correo", "correo electrónico", "correo", "dirección email",
        "dirección de correo electrónico"}},
      {&Columns::userName,
       {"username", "user name", "anmeldename", "benutzername", "nom d'utilisateur", "nom d’utilisateur", "identifiant",
        "nombre de usuario", "usuario"}},
      {&Columns::idNumber,
       {"id number", "idnumber", "id", "id-nummer", "matrikelnummer", "numéro d'identification",
        "numéro d’identification", "numéro d'étudiant", "numéro d’étudiant", "número de id", "número de identificación",
        "matrícula"}}};
  return titles;
}

/// A title without case, surrounding blanks (also no-break spaces) and a colon.
std::string titleOf(const std::string& field) {
  std::string title = trimmed(nameKey(field));
  if (title.ends_with(':')) title = trimmed(title.substr(0, title.size() - 1));
  return title;
}

using Field = std::optional<std::size_t> Columns::*;

bool hasTitle(const CsvRow& head, std::string_view word) {
  return std::ranges::any_of(head.fields, [&](const std::string& field) { return titleOf(field) == word; });
}
bool hasColumnOf(const CsvRow& head, Field field) {
  const Title& known = *std::ranges::find(knownTitles(), field, &Title::field);
  return std::ranges::any_of(known.words, [&](std::string_view word) { return hasTitle(head, word); });
}

/// Field that a column with this title has; null if the column is not read.
Field fieldTitled(const CsvRow& head, const std::string& title) {
  const std::string words = titleOf(title);
  // Moodle's list of all users has both; "id" is the number of the row in its database.
  if (words == "id" && (hasTitle(head, "idnumber") || hasTitle(head, "id number"))) return nullptr;
  // Beside first names, "Name" is the last name.
  if (words == "name" && hasColumnOf(head, &Columns::first) && !hasColumnOf(head, &Columns::last))
    return &Columns::last;
  for (const Title& known : knownTitles())
    if (std::ranges::find(known.words, words) != known.words.end()) return known.field;
  return nullptr;
}

/// Fails if two columns have the same content, whether they have one title or two.
Result<void> checkTitles(const CsvRow& head) {
  std::vector<std::pair<Field, std::string>> found;
  for (const std::string& title : head.fields) {
    const Field field = fieldTitled(head, title);
    if (!field) continue;
    const auto first = std::ranges::find(found, field, &std::pair<Field, std::string>::first);
    if (first == found.end()) {
      found.emplace_back(field, title);
      continue;
    }
    if (titleOf(first->second) == titleOf(title))
      return fail("The class list has two columns with the title \"" + trimmed(title) +
                  "\". Delete one of them or give it another title.");
    return fail("The columns \"" + trimmed(first->second) + "\" and \"" + trimmed(title) +
                "\" of the class list have the same meaning. Delete one of them or give it another title.");
  }
  return {};
}

Columns columnsOf(const CsvRow& head) {
  Columns columns;
  for (std::size_t i = 0; i < head.fields.size(); ++i)
    if (const Field field = fieldTitled(head, head.fields[i])) columns.*field = i;
  const auto is = [&](const std::optional<std::size_t>& column, std::string_view title) {
    return column && titleOf(head.fields[*column]) == title;
  };
  // "Nombre" or "Nom" by itself is the full name.
  if (!columns.full && !columns.last && is(columns.first, "nombre")) std::swap(columns.first, columns.full);
  if (!columns.full && !columns.first && is(columns.last, "nom")) std::swap(columns.last, columns.full);
  return columns;
}

/// Number of the first line that is not UTF-8; 0 if there is none. `hasUtf8` tells whether another line has UTF-8
/// letters.
int lineOutsideUtf8(std::string_view text, bool& hasUtf8) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  hasUtf8 = text.starts_with(kByteOrderMark);
  if (hasUtf8) text.remove_prefix(kByteOrderMark.size());
  int first = 0;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (std::ranges::none_of(line, [](char c) { return (c & 0x80) != 0; })) continue;
    if (store::checkText("The line", line, line.size()))
      hasUtf8 = true;
    else if (first == 0)
      first = number;
  }
  return first;
}

/// Text of an old spreadsheet in Windows-1252, which contains Latin-1, as UTF-8.
std::string fromWindows1252(std::string_view text) {
  return QTextCodec::codecForName("windows-1252")->toUnicode(text.data(), int(text.size())).toStdString();
}

std::string fieldOf(const CsvRow& row, std::optional<std::size_t> column) {
  return column && *column < row.fields.size() ? trimmed(row.fields[*column]) : "";
}

NewPerson personOf(const CsvRow& row, const Columns& columns) {
  NewPerson person;
  person.fullName = fieldOf(row, columns.full);
  if (person.fullName.empty())
    person.fullName = trimmed(fieldOf(row, columns.first) + " " + fieldOf(row, columns.last) + " " +
                              fieldOf(row, columns.secondLast));
  person.email = fieldOf(row, columns.email);
  for (const auto& column : {columns.userName, columns.idNumber, columns.email})
    if (person.name.empty()) person.name = fieldOf(row, column);
  return person;
}

/// Error of a line by itself; empty if there is none.
std::string problemOf(const CsvRow& row, std::size_t columns, const NewPerson& person) {
  const auto isFilled = [](const std::string& field) { return !trimmed(field).empty(); };
  if (row.fields.size() > columns &&
      std::any_of(row.fields.begin() + std::ptrdiff_t(columns), row.fields.end(), isFilled))
    return "This line has more fields than the header line. Put fields that contain the separator into quotes.";
  if (person.fullName.empty()) return "The name is missing; fill it in.";
  if (person.name.empty())
    return "There is neither user name nor ID number nor e-mail address; one is needed to sign in.";
  for (const auto& fine : {store::checkTitle("The full name", person.fullName), store::checkEmail(person.email)})
    if (!fine) return fine.error().message;
  if (const auto fine = store::checkSignInName(person.name); !fine)
    return person.name == person.email
               ? "The e-mail address cannot be a sign-in name; add a column \"Username\" with another name."
               : fine.error().message;
  return {};
}

/// Tells whether two full names may be of one person: "A. Lovelace" and "Ada Lovelace", but not "Zoe Anders".
bool haveAWordInCommon(const std::string& a, const std::string& b) {
  const auto displayText = [](const std::string& name) {
    std::istringstream stream(nameKey(name));
    return std::set<std::string>(std::istream_iterator<std::string>(stream), {});
  };
  const std::set<std::string> words = displayText(a);
  return std::ranges::any_of(displayText(b), [&](const std::string& word) { return words.contains(word); });
}

/// People by e-mail address and by name, ignoring case.
class Directory {
 public:
  explicit Directory(std::span<const Person> people) {
    for (const Person& person : people) {
      if (!person.email.empty()) byEmail_.emplace(nameKey(person.email), &person);
      byName_.emplace(nameKey(person.name), &person);
    }
  }

  /// Sorts an entry into the groups of the result.
  void sort(const ClassListEntry& entry, ClassListMatch& match) const {
    const auto refuse = [&](const std::string& why) {
      match.errors.push_back({entry.line, findingText(entry.line, why), entry.person});
    };
    const std::string email = nameKey(entry.person.email);
    if (byEmail_.count(email) > 1)
      return refuse("Several people have this e-mail address already. Correct their addresses first.");
    const auto mail = byEmail_.find(email);
    const auto name = byName_.find(nameKey(entry.person.name));
    const Person* byMail = mail == byEmail_.end() ? nullptr : mail->second;
    const Person* byName = name == byName_.end() ? nullptr : name->second;
    if (byMail && byName && byMail != byName)
      return refuse("This is the e-mail address of " + byMail->fullName + ", but the name '" + byName->name + "' of " +
                    byName->fullName + "; correct one of them.");
    if (!byMail && byName && !email.empty() && !byName->email.empty())
      return refuse("This is the name '" + byName->name + "' of " + byName->fullName +
                    ", who has another e-mail address; correct one of them.");
    const Person* person = byMail ? byMail : byName;
    if (person && !haveAWordInCommon(person->fullName, entry.person.fullName))
      return refuse("This is the " + std::string(byMail ? "e-mail address" : "sign-in name") + " of " +
                    person->fullName + ", but the list says " + entry.person.fullName + "; correct one of them.");
    if (person)
      match.known.push_back({entry, *person});
    else
      match.added.push_back(entry);
  }

 private:
  std::multimap<std::string, const Person*> byEmail_;
  std::map<std::string, const Person*> byName_;
};

}  // namespace

Result<ClassList> parseClassList(std::string_view csv) {
  const bool isUtf16 = csv.starts_with("\xFF\xFE") || csv.starts_with("\xFE\xFF");
  if (csv.find('\0') != std::string_view::npos && !isUtf16)
    return fail("The file is no table in text: save it as \"CSV UTF-8\".");
  bool hasUtf8 = false;
  const int foreign = lineOutsideUtf8(csv, hasUtf8);
  if (foreign > 0 && hasUtf8)
    return fail("Line " + std::to_string(foreign) +
                " is not UTF-8, although other lines are; save the list again as \"CSV UTF-8\".");
  const auto rows = foreign > 0 && !isUtf16 ? parseCsv(fromWindows1252(csv)) : parseCsv(csv);
  if (!rows) return tl::unexpected(rows.error());
  if (rows->empty()) return fail("The class list is empty; its first line names the columns.");
  if (const auto titles = checkTitles(rows->front()); !titles) return tl::unexpected(titles.error());
  const Columns columns = columnsOf(rows->front());
  if (!columns.full && !(columns.first && columns.last))
    return fail(
        "The class list has no names: its first line needs \"First name\" and \"Last name\", or \"Full name\".");
  if (!columns.email && !columns.userName && !columns.idNumber)
    return fail(
        "The class list has no column that identifies people. Its first line needs \"Email address\", \"Username\" "
        "or \"ID number\".");
  ClassList list;
  std::map<std::string, int> lines;
  for (const CsvRow& row : std::span(*rows).subspan(1)) {
    if (std::ranges::all_of(row.fields, [](const std::string& field) { return trimmed(field).empty(); })) continue;
    const NewPerson person = personOf(row, columns);
    std::string error = problemOf(row, rows->front().fields.size(), person);
    for (const std::string& key : {"name " + nameKey(person.name), "mail " + nameKey(person.email)}) {
      if (!error.empty() || key == "mail ") continue;
      if (const auto [twin, isNew] = lines.emplace(key, row.line); !isNew && twin->second != row.line)
        error = "This person is the same as in line " + std::to_string(twin->second) + "; delete one of the two lines.";
    }
    if (error.empty())
      list.entries.push_back({row.line, person});
    else
      list.errors.push_back({row.line, findingText(row.line, error), person});
  }
  return list;
}

ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people) {
  ClassListMatch match;
  match.errors = list.errors;
  const Directory directory(people);
  for (const ClassListEntry& entry : list.entries) directory.sort(entry, match);
  std::ranges::stable_sort(match.errors, {}, &ClassListError::line);
  return match;
}

}  // namespace insonate
