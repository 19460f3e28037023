#include "forms/FormFields.h"

#include "page/Page.h"

#include <insonate/curriculum/AttemptTable.h>

#include <QString>
#include <algorithm>

namespace insonate::web {
namespace {

std::string fieldOf(const FormItem& item) {
  return "answer-" + item.name;
}

std::string noteFieldOf(const FormItem& item) {
  return "note-" + item.name;
}

std::string textIn(const FormAnswers& answers, const std::string& key) {
  const auto answer = answers.find(key);
  if (answer == answers.end()) return {};
  if (const auto* number = std::get_if<double>(&answer->second)) return numberOf(*number);
  return std::get<std::string>(answer->second);
}

Markup choicesOf(const FormItem& item, const std::string& chosen) {
  Markup choices;
  for (const FormOption& option : item.options) {
    Attributes attributes{{"type", "radio"}, {"name", fieldOf(item)}, {"value", option.name}};
    if (option.name == chosen) attributes.emplace_back("checked", "");
    if (item.needed) attributes.emplace_back("required", "");
    choices += element("label", {{"class", "choice"}}, element("input", attributes, "") + text(" " + option.title));
  }
  return element("div", {{"class", "choices"}}, choices);
}

Markup fieldFor(const FormItem& item, const std::string& value) {
  Attributes attributes{{"name", fieldOf(item)}, {"id", fieldOf(item)}};
  if (item.needed) attributes.emplace_back("required", "");
  if (item.kind == FormItem::Kind::Text) {
    attributes.emplace_back("rows", "3");
    return element("textarea", attributes, value);
  }
  attributes.emplace_back("type", "number"), attributes.emplace_back("step", "any");
  attributes.emplace_back("min", numberOf(item.minimum)), attributes.emplace_back("max", numberOf(item.maximum));
  attributes.emplace_back("value", value);
  return element("input", attributes, "");
}

Markup questionOf(const Form& form, const FormItem& item, const FormAnswers& answers,
                  const std::vector<AnswerError>& troubles) {
  const bool isChoice = item.kind == FormItem::Kind::Choice;
  const std::string title = item.needed ? item.title : item.title + " (optional)", value = textIn(answers, item.name);
  Markup content =
      isChoice ? element("legend", {}, title) : element("label", {{"class", "title"}, {"for", fieldOf(item)}}, title);
  if (!item.about.empty()) content += note(item.about);
  for (const AnswerError& one : troubles)
    if (one.item == item.name || one.item == noteKey(item)) content += troubleLine(one.sentence);
  content += isChoice ? choicesOf(item, value) : fieldFor(item, value);
  if (form.acceptsNote(item)) content += optionalField("Note", noteFieldOf(item), "text", noteText(item, answers));
  return element(isChoice ? "fieldset" : "div", {{"class", "question"}}, content);
}

}  // namespace

Markup formFields(const Form& form, const FormAnswers& answers, const std::vector<AnswerError>& troubles) {
  Markup fields;
  for (const FormSection& part : form.sections) {
    fields += element("h3", {}, part.title);
    if (!part.about.empty()) fields += note(part.about);
    for (const FormItem& item : part.items) fields += questionOf(form, item, answers, troubles);
  }
  return fields;
}

FormAnswers answersIn(const Form& form, const Fields& fields) {
  FormAnswers answers;
  for (const FormSection& part : form.sections)
    for (const FormItem& item : part.items) {
      const QString answer = QString::fromStdString(valueOf(fields, fieldOf(item))).trimmed();
      bool isNumber = false;
      const double number = answer.toDouble(&isNumber);
      if (item.kind == FormItem::Kind::Number && isNumber)
        answers.emplace(item.name, number);
      else if (!answer.isEmpty())
        answers.emplace(item.name, answer.toStdString());
      const QString remark = QString::fromStdString(valueOf(fields, noteFieldOf(item))).trimmed();
      if (form.acceptsNote(item) && !remark.isEmpty()) answers.emplace(noteKey(item), remark.toStdString());
    }
  return answers;
}

Markup answersTable(const Form& form, const FormAnswers& answers) {
  std::vector<std::vector<Markup>> rows;
  const bool hasNotes = std::ranges::any_of(answers, [&](const auto& one) { return !form.item(one.first); });
  for (const FormSection& part : form.sections)
    for (const FormItem& item : part.items) {
      const std::string answer = answerText(item, answers);
      if (answer.empty()) continue;
      rows.push_back({text(item.title), element("span", {{"class", "lines"}}, answer)});
      if (hasNotes) rows.back().push_back(text(noteText(item, answers)));
    }
  std::vector<std::string> titles{"Question", "Answer"};
  if (hasNotes) titles.emplace_back("Note");
  return table("Answers", titles, rows);
}

}  // namespace insonate::web
