#include "Answer.h"
#include "FormAnswersFile.h"
#include "Groups.h"
#include "Lookup.h"

#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/FormStore.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace insonate::cli {
namespace {

struct FillArguments {
  std::string form, answers, person, attempt;
};

const char* nameOf(Form::Purpose purpose) {
  switch (purpose) {
    case Form::Purpose::Questionnaire:
      return "questionnaire";
    case Form::Purpose::Checklist:
      return "checklist";
    case Form::Purpose::Debrief:
      return "debrief";
    case Form::Purpose::Rating:
      break;
  }
  return "rating";
}

Result<Answer> listForms() {
  Json rows = Json::array();
  for (const std::string& name : formPresetNames()) {
    const auto form = loadForm(name);
    if (!form) return tl::unexpected(form.error());
    rows.push_back({{"form", form->name},
                    {"form_version", form->version},
                    {"purpose", nameOf(form->purpose)},
                    {"title", form->title}});
  }
  return Answer{{{"forms", rows}}, tableOf(rows, {{"form", "form"}, {"purpose", "purpose"}, {"title", "title"}})};
}

/// Permitted answers of an item.
std::string answersOf(const FormItem& item) {
  if (item.kind == FormItem::Kind::Text) return "text";
  if (item.kind == FormItem::Kind::Number) return Json(item.minimum).dump() + " to " + Json(item.maximum).dump();
  std::string names;
  for (const FormOption& option : item.options) names += (names.empty() ? "" : " | ") + option.name;
  return names;
}

Result<Answer> show(const std::string& nameOrPath) {
  const auto form = loadForm(nameOrPath);
  if (!form) return tl::unexpected(form.error());
  Json rows = Json::array();
  for (const FormSection& section : form->sections)
    for (const FormItem& item : section.items)
      rows.push_back({{"item", item.name},
                      {"section", section.title},
                      {"title", item.title},
                      {"needed", item.needed},
                      {"answers", answersOf(item)}});
  return Answer{
      {{"form", form->name}, {"form_version", form->version}, {"title", form->title}, {"items", rows}},
      form->title + "\n" +
          tableOf(rows, {{"item", "item"}, {"needed", "needed"}, {"answers", "answers"}, {"title", "title"}})};
}

Json scoreJson(const FormScore& score) {
  return {{"points", score.points},
          {"most", score.maxPoints},
          {"percent", orNull(score.percent)},
          {"scored", score.scored},
          {"unscored", score.unscored}};
}

Result<Answer> fill(const SignedIn& by, const FillArguments& a) {
  const auto form = loadForm(a.form);
  if (!form) return tl::unexpected(form.error());
  const auto answers = answersFromFile(*form, a.answers);
  if (!answers) return tl::unexpected(answers.error());
  const auto person = personNamed(by, a.person);
  if (!person) return tl::unexpected(person.error());
  const auto id = FormStore(by).add({.form = form->name,
                                     .formVersion = form->version,
                                     .person = person->id,
                                     .attempt = a.attempt,
                                     .answers = answersText(*answers)});
  if (!id) return tl::unexpected(id.error());
  const FormScore score = formScore(*form, *answers);
  std::string text = "Kept: " + form->title;
  if (score.percent) text += ", " + Json(score.points).dump() + " of " + Json(score.maxPoints).dump() + " points";
  return Answer{{{"id", *id}, {"score", scoreJson(score)}}, text + "."};
}

Json rowOf(const StoredForm& one) {
  const FilledForm& filled = one.filled;
  Json row{{"id", filled.id},
           {"form", filled.form},
           {"form_version", filled.formVersion},
           {"attempt", filled.attempt.empty() ? Json(nullptr) : Json(filled.attempt)},
           {"by", filled.by},
           {"rater", one.rater},
           {"withheld", one.withheld},
           {"filled", timeText(filled.filled_us)},
           {"answers", one.withheld ? Json(nullptr) : Json::parse(filled.answers)},
           {"score", nullptr},
           {"percent", nullptr}};
  const auto form = loadForm(filled.form);
  const auto answers = parseAnswers(filled.answers);
  if (form && answers && form->version == filled.formVersion) {
    const FormScore score = formScore(*form, *answers);
    row["score"] = scoreJson(score), row["percent"] = orNull(score.percent);
  }
  return row;
}

Result<Answer> filled(const SignedIn& by, const std::string& name) {
  const auto person = personNamed(by, name);
  if (!person) return tl::unexpected(person.error());
  const auto forms = FormStore(by).listByPerson(person->id);
  if (!forms) return tl::unexpected(forms.error());
  Json rows = Json::array();
  for (const StoredForm& one : *forms) rows.push_back(rowOf(one));
  return Answer{{{"person", toJson(*person)}, {"forms", rows}},
                rows.empty() ? "No forms yet. 'curriculum forms list' lists the forms that can be filled in."
                             : tableOf(rows, {{"filled", "filled in"},
                                              {"form", "form"},
                                              {"percent", "percent"},
                                              {"attempt", "attempt"},
                                              {"rater", "by"},
                                              {"withheld", "withheld"}})};
}

}  // namespace

void addFormCommands(CLI::App& curriculum, Outcome& outcome) {
  CLI::App& forms = *curriculum.add_subcommand("forms", "Manage questionnaires, checklists and ratings");
  forms.require_subcommand(1);
  addAnsweringCommand(forms, outcome, "list", "List forms that can be filled in", listForms);
  auto name = std::make_shared<std::string>(), person = std::make_shared<std::string>();
  addAnsweringCommand(forms, outcome, "show", "Print a form's items with their permitted answers",
                      [name] { return show(*name); })
      ->add_option("FORM", *name, "Name, or JSON file")
      ->required();
  auto a = std::make_shared<FillArguments>();
  CLI::App* command = addSignedInCommand(forms, outcome, "fill", "Hand in a form, which cannot be changed afterwards",
                                         [a](const SignedIn& by) { return fill(by, *a); });
  command->add_option("FORM", a->form, "Name")->required();
  command
      ->add_option("ANSWERS", a->answers,
                   "JSON file {\"item\": \"answer\", ...}, or .csv with the columns item,answer,note")
      ->required()
      ->check(notEmpty());
  command->add_option("--about", a->person, "Name of the person (default: you)");
  command->add_option("--attempt", a->attempt, "Id of the person's attempt");
  addSignedInCommand(forms, outcome, "filled", "List forms about a person", [person](const SignedIn& by) {
    return filled(by, *person);
  })->add_option("NAME", *person, "Name of the person (default: you)");
  addJudgementCommands(forms, outcome);
}

}  // namespace insonate::cli
