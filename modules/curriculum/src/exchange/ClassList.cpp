#include "store/Texts.h"

#include <insonate/curriculum/ClassList.h>
#include <insonate/curriculum/Csv.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace insonate {
namespace {

using store::nameKey;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::string sentenceOf(int line, const std::string& what) {
  return "Line " + std::to_string(line) + ": " + what;
}

/// Column of each field; empty if there is no such column.
struct Columns {
  std::optional<std::size_t> first, last, full, email, userName, idNumber;
};

/// Titles of columns, as nameKey() writes them, in English, German, French and Spanish exports of Moodle and in usual
/// spreadsheets.
struct Title {
  std::optional<std::size_t> Columns::*field;
  std::vector<std::string_view> words;
};
const std::vector<Title>& knownTitles() {
  static const std::vector<Title> titles{
      {&Columns::first, {"first name", "firstname", "given name", "vorname", "prénom", "prenom", "nombre"}},
      {&Columns::last,
       {"last name", "lastname", "surname", "family name", "nachname", "familienname", "nom", "nom de famille",
        "apellido(s)", "apellidos", "apellido"}},
      {&Columns::full,
       {"full name", "fullname", "name", "vollständiger name", "nom complet", "nombre completo", "nombre y apellidos"}},
      {&Columns::email,
       {"email address", "email", "e-mail", "e-mail address", "mail", "e-mail-adresse", "e-mail adresse",
        "emailadresse", "adresse de courriel", "courriel", "adresse e-mail", "adresse électronique",
        "dirección de correo", "correo electrónico", "correo", "dirección email", "dirección de correo electrónico"}},
      {&Columns::userName,
       {"username", "user name", "anmeldename", "benutzername", "nom d'utilisateur", "nom d’utilisateur", "identifiant",
        "nombre de usuario", "usuario"}},
      {&Columns::idNumber,
       {"id number", "idnumber", "id", "id-nummer", "matrikelnummer", "numéro d'identification",
        "numéro d’identification", "numéro d'étudiant", "numéro d’étudiant", "número de id", "número de identificación",
        "matrícula"}}};
  return titles;
}

Columns columnsOf(const CsvRow& head) {
  Columns columns;
  for (std::size_t i = 0; i < head.fields.size(); ++i)
    for (const Title& title : knownTitles())
      if (std::ranges::find(title.words, nameKey(trimmed(head.fields[i]))) != title.words.end())
        if (auto& field = columns.*title.field; !field) field = i;
  // Beside first names, "Name" is the last name; "Nombre" by itself is the full name.
  if (columns.first && !columns.last) std::swap(columns.last, columns.full);
  if (columns.first && !columns.last && nameKey(trimmed(head.fields[*columns.first])) == "nombre")
    std::swap(columns.first, columns.full);
  return columns;
}

/// Text of an old spreadsheet in Windows-1252, which contains Latin-1, as UTF-8.
std::string fromWindows1252(std::string_view text) {
  // Code points of 0x80 to 0x9F; 0: undefined.
  constexpr std::array<char16_t, 32> kUpper{0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                            0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                            0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                            0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const unsigned code = byte >= 0x80 && byte < 0xA0 ? kUpper[byte - 0x80] : byte;
    if (code < 0x80) {
      utf8 += c;
    } else if (code < 0x800) {
      utf8 += static_cast<char>(0xC0 | code >> 6);
      utf8 += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      utf8 += static_cast<char>(0xE0 | code >> 12);
      utf8 += static_cast<char>(0x80 | (code >> 6 & 0x3F));
      utf8 += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return utf8;
}

std::string fieldOf(const CsvRow& row, std::optional<std::size_t> column) {
  return column && *column < row.fields.size() ? trimmed(row.fields[*column]) : "";
}

NewPerson personOf(const CsvRow& row, const Columns& columns) {
  NewPerson person;
  person.fullName = fieldOf(row, columns.full);
  if (person.fullName.empty())
    person.fullName = trimmed(fieldOf(row, columns.first) + " " + fieldOf(row, columns.last));
  person.email = fieldOf(row, columns.email);
  for (const auto& column : {columns.userName, columns.idNumber, columns.email})
    if (person.name.empty()) person.name = fieldOf(row, column);
  return person;
}

/// Error of a line by itself; empty if there is none.
std::string problemOf(const CsvRow& row, std::size_t columns, const NewPerson& person) {
  if (row.fields.size() > columns)
    return "This line has more fields than the header line. Put fields that contain commas into quotes.";
  if (person.fullName.empty()) return "The name is missing; fill it in.";
  if (person.name.empty())
    return "There is neither user name nor ID number nor e-mail address; one is needed to sign in.";
  for (const auto& fine : {store::checkTitle("The full name", person.fullName), store::checkEmail(person.email),
                           store::checkSignInName(person.name)})
    if (!fine) return fine.error().message;
  return {};
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
      match.troubles.push_back({entry.line, sentenceOf(entry.line, why), entry.person});
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
    if (const Person* person = byMail ? byMail : byName)
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
  auto rows = parseCsv(csv);
  const bool isWide = csv.find('\0') != std::string_view::npos || csv.starts_with("\xFF\xFE");
  if (!rows && !isWide && !store::checkText("The list", csv, csv.size())) rows = parseCsv(fromWindows1252(csv));
  if (!rows) return tl::unexpected(rows.error());
  if (rows->empty()) return fail("The class list is empty; its first line names the columns.");
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
    const NewPerson person = personOf(row, columns);
    std::string trouble = problemOf(row, rows->front().fields.size(), person);
    for (const std::string& key : {"name " + nameKey(person.name), "mail " + nameKey(person.email)}) {
      if (!trouble.empty() || key == "mail ") continue;
      if (const auto [twin, isNew] = lines.emplace(key, row.line); !isNew && twin->second != row.line)
        trouble = "This is the same person as in line " + std::to_string(twin->second) + "; leave one out.";
    }
    if (trouble.empty())
      list.entries.push_back({row.line, person});
    else
      list.troubles.push_back({row.line, sentenceOf(row.line, trouble), person});
  }
  return list;
}

ClassListMatch matchClassList(const ClassList& list, std::span<const Person> people) {
  ClassListMatch match;
  match.troubles = list.troubles;
  const Directory directory(people);
  for (const ClassListEntry& entry : list.entries) directory.sort(entry, match);
  std::ranges::stable_sort(match.troubles, {}, &ClassListTrouble::line);
  return match;
}

}  // namespace insonate
