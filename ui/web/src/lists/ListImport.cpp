#include "lists/ListImport.h"

#include "classes/TaughtClass.h"
#include "lists/RecentImports.h"

#include <insonate/curriculum/ClassImport.h>

#include <QByteArray>
#include <QCryptographicHash>
#include <QUuid>
#include <algorithm>

namespace insonate::web {
namespace {

using Step = ClassImportRow::Step;

constexpr std::size_t kLargestList_bytes = 128 << 10;
/// A password takes 0.1 s, and proxies wait for an answer for a minute.
constexpr std::ptrdiff_t kMostNewPeople = 300;

std::string importAddress(const TaughtClass& taught) {
  return "/classes/" + encoded(taught.cohort.id) + "/import";
}

Markup backToMembers(const TaughtClass& taught) {
  return element("p", {}, link("/classes/" + encoded(taught.cohort.id) + "/members", "Members and settings"));
}

std::ptrdiff_t countOf(const std::vector<ClassImportRow>& plan, Step step) {
  return std::ranges::count(plan, step, &ClassImportRow::step);
}

/// Without a file, the pasted text.
const std::string& sentList(const Visit& visit) {
  const std::string& file = valueOf(visit.request.files, "list");
  return file.empty() ? valueOf(visit.request.form, "text") : file;
}

Response listPage(const Visit& visit, const TaughtClass& taught, const std::string& trouble) {
  const Markup file = element(
      "label", {},
      text("File (CSV)") +
          element("input", {{"type", "file"}, {"name", "list"}, {"accept", ".csv,.txt,.tsv,text/csv,text/plain"}}));
  const Markup pasted = element("label", {},
                                text("Or paste the list") + element("textarea", {{"name", "text"}, {"rows", "8"}},
                                                                    valueOf(visit.request.form, "text")));
  return page(
      visit, "Import a list into " + taught.cohort.name,
      (trouble.empty() ? Markup() : troubleLine(trouble)) +
          paragraph("The list is a table (CSV) that was saved by Moodle or a spreadsheet program. Its first line names "
                    "the columns: Full name, or First name and Last name; Username, ID number or Email address. The "
                    "column names may also be German, French or Spanish. Each further line describes one trainee.") +
          note("The next page shows the effect of each line. Nothing changes until you confirm the import there.") +
          fileForm(visit, importAddress(taught), file + pasted, "Check the list") + backToMembers(taught),
      trouble.empty() ? 200 : 422);
}

Result<std::vector<ClassImportRow>> planOf(const Visit& visit, const TaughtClass& taught, const std::string& list) {
  if (list.empty()) return fail("No list was chosen. Choose a file, or paste a list.");
  if (list.size() > kLargestList_bytes)
    return fail("The list is larger than 128 KB. Split it, or import it with insonate-cli curriculum classes import.");
  const auto parsed = parseClassList(list);
  if (!parsed) return tl::unexpected(parsed.error());
  auto plan = ClassImport(*visit.by).plan(taught.cohort.id, *parsed);
  if (!plan) return plan;
  if (plan->empty())
    return fail("The list has a line with column names, but no trainees. Add a line for each trainee.");
  if (countOf(*plan, Step::Add) > kMostNewPeople)
    return fail(
        "The list has more than 300 new people. Split it, or import it with insonate-cli curriculum classes "
        "import.");
  return plan;
}

std::string hashOf(const std::vector<std::string>& parts) {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  for (const std::string& part : parts) hash.addData(part.c_str(), static_cast<int>(part.size()) + 1);
  return hash.result().toHex().toStdString();
}

/// Identifies what a plan does, so that what is done is what was shown.
std::string fingerprintOf(const std::vector<ClassImportRow>& plan) {
  std::vector<std::string> parts;
  for (const ClassImportRow& row : plan)
    for (const std::string& part : {std::to_string(row.line), std::to_string(static_cast<int>(row.step)),
                                    row.person.name, row.person.fullName, row.person.email, row.id})
      parts.push_back(part);
  return hashOf(parts);
}

/// Identifies a page of a check in a session.
std::string pageKeyOf(const Visit& visit, const TaughtClass& taught) {
  const Fields& form = visit.request.form;
  return hashOf(
      {visit.secret, taught.cohort.id, valueOf(form, "import"), valueOf(form, "plan"), valueOf(form, "list")});
}

/// The number of the line is in another column.
std::string reasonOf(const ClassImportRow& row) {
  const std::string line = "Line " + std::to_string(row.line) + ": ";
  return row.why.starts_with(line) ? row.why.substr(line.size()) : row.why;
}

Markup planOutcome(const ClassImportRow& row) {
  switch (row.step) {
    case Step::Add:
      return text("+ new account, joins the class");
    case Step::Join:
      return text("+ has an account, joins the class");
    case Step::AlreadyThere:
      return text("\u2713 already in the class: ") + link("/people/" + encoded(row.id), "account");
    case Step::Refuse:
      break;
  }
  return element("span", {{"class", "trouble"}}, "\u25B2 left out: " + reasonOf(row));
}

Markup planTable(const std::vector<ClassImportRow>& plan) {
  std::vector<std::vector<Markup>> rows;
  for (const ClassImportRow& row : plan)
    rows.push_back({text(std::to_string(row.line)), text(row.person.fullName), text(row.person.name),
                    text(row.person.email), planOutcome(row)});
  return table("Effect of each line of the list", {"Line", "Full name", "Sign-in name", "E-mail", "Effect"}, rows);
}

std::string planSummary(const std::vector<ClassImportRow>& plan) {
  return "New accounts: " + std::to_string(countOf(plan, Step::Add)) +
         ". People with an account who join the class: " + std::to_string(countOf(plan, Step::Join)) +
         ". Already in the class: " + std::to_string(countOf(plan, Step::AlreadyThere)) +
         ". Left out: " + std::to_string(countOf(plan, Step::Refuse)) + ".";
}

Response planPage(const Visit& visit, const TaughtClass& taught, const std::vector<ClassImportRow>& plan,
                  const std::string& list, const std::string& trouble) {
  Markup content = trouble.empty() ? Markup() : troubleLine(trouble);
  content += paragraph(planSummary(plan)) + planTable(plan);
  const auto refused = countOf(plan, Step::Refuse);
  if (refused == std::ssize(plan)) {
    content += paragraph("Every line has an error. Correct the list and check it again.");
  } else if (countOf(plan, Step::Add) + countOf(plan, Step::Join) == 0) {
    content += paragraph("The list has no people to add to the class.");
  } else {
    if (refused > 0)
      content +=
          note("Lines with errors are left out. Correct them and check the list again, now or after this import.");
    const QByteArray bytes(list.data(), static_cast<int>(list.size()));
    content += postForm(visit, importAddress(taught) + "/confirm",
                        hiddenField("list", bytes.toBase64().toStdString()) + hiddenField("plan", fingerprintOf(plan)) +
                            hiddenField("import", QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString()),
                        "Import");
  }
  return page(visit, "Preview of the import into " + taught.cohort.name,
              content + element("p", {}, link(importAddress(taught), "Choose another list")) + backToMembers(taught),
              trouble.empty() ? 200 : 409);
}

Response donePage(const Visit& visit, const TaughtClass& taught, const std::vector<ClassImportRow>& plan,
                  const std::vector<FirstPassword>& passwords) {
  Markup content = paragraph(planSummary(plan));
  std::vector<std::vector<Markup>> rows;
  for (const auto& [person, password] : passwords)
    rows.push_back({text(person.fullName), text(person.name), element("code", {{"class", "token"}}, password)});
  if (!rows.empty())
    content += paragraph(
                   "Print this page, or copy the passwords: they cannot be shown again. Give each person the "
                   "password; the person chooses another one at the first sign-in.") +
               table("First passwords", {"Full name", "Sign-in name", "First password"}, rows);
  Markup reasons;
  for (const ClassImportRow& row : plan)
    if (row.step == Step::Refuse) reasons += element("li", {}, row.why);
  if (!reasons.empty()) content += section("Left out", element("ul", {}, reasons));
  return page(visit, "List imported into " + taught.cohort.name, content + backToMembers(taught));
}

Response changedPlanPage(const Visit& visit, const TaughtClass& taught, const std::vector<ClassImportRow>& plan,
                         const std::string& list) {
  return planPage(visit, taught, plan, list,
                  "Nothing was imported. Since you checked the list, it was imported already, or people or classes "
                  "have changed. Check the lines again. If the list was imported already, its people are in the class, "
                  "and their first passwords cannot be shown again. Set a new password on the page of each account.");
}

Response importPlan(const Visit& visit, const TaughtClass& taught) {
  const Fields& form = visit.request.form;
  const std::string list = QByteArray::fromBase64(QByteArray::fromStdString(valueOf(form, "list"))).toStdString();
  const auto plan = planOf(visit, taught, list);
  if (!plan) return listPage(visit, taught, plan.error().message);
  if (fingerprintOf(*plan) != valueOf(form, "plan")) return changedPlanPage(visit, taught, *plan, list);
  const auto passwords = ClassImport::passwordsFor(*plan);
  const auto done = ClassImport(*visit.by).apply(taught.cohort.id, *plan, passwords);
  if (done) return donePage(visit, taught, *plan, passwords);
  // Another server may have imported the list meanwhile.
  const auto now = planOf(visit, taught, list);
  if (now && fingerprintOf(*now) != fingerprintOf(*plan)) return changedPlanPage(visit, taught, *now, list);
  return listPage(visit, taught, done.error().message);
}

}  // namespace

Response showListImport(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto permitted = ClassImport(*visit.by).plan(taught.cohort.id, {});
    return permitted ? listPage(visit, taught, {}) : refusal(visit, 403, permitted.error().message);
  });
}

Response checkList(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const std::string& list = sentList(visit);
    const auto plan = planOf(visit, taught, list);
    return plan ? planPage(visit, taught, *plan, list, {}) : listPage(visit, taught, plan.error().message);
  });
}

Response importList(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    return visit.imports.answer(pageKeyOf(visit, taught), visit.by->now_us(),
                                [&] { return importPlan(visit, taught); });
  });
}

}  // namespace insonate::web
