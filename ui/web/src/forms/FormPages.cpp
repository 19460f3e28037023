#include "forms/FormPages.h"

#include "forms/FormFields.h"
#include "video/VideoPage.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PeopleStore.h>

#include <QUuid>
#include <algorithm>
#include <cmath>

namespace insonate::web {
namespace {

/// Answers that the page shows, with what is wrong with them.
struct Draft {
  std::string id{};  ///< id of the filled form, so that a second click hands in nothing twice
  FormAnswers answers{};
  std::vector<AnswerError> troubles{};
  std::string refused{};  ///< why the store refuses the form

  bool isRefused() const { return !troubles.empty() || !refused.empty(); }
};

Draft newDraft() {
  return {.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString()};
}

/// A built-in form; a name from an address must not open a file.
std::optional<Form> formNamed(const std::string& name) {
  const auto names = formPresetNames();
  if (std::ranges::find(names, name) == names.end()) return std::nullopt;
  auto form = loadForm(name);
  return form ? std::optional(std::move(*form)) : std::nullopt;
}

std::vector<Form> formsFor(bool questionnaires) {
  std::vector<Form> forms;
  for (const std::string& name : formPresetNames())
    if (auto form = formNamed(name); form && questionnaires == (form->purpose == Form::Purpose::Questionnaire))
      forms.push_back(std::move(*form));
  return forms;
}

bool mayFillIn(const Visit& visit, const Form& form, const AttemptFacts& attempt) {
  if (attempt.state == AttemptState::Open || form.purpose == Form::Purpose::Questionnaire) return false;
  const Person& by = visit.by->person();
  return by.id == attempt.person ? form.purpose == Form::Purpose::Debrief : by.role != Role::Trainee;
}

bool hasHandedIn(const Visit& visit, const std::vector<StoredForm>& filled, const std::string& form) {
  return std::ranges::any_of(
      filled, [&](const StoredForm& one) { return one.filled.form == form && one.filled.by == visit.by->person().id; });
}

std::string scoreWords(const Form& form, const FormAnswers& answers) {
  const FormScore score = formScore(form, answers);
  if (!score.percent) return {};
  return ", " + std::to_string(std::lround(*score.percent)) + " % (" + numberOf(score.points) + " of " +
         numberOf(score.maxPoints) + " points)";
}

/// `about`: words about the attempt that the form judges; empty where the page shows the attempt. Then the answers are
/// shown on a click, otherwise at once.
Markup filledForm(const StoredForm& one, const Markup& about) {
  const auto form = formNamed(one.filled.form);
  const auto answers = parseAnswers(one.filled.answers);
  // A form of a later version may have other questions under the same names.
  const bool isKnown = form && form->version == one.filled.formVersion && answers;
  Markup head = text((form ? form->title : one.filled.form) + ", " + one.rater + ", ") + timeOf(one.filled.filled_us);
  if (isKnown && !one.withheld) head += text(scoreWords(*form, *answers));
  const Markup content = one.withheld ? note("You can read these answers after you have handed in the same form.")
                         : isKnown    ? answersTable(*form, *answers)
                                   : note("This server has another version of this form, and cannot show the answers.");
  return element("details", about.empty() ? Attributes{} : Attributes{{"open", ""}},
                 element("summary", {}, head) + about + content);
}

std::string addressOf(const std::string& attempt, const std::string& form, const std::string& query) {
  return "/attempts/" + encoded(attempt) + "/forms/" + encoded(form) + query;
}

std::string queryOf(const Visit& visit) {
  const std::string& cohort = valueOf(visit.request.query, "class");
  return cohort.empty() ? "" : "?class=" + encoded(cohort);
}

Markup formOf(const Visit& visit, const Form& form, const std::string& address, const Draft& draft) {
  Markup fields = hiddenField("id", draft.id);
  if (!draft.refused.empty()) fields += troubleLine(draft.refused);
  if (!draft.troubles.empty()) fields += troubleLine("Some answers cannot be stored. Correct the marked questions.");
  fields += formFields(form, draft.answers, draft.troubles) +
            note("After you hand in the form, you cannot change the answers.");
  return postForm(visit, address, fields, "Hand in");
}

/// Data of the page of a form about an attempt.
struct Subject {
  Form form;
  StoredAttempt attempt;
  Person person;
};

tl::expected<Subject, Response> subjectOf(const Visit& visit, const Parts& parts) {
  auto kept = AttemptStore(*visit.by).attempt(parts[0]);
  if (!kept) return tl::unexpected(refusal(visit, 404, kept.error().message));
  auto form = formNamed(parts[1]);
  if (!form || form->purpose == Form::Purpose::Questionnaire)
    return tl::unexpected(refusal(visit, 404, "There is no such form for attempts."));
  if (!mayFillIn(visit, *form, kept->facts))
    return tl::unexpected(
        refusal(visit, 403,
                "You cannot fill in this form about this attempt. Only instructors fill in checklists and ratings, "
                "after an attempt has ended, and not about their own attempts."));
  auto person = PeopleStore(*visit.by).person(kept->facts.person);
  if (!person) return tl::unexpected(refusal(visit, 403, person.error().message));
  return Subject{std::move(*form), std::move(*kept), std::move(*person)};
}

Response attemptFormPage(const Visit& visit, const Subject& subject, const Draft& draft) {
  const std::string query = queryOf(visit), &id = subject.attempt.facts.id;
  const auto video = videoSection(visit, subject.attempt, query);
  if (!video) return refusal(visit, 403, video.error().message);
  const Markup back = element("p", {}, link("/attempts/" + encoded(id) + query, "Back to the attempt"));
  const Markup about = element("p", {{"class", "quiet"}},
                               text("Attempt of " + displayName(subject.person) + ", ") +
                                   timeOf(subject.attempt.facts.begun_us) + text(". " + subject.form.about));
  const bool isProposed = !answersFrom(subject.form, subject.attempt.facts.metrics).empty();
  const Markup proposal =
      isProposed ? note("Where the recording shows the answer, the answer is already filled in. Check each one.")
                 : Markup();
  const Markup questions =
      element("section", {}, proposal + formOf(visit, subject.form, addressOf(id, subject.form.name, query), draft));
  Response response =
      page(visit, subject.form.title,
           back + about + element("div", {{"class", video->empty() ? "" : "beside"}}, *video + questions),
           draft.isRefused() ? 400 : 200);
  if (!video->empty()) response.headers.push_back(kVideoPolicy);
  return response;
}

FilledForm filledBy(const Visit& visit, const Form& form, const Draft& draft) {
  FilledForm filled;
  filled.id = draft.id, filled.form = form.name, filled.formVersion = form.version;
  filled.person = visit.by->person().id, filled.answers = answersText(draft.answers);
  return filled;
}

Draft draftIn(const Visit& visit, const Form& form) {
  Draft draft{.id = valueOf(visit.request.form, "id"), .answers = answersIn(form, visit.request.form)};
  draft.troubles = checkAnswers(form, draft.answers);
  return draft;
}

/// Stores the form, unless its answers cannot be stored; the draft then says why.
void handIn(const Visit& visit, const FilledForm& filled, Draft& draft) {
  if (draft.isRefused()) return;
  if (const auto kept = FormStore(*visit.by).add(filled); !kept) draft.refused = kept.error().message;
}

Response questionnairePage(const Visit& visit, const Form& form, const Draft& draft) {
  return page(visit, form.title, note(form.about) + formOf(visit, form, "/me/forms/" + encoded(form.name), draft),
              draft.isRefused() ? 400 : 200);
}

std::optional<Form> questionnaireNamed(const std::string& name) {
  auto form = formNamed(name);
  return form && form->purpose == Form::Purpose::Questionnaire ? form : std::nullopt;
}

constexpr const char* kNoQuestionnaire = "There is no such questionnaire.";

}  // namespace

Result<Markup> formSection(const Visit& visit, const AttemptFacts& attempt, const std::string& query) {
  const auto filled = FormStore(*visit.by).listByAttempt(attempt.id);
  if (!filled) return tl::unexpected(filled.error());
  Markup content, links;
  for (const StoredForm& one : *filled) content += filledForm(one, {});
  for (const Form& form : formsFor(false))
    if (mayFillIn(visit, form, attempt) && !hasHandedIn(visit, *filled, form.name))
      links += element("li", {}, link(addressOf(attempt.id, form.name, query), "Fill in: " + form.title));
  if (content.empty() && links.empty()) return Markup();
  if (!links.empty()) content += element("ul", {}, links);
  return section("Debrief, checklists and ratings", content);
}

Result<Markup> judgementSection(const Visit& visit, const std::string& person,
                                const std::function<Markup(const std::string& attempt)>& describe) {
  const auto filled = FormStore(*visit.by).listByPerson(person);
  if (!filled) return tl::unexpected(filled.error());
  Markup content;
  for (const StoredForm& one : *filled)
    if (const auto form = formNamed(one.filled.form); form ? form->isJudgement() : one.filled.by != person)
      content += filledForm(one, describe(one.filled.attempt));
  return section("Checklists and ratings", content.empty() ? paragraph("None yet.") : content);
}

Result<Markup> questionnaireSection(const Visit& visit) {
  const auto filled = FormStore(*visit.by).listByPerson(visit.by->person().id);
  if (!filled) return tl::unexpected(filled.error());
  Markup items;
  for (const Form& form : formsFor(true)) {
    Markup item = link("/me/forms/" + encoded(form.name), form.title);
    const auto last = std::find_if(filled->rbegin(), filled->rend(),
                                   [&](const StoredForm& one) { return one.filled.form == form.name; });
    if (last != filled->rend()) item += text(" Handed in ") + timeOf(last->filled.filled_us) + text(".");
    items += element("li", {}, item);
  }
  return items.empty() ? Markup() : section("Questionnaires", element("ul", {}, items));
}

Response showAttemptForm(const Visit& visit, const Parts& parts) {
  const auto subject = subjectOf(visit, parts);
  if (!subject) return subject.error();
  Draft draft = newDraft();
  draft.answers = answersFrom(subject->form, subject->attempt.facts.metrics);
  return attemptFormPage(visit, *subject, draft);
}

Response handInAttemptForm(const Visit& visit, const Parts& parts) {
  const auto subject = subjectOf(visit, parts);
  if (!subject) return subject.error();
  Draft draft = draftIn(visit, subject->form);
  FilledForm filled = filledBy(visit, subject->form, draft);
  filled.person = subject->person.id, filled.attempt = subject->attempt.facts.id;
  handIn(visit, filled, draft);
  return draft.isRefused() ? attemptFormPage(visit, *subject, draft)
                           : redirect("/attempts/" + encoded(parts[0]) + queryOf(visit));
}

Response showQuestionnaire(const Visit& visit, const Parts& parts) {
  const auto form = questionnaireNamed(parts[0]);
  return form ? questionnairePage(visit, *form, newDraft()) : refusal(visit, 404, kNoQuestionnaire);
}

Response handInQuestionnaire(const Visit& visit, const Parts& parts) {
  const auto form = questionnaireNamed(parts[0]);
  if (!form) return refusal(visit, 404, kNoQuestionnaire);
  Draft draft = draftIn(visit, *form);
  handIn(visit, filledBy(visit, *form, draft), draft);
  return draft.isRefused() ? questionnairePage(visit, *form, draft) : redirect("/me");
}

}  // namespace insonate::web
